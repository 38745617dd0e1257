#include <array>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/pairs/disc_arc.hpp>
#include <dynamy_elements/contacts/pairs/disc_separation.hpp>

namespace dynamy {
namespace {

using DiscPart = DiscBody::Part;

/// Number of directions of the grid, on the half of the sphere that faces from A to B.
constexpr int kGrid = 60;
constexpr double kGoldenAngle = 2.399963229728653;
/// Angle to the normal of a cap at which a search beside it begins [rad].
constexpr double kBesideEdge = 1e-3;
/// Most steps of Newton's method between two rims.
constexpr int kDiscSteps = 50;
/// A step of Newton's method this short is the last: its error is its square times at most the inverse
/// of the angle to a ridge.
constexpr double kLastDiscStep = 1e-12;
/// Steps from one body to the nearest point of the other, in search of two near points. Where axes
/// cross at a right angle, two are enough.
constexpr int kNearSteps = 2, kNearerSteps = 8;
/// Part of the bodies' size by which they are moved apart in this search.
constexpr double kApart = 0.1;
/// Part of the bodies' sizes up to which directions of contacts separate equally: bodies that touch
/// overlap by rounding, which no points prove. Gaps do up to rounding.
constexpr double kSame = 1e-11, kSameGap = 2.0 * kEpsilon;
/// Sine to a side up to which it may face the other body along the way between near points.
constexpr double kNearSide = 0.3;
/// Sine between two planes or tangents below which their cross product is mostly rounding.
constexpr double kLeastCross = 1e-8;

/// Directions on the half of the sphere around z, evenly spread on a spiral.
std::array<Vec3, kGrid> directions() {
  std::array<Vec3, kGrid> all;
  for (int k = 0; k < kGrid; ++k) {
    const double up = (k + 0.5) / kGrid, out = std::sqrt(1.0 - up * up), turn = kGoldenAngle * k;
    all[static_cast<std::size_t>(k)] = {out * std::cos(turn), out * std::sin(turn), up};
  }
  return all;
}

/// Outermost point of a disc along d; its middle for a direction along its axis.
Vec3 outermost(const DiscBody& D, int rim, const Vec3& d) {
  const Vec3 v = D.acrossAxis(d);
  const double s = v.norm();
  return s > 0.0 ? Vec3(D.middle(rim) + D.radius(rim) * unitAcross(v, D.a)) : D.middle(rim);
}

/// Search of the direction of largest separation among candidates. It ends as soon as two points,
/// one of each body, are no further apart than the separation found, since no direction separates
/// them by more.
class DiscSearch {
 public:
  DiscSearch(const DiscBody& A, const DiscBody& B)
      : A_(A), B_(B), size_(std::max(A.half + A.rho + A.r, B.half + B.rho + B.r)) {}

  /// Caps come first: another direction has to separate by more than `more`. A separation above `enough`
  /// need not be the largest one.
  DiscsApart best(double more, double enough) {
    enough_ = enough, same_ = (more > 0.0 ? kSame : kSameGap) * size_;
    for (const DiscBody* body : {&A_, &B_})
      if (body->rho > 0.0)
        for (const double side : {1.0, -1.0})
          if (!(body->tip && side > 0.0)) take((body == &A_ ? side : -side) * body->a);
    least_ = best_.f + more;
    if (isLargest(std::max(more, same_)) || atNearPoints()) return best_;
    if (A_.half > 0.0) across(A_, B_, 1.0);
    if (B_.half > 0.0) across(B_, A_, -1.0);
    if (!isLargest(same_)) rims();
    return best_;
  }

