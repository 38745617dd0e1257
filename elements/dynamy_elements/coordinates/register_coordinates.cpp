#include <dynamy_elements/coordinates/coordinate_contact.hpp>
#include <dynamy_elements/coordinates/coordinate_jump.hpp>
#include <dynamy_elements/coordinates/coordinates.hpp>
#include <dynamy_elements/coordinates/register_coordinates.hpp>

namespace dynamy {

void registerCoordinates(Registry& registry) {
  registry.add<Coordinates>("Coordinates");
  registry.add<CoordinateFrame>("CoordinateFrame");
  registry.add<CoordinateJump>("Jump");
  registry.add<CoordinateContact>("CoordinateContact");
}

}  // namespace dynamy
