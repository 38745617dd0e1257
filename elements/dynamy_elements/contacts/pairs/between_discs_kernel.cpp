#include <array>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/pairs/between_discs.hpp>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/disc_separation.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <limits>

namespace dynamy {
namespace {

using DiscPart = DiscBody::Part;

/// First numbers of the contacts of rims with one body.
struct Numbers {
  int rims, points, onSide;  ///< of the other body's rims: over the cap, its points, on the side
};
constexpr Numbers kOnA{0, 2, kBOnSide}, kOnB{10, 12, kAOnSide};
/// Sine between a direction and a rim's tangent below which the place is its outermost one.
constexpr double kStationary = 1e-9;

/// All contacts along the direction of largest separation.
class Contacts {
 public:
  Contacts(const DiscBody& A, const DiscBody& B, const DiscsApart& apart, double same,
           DiscContacts& out)
      : A_(A),
        B_(B),
        n_(apart.n),
        f_(apart.f),
        same_(same),
        loose_(4.0 * kSameFeature * std::max(A.thickness(), B.thickness())),
        found_(4.0 * same),
        out_(out) {
    x_ = n_.unitOrthogonal(), y_ = n_.cross(x_);
  }

  int all() {
    const DiscPart a = A_.part(n_), b = B_.part(-n_);
    // If two caps touch and the smaller is inside the other, the points of
    // the smaller are sufficient.
    const bool small = A_.rho < B_.rho;
    const DiscBody &one = small ? B_ : A_, &other = small ? A_ : B_;
    const bool full = over(one, other, small ? -1.0 : 1.0, true, same_);
    over(other, one, small ? 1.0 : -1.0, !full, same_);
    if (a == DiscPart::cap && b == DiscPart::cap && !full) crossings();
    if (a == DiscPart::side && b == DiscPart::side) sides();
    onSide(A_, B_, 1.0), onSide(B_, A_, -1.0);
    rims();
    if (found_.size() == 0) any();
    return tellsOverlap(f_, loose_, std::span(out_.data(), found_.size())) ? found_.size()
                                                                           : outermostPoints();
  }

 private:
  /// Adds a contact unless there is one at its place, or its gap is below the largest separation:
  /// then its features cross far from the place where the bodies meet. `sign` −1: its normal is from B to A.
  bool add(int id, ContactPoint at, double sign = 1.0) {
    if (sign < 0.0)
      for (const int k : {0, 1}) at.d[k] = -at.d[k], at.ddot[k] = -at.ddot[k];
    if (!(at.d[0].dot(n_) > kLikeFace && at.g >= f_ - loose_) ||
        !found_.takes(x_.dot(at.P), y_.dot(at.P)))
      return false;
    out_[static_cast<std::size_t>(found_.size() - 1)] = {id, at};
    return true;
  }

  /// Rims of `other` over the cap of `one`; true: all four points of the rim are over it. `sign`
  /// +1: `one` is A. `beside`: how far outside of the cap the points may be [m].
  bool over(const DiscBody& one, const DiscBody& other, double sign, bool points, double beside) {
    const Vec3 towards = sign * n_;
    if (one.part(towards) != DiscPart::cap) return false;
    const Numbers& number = &one == &A_ ? kOnA : kOnB;
    const Vec3 n = one.a.dot(towards) < 0.0 ? Vec3(-one.a) : one.a;
    const PlacedFace cap(*one.frame, n, one.c, one.half + one.r, one.x, 1.0, true);
    const auto inside = [&](const Vec3& p) {
      return one.acrossAxis(p - one.c).norm() <= one.rho + beside;
    };
    const DiscPart part = other.part(-towards);
    const int facing = other.rimAlong(-towards);
    for (int rim = 0; rim < other.rims(); ++rim) {
      if ((part != DiscPart::side && rim != facing) || !other.touches(-n, rim)) continue;
      ContactPoint at, there;
      cap.contact(*other.frame, other.c, at);
      wander(other, rim, at);
      cap.contact(*other.frame, at.P, there);
      at.g = there.g;
      if (inside(at.P)) add(number.rims + rim, at, sign);
    }
    if (!points || part != DiscPart::cap) return false;
    bool all = true;
    for (int k = 0; k < 4; ++k) {
      const Vec3 p = other.point(facing, k) - other.r * n;
      all = all && inside(p);
      if (!inside(p)) continue;
      ContactPoint at;
      cap.contact(*other.frame, p, at);
      // The contact of a tube with the cap stays below the middle of the tube.
      at.Pdot += other.r * (other.frame->Omega_I.cross(n) - at.ddot[0]);
      add(number.points + 4 * facing + k, at, sign);
    }
    return all;
  }

