#include "controls.hpp"
#include "motorbike.hpp"

using namespace dynamy;

static void registerElements(Registry& r) {
  r.add<motorbike::Motorbike>("Motorbike");
  r.add<motorbike::WheelBrake>("WheelBrake");
  r.add<motorbike::RiderSteering>("RiderSteering");
}

DYNAMY_PLUGIN("motorbike", "1.0.0", registerElements)
