/// Contour: a closed smooth curve in its plane, a cam.
#pragma once
#include <dynamy/system/shape.hpp>

namespace dynamy {

/// Curve r(φ) about the shape's z axis, given by a formula or by radii at equal angles. Its
/// geometry consists of kContourPoints points at equal angles.
class ContourShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit ContourShape(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  std::vector<double> radii_;
};

}  // namespace dynamy