 private:
  /// Do near points show that no direction separates by more than `more` beyond the best one? The
  /// search for them begins at the outermost points and between the sides. The way between them is a
  /// direction itself. Also true if a direction separates by more than is enough.
  bool isLargest(double more) {
    if (best_.f > enough_) return true;
    const Vec3 n = best_.n;
    return isNear(outermost(B_, B_.rimAlong(-n), -n), more) ||
           isNear(B_.nearest(outermost(A_, A_.rimAlong(n), n)), more) ||
           (A_.part(n) == DiscPart::side && B_.part(-n) == DiscPart::side &&
            isNear(B_.nearest(betweenSides()), more));
  }
  bool isNear(Vec3 b, double more) {
    const double most = best_.f + more + A_.r + B_.r;
    Vec3 a = b;
    for (int k = 0; k < kNearSteps; ++k) {
      a = A_.nearest(b);
      if ((b - a).norm() <= most) return true;
      b = B_.nearest(a);
      if ((b - a).norm() <= most) return true;
    }
    const Vec3 n = (b - a).normalized();
    const double s = f(n);
    if (s > enough_) best_ = {s, n};
    return s > enough_;
  }
  /// The point of B's side where the lines of both sides cross, seen along the best direction.
  Vec3 betweenSides() const {
    const double cosine = A_.a.dot(B_.a), square = 1.0 - cosine * cosine;
    const Vec3 way = B_.c - A_.c;
    const double t = square > kLeastCross ? (cosine * A_.a.dot(way) - B_.a.dot(way)) / square : 0.0;
    return B_.c + std::clamp(t, -B_.half, B_.half) * B_.a - B_.rho * best_.n;
  }
  /// The way between two near points; zero: they overlap.
  Vec3 nearWay() const {
    Vec3 b = B_.nearest(A_.c), a = A_.nearest(b);
    for (int k = 0; k < kNearSteps; ++k) b = B_.nearest(a), a = A_.nearest(b);
    if (!((b - a).norm() > 0.0)) return Vec3::Zero();
    // Bodies that touch are moved apart, since steps between near ones become short.
    const Vec3 shift = kApart * size_ * (b - a).normalized();
    b += shift;
    for (int k = 0; k < kNearerSteps; ++k) a = A_.nearest(b), b = shift + B_.nearest(a - shift);
    return b - a;
  }
  /// Takes the directions of the features that face each other along the way between two near points.
  /// True: the largest is found.
  bool atNearPoints() {
    const Vec3 n = nearWay().normalized();
    if (!(n.squaredNorm() > 0.0)) return false;
    double before = best_.f;
    const auto proven = [&] {
      const bool better = best_.f > before;
      before = best_.f;
      return better && isLargest(same_);
    };
    const bool ofA = isBeside(A_, n), ofB = isBeside(B_, -n);
    if (ofA && ofB && !A_.tip && !B_.tip) acrossBoth(n);
    if (ofA && ofB && proven()) return true;
    if (ofA) nearSide(A_, B_, 1.0, n);
    if (ofA && proven()) return true;
    if (ofB) nearSide(B_, A_, -1.0, n);
    if (ofB && proven()) return true;
    const int i = A_.rimAlong(n), j = B_.rimAlong(-n);
    if (A_.radius(i) == 0.0 || B_.radius(j) == 0.0) {
      fromPoint(i, j);
    } else {
      take(between(i, j, n));
      if (A_.r == 0.0 && B_.r == 0.0) atCrossing(i, j);
    }
    if (proven()) return true;
    besideCap(A_, B_, 1.0), besideCap(B_, A_, -1.0);
    return proven();
  }
  /// May the side of `one` face d?
  static bool isBeside(const DiscBody& one, const Vec3& d) {
    return one.half > 0.0 && std::abs(one.fromSide(d)) < kNearSide;
  }
  /// The normal of both sides near n.
  void acrossBoth(const Vec3& n) {
    const Vec3 cross = A_.a.cross(B_.a);
    if (const double s = cross.norm(); s > kLeastCross)
      take((cross.dot(n) > 0.0 ? 1.0 : -1.0) / s * cross);
  }
  double f(const Vec3& n) const { return -B_.support(-n) - A_.support(n); }
  void take(const Vec3& n) {
    if (const double s = f(n); s > std::max(best_.f, least_)) best_ = {s, n};
  }
  static DiscArc normalsOf(const DiscBody& one, const DiscBody& other) {
    const Vec3 x = one.cosine() * one.a.unitOrthogonal(), o = one.tip ? one.middle(1) : one.c;
    return {other, x, one.a.cross(x), other.c - o, one.sine() * one.a};
  }
  /// The top near n of those that across() finds.
  void nearSide(const DiscBody& one, const DiscBody& other, double sign, const Vec3& n) {
    const DiscArc arc = normalsOf(one, other);
    arc.topNear(std::atan2(sign * n.dot(arc.m), sign * n.dot(arc.n0)),
                [&](const Vec3& at) { take(sign * at); });
  }
  /// Directions across the axis of `one`; `sign` +1: a normal n from `one` to `other` is that from
  /// A to B.
  void across(const DiscBody& one, const DiscBody& other, double sign) {
    normalsOf(one, other)
        .tops(2.0 * std::numbers::pi, std::max(best_.f, least_),
              [&](const Vec3& n, double) { take(sign * n); });
  }
  void rims() {
    const Vec3 way = B_.c - A_.c;
    if (!(way.norm() > 0.0)) return;
    const Vec3 z = way.normalized(), x = z.unitOrthogonal(), y = z.cross(x);
    DiscsApart start[2][2];
    static const std::array<Vec3, kGrid> grid = directions();
    for (const Vec3& g : grid) {
      const Vec3 n = g.z() * z + g.x() * x + g.y() * y;
      DiscsApart& of = start[A_.rimAlong(n)][B_.rimAlong(-n)];
      if (const double s = f(n); s > of.f) of = {s, n};
    }
    for (int i = 0; i < A_.rims(); ++i)
      for (int j = 0; j < B_.rims(); ++j)
        if (A_.radius(i) == 0.0 || B_.radius(j) == 0.0)
          fromPoint(i, j);
        else if (start[i][j].f > -kInfinity)
          take(between(i, j, start[i][j].n));
    besideCap(A_, B_, 1.0), besideCap(B_, A_, -1.0);
    if (A_.r > 0.0 || B_.r > 0.0) return;
    for (int i = 0; i < A_.rims(); ++i)
      for (int j = 0; j < B_.rims(); ++j)
        if (A_.radius(i) > 0.0 && B_.radius(j) > 0.0) atCrossing(i, j);
  }
  /// Rims without tubes touch where both cross the line in which their planes meet. Around it f is
  /// nearly flat along each rim's normals, so that Newton's method may end elsewhere.
  void atCrossing(int i, int j) {
    const Vec3 cross = A_.a.cross(B_.a);
    const double sine = cross.norm();
    if (sine < kLeastCross) return;
    const Vec3 e = cross / sine, oA = A_.middle(i), oB = B_.middle(j), way = oB - oA;
    // From the middles across the line, and along it to the rims.
    const double acrossA = way.dot(B_.a) / sine, acrossB = way.dot(A_.a) / sine;
    const double squareA = A_.rho * A_.rho - acrossA * acrossA,
                 squareB = B_.rho * B_.rho - acrossB * acrossB;
    if (!(squareA > 0.0 && squareB > 0.0)) return;
    const Vec3 toA = acrossA * e.cross(A_.a), toB = acrossB * e.cross(B_.a);
    const double apart = e.dot(way), alongA = std::sqrt(squareA), alongB = std::sqrt(squareB);
    double least = kInfinity, sA = 0.0, sB = 0.0;
    for (const double p : {-alongA, alongA})
      for (const double q : {-alongB, alongB})
        if (const double d = std::abs(apart + q - p); d < least) least = d, sA = p, sB = q;
    BodyCurve a = A_.rim(i, toA + sA * e), b = B_.rim(j, toB + sB * e);
    const auto normal = [&] {
      const Vec3 n = a.t.cross(b.t);
      if (const double s = n.norm(); s > kLeastCross) take(n / s), take(-n / s);
    };
    normal();
    if (toClosest(a, b)) normal();
  }
  /// One of the rims is a point (a tip or an end): the nearest point of the other disc.
  void fromPoint(int i, int j) {
    const bool onA = A_.radius(i) > 0.0;
    const DiscBody& disc = onA ? A_ : B_;
    const Vec3 p = onA ? B_.middle(j) : A_.middle(i), o = disc.middle(onA ? i : j);
    const Vec3 beside = disc.acrossAxis(p - o);
    const double out = beside.norm(), rho = disc.radius(onA ? i : j);
    Vec3 way = p - o - (out > rho ? rho / out : 1.0) * beside;
    // In the plane of the rim's normals: where the bodies touch the rest is rounding.
    const Vec3 e = out > 0.0 ? unitAcross(beside, disc.a) : disc.x;
    way = way.dot(e) * e + way.dot(disc.a) * disc.a;
    if (way.norm() > 0.0) take((onA ? way : Vec3(-way)).normalized());
  }
  /// At a cap f has a maximum or a kink. A search begins beside it, where
  /// the other body is beyond the rim.
  void besideCap(const DiscBody& one, const DiscBody& other, double sign) {
    if (one.rho == 0.0) return;
    const Vec3 a = one.tip || one.a.dot(other.c - one.c) < 0.0 ? Vec3(-one.a) : one.a;
    const Vec3 e = one.acrossAxis(outermost(other, other.rimAlong(-a), -a) - one.c);
    if (!(e.norm() > one.rho)) return;
    const Vec3 n = sign * (a + kBesideEdge * e.normalized()).normalized();
    take(between(A_.rimAlong(n), B_.rimAlong(-n), n));
  }
  Vec3 between(int i, int j, Vec3 n) const;
  bool onRidge(int i, int j, const Vec3& n, double within, double f) const;

