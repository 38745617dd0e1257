/// Contour: a closed smooth curve in its plane, a cam.
#pragma once
#include <dynamy/system/shape.hpp>

namespace dynamy {

/// r(φ) about the shape's z axis, by a formula or by radii at equal angles. The points of its
/// geometry are kContourPoints at equal angles.
class ContourShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit ContourShape(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  std::vector<double> radii_;
};

}  // namespace dynamy
