#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/system/convex_hull.hpp>
#include <map>
#include <set>
#include <utility>

namespace dynamy {
namespace {

/// Quickhull [Barber, Dobkin, Huhdanpaa 1996]: the point that is furthest outside of a face comes
/// next. Rejected: points in their given order, which makes slivers of points on an edge or in a face, whose
/// normals are rounding: hulls of clipped meshes lost a quarter of their volume.
class Hull {
 public:
  explicit Hull(const std::vector<Vec3>& points) : p_(points) {
    double extent = 0.0, size = 0.0;
    for (const Vec3& p : p_)
      extent = std::max(extent, (p - p_.front()).norm()), size = std::max(size, p.norm());
    rounding_ = kRounding * size, flat_ = kFlat * extent;
  }
  /// Begins with four points that span a volume; false: there are none.
  bool start() {
    const int n = static_cast<int>(p_.size());
    const auto farthest = [&](auto&& distance) {
      int best = 0;
      for (int i = 1; i < n; ++i)
        if (distance(at(i)) > distance(at(best))) best = i;
      return distance(at(best)) > flat_ ? best : -1;
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
    std::vector<int> all;
    for (int i = 0; i < n; ++i) all.push_back(i);
    addFaces({{a, x, y}, {a, d, x}, {x, d, y}, {y, d, a}}, all);
    return true;
  }
  /// Adds the point that is furthest outside; false: none is.
  bool add() {
    const Face* from = nullptr;
    for (const auto& [first, f] : faces_)
      if (!f.outside.empty() && (from == nullptr || f.most > from->most)) from = &f;
    if (from == nullptr) return false;
    const int p = from->furthest;
    // Replaces the faces that p is not behind, which are connected, by faces from their border to p.
    std::set<int> seen;
    std::vector<int> next{from->number};
    std::vector<Triangle> fan;
    while (!next.empty()) {
      const int number = next.back();
      next.pop_back();
      if (!seen.insert(number).second) continue;
      for (const auto& [a, b] : edgesOf(faces_.at(number).t)) {
        const int beside = faceOf_.at({b, a});
        if (!seen.contains(beside) && !isBehind(p, faces_.at(beside))) next.push_back(beside);
      }
    }
    std::vector<int> loose;
    for (const int number : seen)
      for (const auto& [a, b] : edgesOf(faces_.at(number).t))
        if (!seen.contains(faceOf_.at({b, a}))) fan.push_back({a, b, p});
    for (const int number : seen) {
      const Face& f = faces_.at(number);
      loose.insert(loose.end(), f.outside.begin(), f.outside.end());
      for (const auto& edge : edgesOf(f.t)) faceOf_.erase(edge);
      faces_.erase(number);
    }
    std::erase(loose, p);  // each comes once, whatever the rounding of a sliver's normal
    addFaces(fan, loose);
    return true;
  }
  std::vector<Triangle> faces() const {
    std::vector<Triangle> out;
    for (const auto& [number, f] : faces_) out.push_back(f.t);
    return out;
  }

 private:
  /// What is nearer to a face counts as in it: of the extent, and of the coordinates, whose rounding tilts a
  /// face by itself over its width.
  static constexpr double kFlat = 1e-12, kRounding = 16.0 * kEpsilon;
  struct Face {
    Triangle t;
    Vec3 n;
    double tilt;  ///< of the normal, by rounding
    int number;
    std::vector<int> outside;  ///< points that no other face has
    int furthest = -1;
    double most = 0.0;  ///< how far that one is outside [m]
  };
  const Vec3& at(int i) const { return p_[static_cast<std::size_t>(i)]; }
  static std::array<std::pair<int, int>, 3> edgesOf(const Triangle& t) {
    return {{{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}}};
  }
  double height(int p, const Face& f) const { return f.n.dot(at(p) - at(f.t[0])); }
  /// False also in the plane of the face: from an edge's own line to p there is no face.
  bool isBehind(int p, const Face& f) const { return height(p, f) < -within(p, f); }
  double within(int p, const Face& f) const {
    return flat_ + rounding_ + f.tilt * (at(p) - at(f.t[0])).norm();
  }
  /// Adds faces, and gives them those of the points that are outside.
  void addFaces(const std::vector<Triangle>& triangles, const std::vector<int>& points) {
    std::vector<Face*> added;
    for (const Triangle& t : triangles) {
      const Vec3 a = at(t[1]) - at(t[0]), b = at(t[2]) - at(t[0]), n = a.cross(b);
      const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
      const double tilt = std::min(1.0, rounding_ * longest / n.norm());
      added.push_back(
          &faces_.emplace(next_, Face{t, n.normalized(), tilt, next_, {}}).first->second);
      for (const auto& edge : edgesOf(t)) faceOf_[edge] = next_;
      ++next_;
    }
    for (const int p : points)
      for (Face* f : added)
        if (const double h = height(p, *f); h > within(p, *f)) {
          f->outside.push_back(p);
          if (h > f->most) f->most = h, f->furthest = p;
          break;
        }
  }
  const std::vector<Vec3>& p_;
  double flat_ = 0.0, rounding_ = 0.0;         // of planes, and of coordinates [m]
  std::map<int, Face> faces_;                  // by number, in the order in which they came
  std::map<std::pair<int, int>, int> faceOf_;  // the face with this directed edge
  int next_ = 0;
};

}  // namespace

std::vector<Triangle> convexHull(const std::vector<Vec3>& points) {
  Hull hull(points);
  if (points.size() < 4 || !hull.start()) return {};
  while (hull.add()) {
  }
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
  if (!(std::abs(out.volume) > 0.0)) return {};
  const Vec3 centre = first / out.volume;
  second -= out.volume * centre * centre.transpose();
  out.centre_B = centre;
  out.inertia_B = second.trace() * Mat3::Identity() - second;
  return out;
}

}  // namespace dynamy
