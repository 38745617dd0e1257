#include <algorithm>
#include <cmath>
#include <dynamy/system/convex_hull.hpp>
#include <map>

namespace dynamy {
namespace {

class Hull {
 public:
  explicit Hull(const std::vector<Vec3>& points) : p_(points) {
    for (const Vec3& p : p_) extent_ = std::max(extent_, (p - p_.front()).norm());
  }
  /// Begins with four points that span a volume; false: there are none.
  bool start() {
    const int n = static_cast<int>(p_.size());
    const auto farthest = [&](auto&& distance) {
      int best = 0;
      for (int i = 1; i < n; ++i)
        if (distance(at(i)) > distance(at(best))) best = i;
      return distance(at(best)) > kFlat * extent_ ? best : -1;
    };
    const int a = 0, b = farthest([&](const Vec3&p) { return (p - at(a)).norm(); });
    if (b < 0) return false;
    const Vec3 e = (at(b) - at(a)).normalized();
    const int c = farthest([&](const Vec3& p) { return (p - at(a)).cross(e).norm(); });
    if (c < 0) return false;
    const Vec3 n3 = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
    const int d = farthest([&](const Vec3& p) { return std::abs(n3.dot(p - at(a))); });
    if (d < 0) return false;
    const bool above = n3.dot(at(d) - at(a)) > 0.0;
    const int x = above ? c : b, y = above ? b : c;  // a x y counterclockwise seen from outside
    faces_ = {{a, x, y}, {a, d, x}, {x, d, y}, {y, d, a}};
    return true;
  }
  /// Replaces the faces that are visible from p by faces from their border to p.
  void add(int p) {
    std::map<std::pair<int, int>, int> edges;  // edges of visible faces: directed edge, count
    std::vector<Triangle> kept;
    for (const Triangle& f : faces_) {
      if (!sees(p, f)) {
        kept.push_back(f);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) edges[{f[k], f[(k + 1) % 3]}] = 1;
    }
    if (edges.empty()) return;
    for (const auto& [edge, count] : edges)
      if (!edges.contains({edge.second, edge.first})) kept.push_back({edge.first, edge.second, p});
    faces_ = std::move(kept);
  }
  const std::vector<Triangle>& faces() const { return faces_; }

 private:
  static constexpr double kFlat = 1e-12;
  const Vec3& at(int i) const { return p_[static_cast<std::size_t>(i)]; }
  bool sees(int p, const Triangle& f) const {
    const Vec3 n = (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0])).normalized();
    return n.dot(at(p) - at(f[0])) > kFlat * extent_;
  }
  const std::vector<Vec3>& p_;
  double extent_ = 0.0;
  std::vector<Triangle> faces_;
};

}  // namespace

std::vector<Triangle> convexHull(const std::vector<Vec3>& points) {
  Hull hull(points);
  if (points.size() < 4 || !hull.start()) return {};
  for (int i = 0; i < static_cast<int>(points.size()); ++i) hull.add(i);
  return hull.faces();
}

MassProperties enclosed(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  double six = 0.0;  // times the volume
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const Triangle& t : triangles) {
    const Vec3 &a = points[static_cast<std::size_t>(t[0])],
               &b = points[static_cast<std::size_t>(t[1])],
               &c = points[static_cast<std::size_t>(t[2])];
    const double det = a.dot(b.cross(c));
    const Vec3 s = a + b + c;
    six += det, first += det / 24.0 * s;
    second += det / 120.0 *
              (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  MassProperties out;
  out.volume = six / 6.0;
  if (!(out.volume > 0.0)) return {};
  const Vec3 centre = first / out.volume;
  second -= out.volume * centre * centre.transpose();
  out.centre_B = centre;
  out.inertia_B = second.trace() * Mat3::Identity() - second;
  return out;
}

}  // namespace dynamy
