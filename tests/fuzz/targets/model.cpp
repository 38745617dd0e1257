/// Model text with the standard elements: any text gives a model that is built and evaluated at its
/// start, or errors of which each has its place.
#include <dynamy/simulation/run/simulation.hpp>

#include "read_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dynamy;
  static fuzz::World world = [] {
    fuzz::World w;
    w.plugins.load(kStandardElements, w.registry);
    return w;
  }();
  fuzz::readText(world, std::string(reinterpret_cast<const char*>(data), size), {}, [](Model& m) {
    const Simulation verified(m);
    MechanicalSystem system = m.mechanicalSystem();
    system.evaluate(m.initialState());
  });
  return 0;
}