  /// Where the rims of two caps cross, seen along n.
  void crossings() {
    const int i = A_.rimAlong(n_), j = B_.rimAlong(-n_);
    const Vec3 way = A_.acrossAxis(B_.middle(j) - A_.middle(i));
    const double distance = way.norm();
    if (!(distance > kCross * std::min(A_.rho, B_.rho))) return;
    const Vec3 e = way / distance, f = A_.a.cross(e);
    const double along = 0.5 * (distance * distance + A_.rho * A_.rho - B_.rho * B_.rho) / distance;
    const double square = A_.rho * A_.rho - along * along;
    if (!(square > 0.0)) return;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 p = A_.middle(i) + along * e + side * std::sqrt(square) * f;
      rimsAt(A_.rim(i, p - A_.middle(i)), B_.rim(j, p - B_.middle(j)), i, j);
    }
  }
  void rimsAt(BodyCurve a, BodyCurve b, int i, int j) {
    if (!toClosest(a, b)) return;
    const bool left = (a.x - a.c).cross(b.c - a.c).dot(a.a) < 0.0;
    add(kRimPairs + 4 * i + 2 * j + (left ? 1 : 0), curveOnCurve(a, b, n_));
  }
  void rims() {
    const int i = A_.rimAlong(n_), j = B_.rimAlong(-n_);
    if (!A_.touches(n_, i) || !B_.touches(-n_, j)) return;
    const bool pointA = A_.radius(i) == 0.0, pointB = B_.radius(j) == 0.0;
    const int id = kRimPairs + 4 * i + 2 * j;
    if (pointA && pointB)
      points(id, i, j);
    else if (pointA)
      add(id, pointOnCurve(B_.rim(j, -n_), *A_.frame, A_.middle(i), A_.r, -n_), -1.0);
    else if (pointB)
      add(id, pointOnCurve(A_.rim(i, n_), *B_.frame, B_.middle(j), B_.r, n_));
    else
      rimsAt(A_.rim(i, n_), B_.rim(j, -n_), i, j);
  }
  /// Contacts of tips, and of tips with ends of capsules.
  void points(int id, int i, int j) {
    if (!A_.tip && !B_.tip) return;
    const Vec3 a = A_.middle(i), b = B_.middle(j);
    const Vec3 vA = A_.frame->velocity(a - A_.frame->r_OS_I),
               vB = B_.frame->velocity(b - B_.frame->r_OS_I);
    add(id, fromWay(b - a, vB - vA, A_.r, B_.r, a, vA, n_, Vec3::Zero()));
  }

  void sides() {
    if (A_.tip || B_.tip) {
      ContactPoint at;
      double sA = 0.0, sB = 0.0;
      if (sideOnSide(A_, B_, n_, sA, sB, at) && onLine(A_, sA) && onLine(B_, sB)) add(kSides, at);
      return;
    }
    BodyCurve a = A_.axis(), b = B_.axis();
    if (!toClosest(a, b) || !within(A_, a.x) || !within(B_, b.x)) return;
    add(kSides, curveOnCurve(a, b, n_));
  }
  /// Is `s` on a line of the side of D, counted from rim 0?
  bool onLine(const DiscBody& D, double s) const {
    return s >= -same_ && s <= (D.tip ? D.slant() : 2.0 * D.half) + same_;
  }
  bool within(const DiscBody& D, const Vec3& p) const {
    return std::abs(D.a.dot(p - D.c)) <= D.half + same_;
  }