  const DiscBody &A_, &B_;
  double size_, same_ = 0.0;
  double least_ = -kInfinity, enough_ = kInfinity;
  DiscsApart best_;
};

/// Outermost point of a disc along d, whose derivative by d is `bend` t tᵀ.
struct OnRim {
  Vec3 x, t = Vec3::Zero();
  double bend = 0.0;
  OnRim(const DiscBody& D, int rim, const Vec3& d) : x(D.middle(rim)) {
    const Vec3 v = D.acrossAxis(d);
    const double s = v.norm(), rho = D.radius(rim);
    if (!(s > 0.0)) return;
    const Vec3 e = unitAcross(v, D.a);
    x += rho * e, t = D.a.cross(e), bend = rho / s;
  }
};

/// |K|⁻¹ g for a symmetric K, whose eigenvalues count by their size.
Eigen::Vector2d solveAbsolute(const Eigen::Matrix2d& K, const Eigen::Vector2d& g) {
  const double det = K.determinant();
  if (det > 0.0) return (K(0, 0) > 0.0 ? 1.0 : -1.0) * (K.inverse() * g);
  // With eigenvalues λ₁ ≥ 0 ≥ λ₂:  |K| = (K² − λ₁ λ₂ I)/(λ₁ − λ₂).
  const double apart = std::hypot(K(0, 0) - K(1, 1), 2.0 * K(0, 1));
  const Eigen::Matrix2d size = (K * K - det * Eigen::Matrix2d::Identity()) / apart;
  return size.inverse() * g;
}

/// Does f have its top at the axis of one of the discs, at an angle to n of less than `within`? It
/// has a ridge there; the rim of the other disc is over this one then. Caps are candidates anyway.
bool DiscSearch::onRidge(int i, int j, const Vec3& n, double within, double f) const {
  const auto top = [&](const DiscBody& one, int k, const DiscBody& other, int l, double sign) {
    if (one.radius(k) == 0.0) return false;
    const Vec3 a = n.dot(one.a) < 0.0 ? Vec3(-one.a) : one.a;
    if ((n - a).norm() > within) return false;
    const Vec3 way = outermost(other, l, -sign * a) - one.middle(k);
    return one.acrossAxis(way).norm() < one.radius(k) && sign * a.dot(way) >= f;
  };
  return top(A_, i, B_, j, 1.0) || top(B_, j, A_, i, -1.0);
}

Vec3 DiscSearch::between(int i, int j, Vec3 n) const {
  const Vec3 way = B_.middle(j) - A_.middle(i);
  const double rhoA = A_.radius(i), rhoB = B_.radius(j), rounding = kEpsilon * size_;
  const auto separation = [&](const Vec3& d) {
    return d.dot(way) - rhoA * A_.acrossAxis(d).norm() - rhoB * B_.acrossAxis(d).norm();
  };
  double f = separation(n);
  for (int step = 0; step < kDiscSteps; ++step) {
    const OnRim a(A_, i, n), b(B_, j, -n);
    Eigen::Matrix<double, 3, 2> T;
    T.col(0) = n.unitOrthogonal(), T.col(1) = n.cross(T.col(0));
    const Eigen::Vector2d tA = T.transpose() * a.t, tB = T.transpose() * b.t,
                          y = T.transpose() * (b.x - a.x);
    const Eigen::Matrix2d K = a.bend * tA * tA.transpose() + b.bend * tB * tB.transpose() +
                              f * Eigen::Matrix2d::Identity();
    // For deep overlap f is no longer concave.
    const bool concave = K(0, 0) > 0.0 && K.determinant() > 0.0;
    const Vec3 go = T * solveAbsolute(K, y);
    if (!go.allFinite()) break;
    double part = std::min(1.0, 0.5 / go.norm());
    Vec3 next = (n + part * go).normalized();
    double g = separation(next);
    if (!(g >= f) && onRidge(i, j, n, go.norm(), f)) break;
    // The step is shortened until it separates more, up to rounding.
    for (; part > 1e-4 && !(g >= f - rounding); g = separation(next))
      part *= 0.5, next = (n + part * go).normalized();
    if (part <= 1e-4) break;
    n = next, f = g;
    if (go.norm() < (concave && part == 1.0 ? kLastDiscStep : 1e-15)) break;
  }
  return n;
}

}  // namespace

DiscsApart furthestApart(const DiscBody& A, const DiscBody& B, double more, double enough) {
  return DiscSearch(A, B).best(more, enough);
}

}  // namespace dynamy
