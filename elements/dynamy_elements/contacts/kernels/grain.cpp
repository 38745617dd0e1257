#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy_elements/contacts/kernels/grain.hpp>

namespace dynamy {
namespace {

/// Sine of the angle between grain and normal below which the grain gives no direction.
constexpr double kOnEnd = 1e-6;
constexpr int kPlanarRows = 2;

}  // namespace

void alongGrain(ContactPoint& at, const Vec3& grain_I, const Vec3& Omega_I) {
  const Vec3 &n = at.d[0], &ndot = at.ddot[0];
  const double along = n.dot(grain_I);
  const Vec3 p = grain_I - along * n;
  const double length = p.norm();
  if (length < kOnEnd) return;
  const Vec3 gdot = Omega_I.cross(grain_I);
  const Vec3 pdot = gdot - (ndot.dot(grain_I) + n.dot(gdot)) * n - along * ndot;
  const Vec3 t1 = p / length, t1dot = (pdot - t1.dot(pdot) * t1) / length;
  at.d[1] = t1, at.d[2] = n.cross(t1);
  at.ddot[1] = t1dot, at.ddot[2] = ndot.cross(t1) + n.cross(t1dot);
}

bool differsByDirection(const SetValuedForceLaw& law, int rows) {
  const NormalTimesReservoir* reservoir = law.reservoir();
  const int dim = law.dim(rows);
  if (!reservoir || dim <= kPlanarRows) return false;
  const std::array<double, kMostRows> zero{};
  const LawInput in{.dim = dim, .dt = 1.0, .gammaA = zero.data(), .position = zero.data()};
  const auto width = [&](double x, double y) {
    const std::array<double, kMostRows> direction{x, y};
    return reservoir->support(in, dim - 1, direction.data());
  };
  constexpr double kDirections[][2] = {{-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}, {0.6, 0.8}};
  const double first = width(1.0, 0.0);
  // The tolerance exceeds the rounding of the width of any law.
  return std::any_of(std::begin(kDirections), std::end(kDirections), [&](const double* e) {
    return std::abs(width(e[0], e[1]) - first) > 1e-9 * (1.0 + first);
  });
}

GrainFault grainFault(const TouchingShape& a, const TouchingShape& b, const SetValuedForceLaw& law,
                      int rows) {
  const bool ofA = !a.grain_K.isZero(0.0), ofB = !b.grain_K.isZero(0.0);
  // In a plane the law has one tangent; its width with two shows whether it needs a grain.
  if (!differsByDirection(law, std::max(rows, kPlanarRows + 1))) return {};
  if (rows <= kPlanarRows && (ofA || ofB))
    return {"bodies in a plane have one tangent, which no grain can choose",
            "leave the grain away: the law is taken along its first axis, turned by `angle`"};
  if (rows <= kPlanarRows) return {};
  if (ofA && ofB)
    return {"the friction differs by direction, and both shapes have a grain",
            "leave the grain of one of them away"};
  if (!ofA && !ofB && (a.kind != TouchingShape::Kind::halfSpace || b.family))
    return {"the friction differs by direction, and neither shape says by which",
            "add grain=\"1 0 0\" to one of them"};
  return {};
}

}  // namespace dynamy