  /// Rims of `other` on the side of `one`: at their crossings, or at the nearest points.
  void onSide(const DiscBody& one, const DiscBody& other, double sign) {
    const Vec3 towards = sign * n_;
    if (one.part(towards) != DiscPart::side) return;
    const int number = (&one == &A_ ? kOnA : kOnB).onSide;
    const DiscPart part = other.part(-towards);
    const int facing = other.rimAlong(-towards);
    const auto take = [&](const BodyCurve& rim, int id) {
      ContactPoint at;
      // Of parallel axes the sign would be that of rounding.
      if (rimOnSide(one, rim, towards, at))
        add(id + (one.a.dot(rim.x - rim.c) > kSameFeature * rim.rho ? 1 : 0), at, sign);
    };
    if (part == DiscPart::cap) {
      BodyCurve crossing[2];
      const Vec3 over = one.tip ? sideAlong(one, towards) : one.a;
      const Vec3 from = one.tip ? one.middle(1) : one.c;
      const int n = other.crossings(facing, from, over, n_, crossing);
      for (int k = 0; k < n; ++k) take(crossing[k], number + 2 * facing);
      if (n > 0) return;
    }
    for (int rim = 0; rim < other.rims(); ++rim) {
      if (part != DiscPart::side && rim != facing) continue;
      if (other.radius(rim) > 0.0) {
        if (other.touches(-towards)) take(other.rim(rim, -towards), number + 2 * rim);
      } else {
        pointOverSide(one, other, rim, number + 2 * rim, sign);
      }
    }
  }
  /// The line of a cone's side that looks along d, from the rim to the tip.
  static Vec3 sideAlong(const DiscBody& cone, const Vec3& d) {
    return cone.cosine() * cone.a - cone.sine() * cone.acrossAxis(d).normalized();
  }
  bool rimOnSide(const DiscBody& one, const BodyCurve& rim, const Vec3& towards,
                 ContactPoint& at) const {
    if (one.tip) {
      double s = 0.0;
      // Deep inside a slim cone the rim is past its axis: the line of the side that faces it is behind.
      const bool past = one.acrossAxis(rim.x - one.c).dot(one.acrossAxis(towards)) < 0.0 &&
                        std::abs(rim.t.dot(towards)) < kStationary;
      return (past ? placeOnSide(one, rim, -1.0, s, at) : circleOnSide(one, rim, s, at)) &&
             onLine(one, s);
    }
    BodyCurve a = one.axis(), b = rim;
    a.go(a.t.dot(b.x - a.x));
    if (!toClosest(a, b) || !within(one, a.x)) return false;
    at = curveOnCurve(a, b, towards);
    return true;
  }
  void pointOverSide(const DiscBody& one, const DiscBody& other, int rim, int id, double sign) {
    const Vec3 p = other.middle(rim);
    double s = 0.0;
    if (one.tip) {
      const ContactPoint at = pointOnSide(one, *other.frame, p, other.r, s);
      if (onLine(one, s)) add(id, at, sign);
    } else if (within(one, p)) {
      add(id, pointOnCurve(one.axis(), *other.frame, p, other.r, sign * n_), sign);
    }
  }

  /// If features fit only up to rounding: a rim beside a cap, else the outermost points.
  void any() {
    over(A_, B_, 1.0, false, kInfinity), over(B_, A_, -1.0, false, kInfinity);
    if (found_.size() == 0) outermostPoints();
  }
  /// A single contact: B's outermost point and the plane through that of A, n fixed in A.
  int outermostPoints() {
    const int j = B_.rimAlong(-n_);
    NumberedContact& c = out_[0];
    c.id = kOnA.rims + j;
    setDirections(c.at, n_, A_.frame->Omega_I.cross(n_), Vec3::Zero());
    wander(B_, j, c.at);
    c.at.g = n_.dot(c.at.P) - A_.support(n_);
    if (found_.size() == 0) found_.takes(x_.dot(c.at.P), y_.dot(c.at.P));
    return 1;
  }

  const DiscBody &A_, &B_;
  Vec3 n_;
  double f_, same_, loose_;
  Vec3 x_, y_;
  Manifold<kMostDiscContacts> found_;
  DiscContacts& out_;
};

}  // namespace

int betweenDiscs(const DiscBody& A, const DiscBody& B, double reach, double close, bool rates,
                 DiscContacts& out) {
  const double same = kSameFeature * std::min(A.thickness(), B.thickness());
  const DiscsApart apart = furthestApart(A, B, 4.0 * same, reach);
  if (apart.f > reach) return 0;
  const int n = Contacts(A, B, apart, same, out).all();
  const bool onA = A.part(apart.n) == DiscPart::cap;
  if (!onA && B.part(-apart.n) != DiscPart::cap) return n;
  const DiscBody& flat = onA ? A : B;
  closeTogetherOn(*flat.frame, close, rates, std::span(out.data(), static_cast<std::size_t>(n)),
                  [&](Vec3& normal, Vec3& t) {
                    normal = flat.a.dot(normal) < 0.0 ? Vec3(-flat.a) : flat.a;
                    t = flat.x;
                  });
  return n;
}

double separation(const DiscBody& A, const DiscBody& B) {
  return furthestApart(A, B, 0.0, kInfinity).f;
}

}  // namespace dynamy
