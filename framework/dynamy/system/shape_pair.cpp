#include <dynamy/system/shape_pair.hpp>

namespace dynamy {

const ShapeFamily ShapeFamily::halfSpace{"HalfSpace", {}};
const ShapeFamily ShapeFamily::ball{"Sphere", {}};

}  // namespace dynamy
