#include "import/extreme_points.hpp"

#include <algorithm>
#include <cmath>
#include <dynamy/system/convex_hull.hpp>
#include <set>

#include "import/machine.hpp"

namespace dynamy::app {
namespace {

/// Unit vectors on a spiral, evenly over the sphere, and the axes.
std::vector<Vec3> directions(int count) {
  constexpr double kGolden = 2.399963229728653;  // angle between neighbours, pi (3 - sqrt 5)
  std::vector<Vec3> out;
  for (int i = 0; i < 3; ++i) out.push_back(Vec3::Unit(i)), out.push_back(-Vec3::Unit(i));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z);
    out.emplace_back(r * std::cos(kGolden * i), r * std::sin(kGolden * i), z);
  }
  return out;
}

std::size_t farthest(const std::vector<Vec3>& points, const Vec3& n) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (n.dot(points[i]) > n.dot(points[best])) best = i;
  return best;
}

}  // namespace

std::vector<Vec3> outermostPoints(const std::vector<Vec3>& points) {
  static const std::vector<Vec3> all = directions(162);
  std::set<std::size_t> kept;
  for (const Vec3& n : all) kept.insert(farthest(points, n));
  std::vector<Vec3> out;
  for (const std::size_t i : kept) out.push_back(points[i]);
  return out;
}

std::vector<Vec3> extremePoints(const std::vector<Vec3>& points, double& inside) {
  std::vector<Vec3> out = outermostPoints(points);
  inside = 0.0;
  for (const Triangle& f : convexHull(out)) {
    const Vec3 &a = out[at(f[0])], n = (out[at(f[1])] - a).cross(out[at(f[2])] - a).normalized();
    for (const Vec3& p : points) inside = std::max(inside, n.dot(p - a));
  }
  return out;
}

}  // namespace dynamy::app
