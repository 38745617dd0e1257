// Balls that hold shapes, about their origins.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/system/shape.hpp>
#include <limits>

namespace dynamy {
namespace {

double bound(ShapeType type, std::array<double, 4> size, std::vector<Vec3> points = {}) {
  return boundOf(ShapeGeometry{type, size, std::move(points), ""});
}

TEST(ShapeBound, ReachesTheFurthestPointOfEachShape) {
  EXPECT_EQ(bound(ShapeType::point, {0.1}), 0.0);  // its dot is drawn only
  EXPECT_EQ(bound(ShapeType::sphere, {0.3}), 0.3);
  EXPECT_EQ(bound(ShapeType::circle, {0.3}), 0.3);
  EXPECT_DOUBLE_EQ(bound(ShapeType::box, {0.2, 0.4, 0.4}), 0.3);
  EXPECT_DOUBLE_EQ(bound(ShapeType::cylinder, {0.3, 0.8}), 0.5);
  EXPECT_DOUBLE_EQ(bound(ShapeType::bore, {0.3, 0.8}), 0.5);
  EXPECT_DOUBLE_EQ(bound(ShapeType::capsule, {0.1, 0.8}), 0.5);
  EXPECT_EQ(bound(ShapeType::cone, {0.1, 0.8}), 0.8);
  EXPECT_EQ(bound(ShapeType::cone, {0.9, 0.8}), 0.9);
  EXPECT_DOUBLE_EQ(bound(ShapeType::torus, {0.4, 0.1}), 0.5);
  EXPECT_EQ(bound(ShapeType::ellipsoid, {0.1, 0.3, 0.2}), 0.3);
  const std::vector<Vec3> points = {Vec3(0.3, 0.4, 0.0), Vec3(0.0, -0.1, 0.0)};
  for (const ShapeType type : {ShapeType::line, ShapeType::polygon, ShapeType::contour,
                               ShapeType::polyhedron, ShapeType::mesh})
    EXPECT_DOUBLE_EQ(bound(type, {}, points), 0.5);
  EXPECT_EQ(bound(ShapeType::halfSpace, {}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace dynamy
