#include <dynamy_elements/contacts/pairs/polygon_contact.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Relative distance; a circle whose centre is nearer to a corner than
/// this touches an edge instead.
constexpr double kOnCorner = 1e-9;

/// Edge of `of` that is separated most from `other`, and its separation.
struct Outermost {
  double separation = -std::numeric_limits<double>::infinity();
  int edge = 0;
  Outermost(const PlacedPolygon& of, const PlacedPolygon& other) {
    Vec3 o = of.corner(0);
    for (int i = 0; i < of.size(); ++i) {
      const Vec3 next = of.corner(i + 1), n = (next - o).cross(of.plane).normalized();
      const Vec3 n_K = other.frame->A_IK.transpose() * n;
      double lowest = std::numeric_limits<double>::infinity();
      for (const Vec3& corner_K : *other.corners_K) lowest = std::min(lowest, n_K.dot(corner_K));
      const double s = n.dot(other.frame->r_OS_I - o) + lowest;
      if (s > separation) separation = s, edge = i;
      o = next;
    }
  }
};

/// The edge whose normal is nearest to n.
int edgeAlong(const PlacedPolygon& body, const Vec3& n) {
  int best = 0;
  double most = -2.0;
  for (int i = 0; i < body.size(); ++i)
    if (const double along = body.normal(i).dot(n); along > most) most = along, best = i;
  return best;
}

/// Corners of one edge over an edge of the other body.
class OverEdge {
 public:
  /// `sign` +1: the edge is A's.
  OverEdge(const PlacedPolygon& body, int edge, double sign, bool rates)
      : o_(body.corner(edge)),
        way_(body.corner(edge + 1) - o_),
        length_(way_.norm()),
        face_(*body.frame, body.normal(edge), o_, 0.0, sign * body.normal(edge).cross(body.plane),
              sign, rates) {}
  bool holds(const Vec3& p, double beside) const {
    const double s = way_.dot(p - o_) / length_;
    return s >= -beside && s <= length_ + beside;
  }
  void contact(const Frame& mover, const Vec3& p, ContactPoint& out) const {
    face_.contact(mover, p, out);
  }

 private:
  Vec3 o_, way_;
  double length_;
  PlacedFace face_;
};

}  // namespace

int betweenPolygons(const PlacedPolygon& A, const PlacedPolygon& B, double reach, bool rates,
                    PolygonContacts& out) {
  const Outermost ofA(A, B), ofB(B, A);
  if (std::max(ofA.separation, ofB.separation) > reach) return 0;
  const bool first = ofA.separation >= ofB.separation;
  const int a = first ? ofA.edge : edgeAlong(A, -B.normal(ofB.edge)),
            b = first ? edgeAlong(B, -A.normal(ofA.edge)) : ofB.edge;
  const Vec3 along = (A.corner(a + 1) - A.corner(a)).normalized();
  const double same = kSameFeature * std::min((A.corner(a + 1) - A.corner(a)).norm(),
                                              (B.corner(b + 1) - B.corner(b)).norm());
  Manifold<kMostPolygonContacts> found(4.0 * same);
  const double separation = std::max(ofA.separation, ofB.separation);
  double margin = same;
  const auto take = [&](const OverEdge& edge, const PlacedPolygon& body, int corner, int id) {
    const Vec3 p = body.corner(corner);
    if (!edge.holds(p, margin) || !found.takes(along.dot(p - A.corner(a)), 0.0)) return;
    NumberedContact& c = out[static_cast<std::size_t>(found.size() - 1)];
    c.id = id + corner % body.size();
    edge.contact(*body.frame, p, c.at);
  };
  const OverEdge onA(A, a, 1.0, rates), onB(B, b, -1.0, rates);
  const auto takeAll = [&] {
    for (const int corner : {b, b + 1}) take(onA, B, corner, 0);
    for (const int corner : {a, a + 1}) take(onB, A, corner, B.size());
  };
  takeAll();
  const std::span<const NumberedContact> taken(out.data(), static_cast<std::size_t>(found.size()));
  margin = besideFace(separation, same);
  if (margin > same && leastGap(taken) > separation + same) takeAll();
  return found.size();
}

void closeTogether(const PlacedPolygon& A, double reach, bool rates,
                   std::span<NumberedContact> contacts) {
  closeTogetherOn(*A.frame, reach, rates, contacts,
                  [&](Vec3& n, Vec3& t) { n = A.normal(edgeAlong(A, n)), t = n.cross(A.plane); });
}

double separation(const PlacedPolygon& A, const PlacedPolygon& B) {
  return std::max(Outermost(A, B).separation, Outermost(B, A).separation);
}

