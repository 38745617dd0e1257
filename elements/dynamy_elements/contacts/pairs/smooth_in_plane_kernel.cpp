#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>
#include <dynamy_elements/contacts/pairs/smooth_search.hpp>
#include <limits>

namespace dynamy {

using smooth::Placed;

ContactPoint smoothInPlane(const Frame& fA, const SupportFeature& a, const Frame& fB,
                           const SupportFeature& b, const Vec3& plane) {
  const Placed A{fA, a}, B{fB, b};
  const Vec3 way = B.centre() - A.centre(), inPlane = way - way.dot(plane) * plane;
  const Vec3 start = inPlane.norm() > 0.0 ? inPlane.normalized() : plane.unitOrthogonal();
  return smooth::betweenFrom(A, B, start, plane);
}

ContactPoint smoothOnPolygon(const PlacedPolygon& A, const Frame& B,
                             const SupportFeature& feature) {
  const Placed b{B, feature};
  // Of the edges over which the outermost point lies, the one that
  // separates most; else the highest.
  int under = -1, highest = 0;
  double most = -std::numeric_limits<double>::infinity(), height = most, size = 0.0;
  for (int i = 0; i < A.size(); ++i) {
    const Vec3 n = A.normal(i), o = A.corner(i), way = A.corner(i + 1) - o, p = b.point(-n) - o;
    const double h = n.dot(p), s = way.dot(p);
    if (h > height) height = h, highest = i;
    if (h > most && s >= 0.0 && s <= way.squaredNorm()) most = h, under = i;
    size = std::max(size, way.norm());
  }
  const auto onEdge = [&](int i) {
    return smooth::overPlane(*A.frame, A.normal(i), A.corner(i), b, A.plane);
  };
  if (under >= 0 && most >= height - 1e-12 * size) return onEdge(under);

  // Of the corners whose normal points out of the polygon, the one with the smallest gap.
  ContactPoint best;
  best.g = std::numeric_limits<double>::infinity();
  for (int i = 0; i < A.size(); ++i) {
    const Vec3 c = A.corner(i);
    const ContactPoint at = smooth::onPoint(*A.frame, c, b, &A.plane, A.plane);
    const Vec3 &n = at.d[0], before = A.corner(i + A.size() - 1) - c, after = A.corner(i + 1) - c;
    if (n.dot(before) <= 0.0 && n.dot(after) <= 0.0 && at.g < best.g) best = at;
  }
  return std::isfinite(best.g) ? best : onEdge(under >= 0 ? under : highest);
}

ContactPoint capsuleOnSmooth(const Frame& A, const SupportFeature& feature, const Frame& B,
                             const TouchingShape& capsule, const Vec3& plane) {
  const Placed a{A, feature};
  const LineSegment axis = capsuleAxis(B, capsule);
  const double R = capsule.features[0].radius;
  // The candidates, seen from the capsule, are its sides and its ends.
  double most = -std::numeric_limits<double>::infinity();
  ContactPoint best;
  const auto take = [&](const ContactPoint& at) {
    const Vec3& n = at.d[0];
    const double f = n.dot(a.point(-n) - axis.o) - axis.half * std::abs(n.dot(axis.e)) - R;
    if (f > most) most = f, best = at;
  };
  const Vec3 across = plane.cross(axis.e).normalized();
  for (const double side : {1.0, -1.0}) {
    const Vec3 n = side * across;
    take(smooth::overPlane(B, n, axis.o + R * n, a, plane));
  }
  for (const SupportFeature& end : capsule.features) take(smoothInPlane(B, end, A, feature, plane));
  turnRound(best);
  return best;
}

}  // namespace dynamy
