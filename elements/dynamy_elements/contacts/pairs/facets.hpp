/// Contacts of plane faces and straight edges: what boxes, polyhedra and meshes have in common.
///
///   vertex of B over a face of A   g = n_A·(p_B − f_A)        n_A fixed in A
///   edge of A, edge of B           g = n·(p_B − p_A)          n = ±e_A × e_B/|e_A × e_B|
///
/// p_A, p_B on edges are the closest points of the two lines. Gap, normal and γ_N = ġ are exact
/// before and after touching. Clipping one face against the sides of the other was rejected: a
/// clipped point belongs to no feature, so that its gap is not the integral of its velocity.
#pragma once
#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>
#include <limits>
#include <span>

namespace dynamy {

/// Features nearer than this part of the smaller body's size count as one.
inline constexpr double kSameFeature = 1e-6;
/// Sine of the angle from which two edges have a normal of their own.
inline constexpr double kCross = 0.05;
/// Crossing edges belong to a pair of faces if the cosine between their
/// normal and the face's is larger.
inline constexpr double kLikeFace = 0.7;
/// If no other contact is as near as the separation of two faces, a corner beside a face counts as
/// over it up to kBeside of this separation, and up to kMostBeside times kSameFeature. Two bodies
/// may turn about parallel edges that meet, one edge on the other. With this margin they have a
/// contact also while they are apart, and not only while they overlap.
inline constexpr double kBeside = 0.5, kMostBeside = 100.0;
/// A contact is one of a face if the cosine between its normal and the face's is larger. A point
/// that moves along its own tangents into the face's plane then moves by at most √3 gaps.
inline constexpr double kOfThatFace = 0.5;

/// Distance beside a face up to which a corner counts as over it [m]. `separation`: of the two
/// faces; `same`: distance below which features are one.
inline double besideFace(double separation, double same) {
  return same + std::min(kBeside * std::max(separation, 0.0), kMostBeside * same);
}

/// Least gap of a contact of two faces [m]. `separation`: of the bodies. No two features are nearer
/// than that. Edges whose lines cross far from the place where the bodies meet, with a normal
/// across their separation, can have a gap far below it, which is not one of the bodies.
inline double leastOfFaces(double separation, double same) {
  return separation - 4.0 * besideFace(separation, same);
}

/// Is |x| larger than `most`, by more than their roundings?
inline bool isBeyond(double x, double most) { return std::abs(x) > (1.0 + 1e-9) * most; }

/// Least gap of contacts; infinite if there are none.
inline double leastGap(std::span<const NumberedContact> contacts) {
  double least = std::numeric_limits<double>::infinity();
  for (const NumberedContact& c : contacts) least = std::min(least, c.at.g);
  return least;
}

/// A straight edge in the world.
struct PlacedEdge {
  Vec3 o, e;  ///< middle, unit direction
  double half;
};

/// A face that vertices of the other body may touch; its directions are
/// computed once for all of them.
class PlacedFace {
 public:
  /// Plane { n·(r − o) = height } of the frame `f`, with a direction `t` in it;
  /// `sign` +1: it is A's. `rates`: rates of the directions and of the points are
  /// computed, too; otherwise they are zero.
  PlacedFace(const Frame& f, const Vec3& n, const Vec3& o, double height, const Vec3& t,
             double sign, bool rates)
      : rates_(rates), n_(n), o_(o), height_(height) {
    at_.d[0] = sign * n_;
    at_.d[1] = t;
    at_.d[2] = at_.d[0].cross(at_.d[1]);
    for (int i = 0; i < 3; ++i)
      at_.ddot[i] = rates ? Vec3(f.Omega_I.cross(at_.d[i])) : Vec3(Vec3::Zero());
  }
  /// Contact of the face with the vertex p, which moves with `mover`.
  void contact(const Frame& mover, const Vec3& p, ContactPoint& out) const {
    out = at_;
    out.g = n_.dot(p - o_) - height_;
    out.P = p;
    if (rates_) out.Pdot = mover.velocity(p - mover.r_OS_I);
  }