ContactPoint ballOnPolygon(const PlacedPolygon& A, const Frame& B, const RoundFeature& ball) {
  const Vec3 rho = B.A_IK * ball.c_K, c = B.r_OS_I + rho;
  // Heights over the edges: for a centre inside the highest counts,
  // outside that of the edge under c.
  int highest = 0, under = -1;
  double height = -std::numeric_limits<double>::infinity(), size = 0.0;
  for (int i = 0; i < A.size(); ++i) {
    const Vec3 o = A.corner(i), way = A.corner(i + 1) - o;
    const double h = A.normal(i).dot(c - o), s = way.dot(c - o);
    if (h > height) height = h, highest = i;
    if (h > 0.0 && s >= 0.0 && s <= way.squaredNorm()) under = i;
    size = std::max(size, way.norm());
  }
  int nearest = 0;
  for (int i = 1; i < A.size(); ++i)
    if ((c - A.corner(i)).squaredNorm() < (c - A.corner(nearest)).squaredNorm()) nearest = i;
  const Vec3 d = c - A.corner(nearest);
  if (height > 0.0 && under < 0 && d.norm() > kOnCorner * size) {
    const RoundFeature corner{(*A.corners_K)[static_cast<std::size_t>(nearest)], 0.0};
    return betweenBalls(*A.frame, corner, B, ball, A.plane);
  }
  const int edge = under >= 0 ? under : highest;
  const Vec3 n = A.normal(edge), ndot = A.frame->Omega_I.cross(n);
  ContactPoint out;
  setDirections(out, n, ndot, A.plane);
  out.g = n.dot(c - A.corner(edge)) - ball.radius;
  out.P = c - ball.radius * n, out.Pdot = B.velocity(rho) - ball.radius * ndot;
  return out;
}

namespace {

/// Part of the polygon's size by which it may overlap more along the
/// side of a capsule than elsewhere.
constexpr double kDeeper = 0.01;

/// The side of a capsule's axis, without its radius, that faces a
/// polygon: n points from the polygon.
struct NearSide {
  Vec3 n;
  double deepest;  ///< a corner further past the axis than this is not beside the capsule [m]
  NearSide(const PlacedPolygon& A, const LineSegment& axis) : n(A.plane.cross(axis.e)) {
    double size = 0.0, least = std::numeric_limits<double>::infinity(), most = -least;
    for (int i = 0; i < A.size(); ++i) {
      const Vec3 c = A.corner(i);
      const double h = n.dot(axis.o - c);
      least = std::min(least, h), most = std::max(most, h);
      size = std::max(size, (A.corner(i + 1) - c).norm());
    }
    if (-most > least) n = -n, least = -most;
    // The line cuts the polygon, but the axis itself may be clear of it, beyond an edge.
    for (int i = 0; i < A.size() && least < 0.0; ++i) {
      const Vec3 edge = A.normal(i);
      const double middle = edge.dot(axis.o - A.corner(i));
      least = std::max(least, middle - axis.half * std::abs(edge.dot(axis.e)));
    }
    deepest = std::min(least, 0.0) - kDeeper * size;
  }
};

}  // namespace

int capsuleOnPolygon(const PlacedPolygon& A, const Frame& B, const TouchingShape& capsule,
                     CapsuleOnPolygon& out) {
  const LineSegment axis = capsuleAxis(B, capsule);
  const double R = capsule.features[0].radius;
  int count = 0;
  for (const SupportFeature& end : capsule.features) {
    out[static_cast<std::size_t>(count)] = {count, ballOnPolygon(A, B, end)};
    ++count;
  }
  const NearSide side(A, axis);
  for (int i = 0; i < A.size(); ++i) {
    const Vec3 c = A.corner(i);
    const double h = side.n.dot(axis.o - c);
    if (std::abs(axis.e.dot(c - axis.o)) >= axis.half || h < side.deepest) continue;
    // If there is no room for all contacts, the nearest ones stay.
    NumberedContact* at = nullptr;
    if (count < kMostCapsuleOnPolygon) {
      at = &out[static_cast<std::size_t>(count++)];
    } else {
      at = std::max_element(out.begin() + 2, out.end(),
                            [](const auto& a, const auto& b) { return a.at.g < b.at.g; });
      if (h - R >= at->at.g) continue;
    }
    *at = {2 + i,
           besideSegment(axis, R, side.n, c, A.frame->velocity(c - A.frame->r_OS_I), A.plane)};
  }
  return count;
}

}  // namespace dynamy