 private:
  bool rates_;
  Vec3 n_, o_;
  double height_;
  ContactPoint at_;
};

/// Closest points of two lines, with parameters from their middles; meaningless for parallel lines.
struct EdgeCrossing {
  bool parallel;
  double s, t;
  Vec3 PA, PB, n;
  EdgeCrossing(const PlacedEdge& a, const PlacedEdge& b) {
    const Vec3 cross = a.e.cross(b.e), d = b.o - a.o;
    const double square = cross.squaredNorm(), c = a.e.dot(b.e);
    parallel = square < kCross * kCross;
    const double da = d.dot(a.e), db = d.dot(b.e);
    s = (da - c * db) / square, t = (c * da - db) / square;
    PA = a.o + s * a.e, PB = b.o + t * b.e;
    n = cross / std::sqrt(square);
  }
};

/// Contact of two edges at the closest points of their lines. `rates`: of the directions and of the
/// point are computed, too.
inline ContactPoint edgeOnEdge(const Frame& fA, const PlacedEdge& a, const Frame& fB,
                               const PlacedEdge& b, const EdgeCrossing& at, const Vec3& towardsB,
                               bool rates = true) {
  ContactPoint out;
  const double sign = at.n.dot(towardsB) < 0.0 ? -1.0 : 1.0;
  const Vec3 n = sign * at.n, d = at.PB - at.PA;
  out.g = n.dot(d), out.P = at.PB;
  out.d[0] = n, out.d[1] = a.e, out.d[2] = n.cross(a.e);
  if (!rates) {
    for (Vec3& ddot : out.ddot) ddot.setZero();
    return out;
  }
  const Vec3 eAdot = fA.Omega_I.cross(a.e), eBdot = fB.Omega_I.cross(b.e);
  const Vec3 cross = a.e.cross(b.e), crossdot = eAdot.cross(b.e) + a.e.cross(eBdot);
  const Vec3 ndot = sign * (crossdot - at.n * at.n.dot(crossdot)) / cross.norm();
  out.ddot[0] = ndot, out.ddot[1] = eAdot, out.ddot[2] = ndot.cross(a.e) + n.cross(eAdot);
  // d ⟂ e_A, e_B for all times: ḋ·e + d·ė = 0 with ḋ = v_B − v_A + ṫ e_B − ṡ e_A gives ṫ.
  const Vec3 vB = fB.velocity(at.PB - fB.r_OS_I), v = vB - fA.velocity(at.PA - fA.r_OS_I);
  const double c = a.e.dot(b.e), ra = v.dot(a.e) + d.dot(eAdot), rb = v.dot(b.e) + d.dot(eBdot);
  const double tdot = (c * ra - rb) / (1.0 - c * c);
  out.Pdot = vB + tdot * b.e;
  return out;
}

/// Collects contacts by their places x, y on the face of A; of contacts at the
/// same place only the first counts.
template <int Most>
class Manifold {
 public:
  explicit Manifold(double same) : same2_(same * same) {}
  /// Adds a contact at (x, y) if there is room and none is at this place
  /// yet; returns whether it did.
  bool takes(double x, double y) {
    for (int i = 0; i < size_; ++i) {
      const double dx = x_[i] - x, dy = y_[i] - y;
      if (dx * dx + dy * dy <= same2_) return false;
    }
    if (size_ == Most) return false;
    x_[size_] = x, y_[size_++] = y;
    return true;
  }
  /// Removes the contact added last.
  void drop() { --size_; }
  int size() const { return size_; }

 private:
  double same2_, x_[Most], y_[Most];
  int size_ = 0;
};

/// Does the smallest gap of the contacts agree with f, the largest separation of two bodies, up to
/// `loose` [m]? For bodies that overlap deeply it may not: the features that face along the
/// direction of f may all be far from each other, and the nearest ones, such as the far end of a
/// rim, may be open. Bodies that overlap by less than `loose` are always accepted.
inline bool tellsOverlap(double f, double loose, std::span<const NumberedContact> contacts) {
  if (!(f < -loose)) return true;
  return std::abs(leastGap(contacts) - f) <= loose;
}

/// Moves contacts of a face of A whose gaps are at most `reach` [m], and which are thus close
/// together, into one plane along that face; contacts with a normal across that of the face stay.
/// Three or more contacts, whose gaps limit how far the two faces can be tilted, also get the
/// tangents of the face. Normals, gaps and γ_N stay. Otherwise sticking contacts contradict each
/// other by the tilt, and every contact has to slide by almost nothing.
/// `faceAlong(n, t)`: replaces n by the normal of A's face along n, and
/// t by a direction in that face.
template <class FaceAlong>
void closeTogetherOn(const Frame& A, double reach, bool rates, std::span<NumberedContact> contacts,
                     FaceAlong&& faceAlong) {
  if (contacts.empty()) return;
  const ContactPoint lowest =
      std::min_element(
          contacts.begin(), contacts.end(),
          [](const NumberedContact& a, const NumberedContact& b) { return a.at.g < b.at.g; })
          ->at;
  Vec3 n = lowest.d[0], t1;
  faceAlong(n, t1);
  const auto near = [reach, &n](const NumberedContact& c) {
    return c.at.g <= reach && n.dot(c.at.d[0]) > kOfThatFace;
  };
  const auto closed = std::count_if(contacts.begin(), contacts.end(), near);
  if (closed < 2) return;
  const Vec3 t2 = n.cross(t1), ndot = A.Omega_I.cross(n);
  for (NumberedContact& c : contacts) {
    if (!near(c)) continue;
    ContactPoint& at = c.at;
    intoPlane(n, ndot, lowest, at);
    if (closed < 3) continue;
    at.d[1] = t1, at.d[2] = t2;
    if (rates) at.ddot[1] = A.Omega_I.cross(t1), at.ddot[2] = A.Omega_I.cross(t2);
  }
}

}  // namespace dynamy
