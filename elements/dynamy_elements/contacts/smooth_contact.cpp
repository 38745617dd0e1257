#include <cmath>
#include <dynamy_elements/contacts/segments.hpp>
#include <dynamy_elements/contacts/smooth_contact.hpp>
#include <limits>
#include <numbers>

namespace dynamy {
namespace {

/// Newton's steps; from the line of the centres about six are enough.
constexpr int kSteps = 50;
/// Of the unit vector: a step below which n is found.
constexpr double kFound = 1e-15;
/// Of the unit vector: a step that changes f by less than its rounding.
constexpr double kFlat = 1e-7;
/// Angle beside a cap [rad].
constexpr double kBesideCap = 1e-3;
/// Directions around a cone, the best of which begins.
constexpr int kTurns = 8;

/// A feature in the world.
struct Placed {
  const Frame& frame;
  const SupportFeature& feature;
  Vec3 centre() const { return frame.r_OS_I + frame.A_IK * feature.c_K; }
  Vec3 point(const Vec3& d) const {
    return frame.r_OS_I + frame.A_IK * feature.point(frame.A_IK.transpose() * d);
  }
  Mat3 derivative(const Vec3& d) const {
    const Mat3& R = frame.A_IK;
    return R * feature.pointDerivative(R.transpose() * d) * R.transpose();
  }
  Vec3 velocity(const Vec3& p) const { return frame.velocity(p - frame.r_OS_I); }
};

/// Where n may go: two directions across it, or one across it and the edge `e`.
struct Tangents {
  Eigen::Matrix<double, 3, 2> T;
  int count;
  Tangents(const Vec3& n, const Vec3* e) : count(e ? 1 : 2) {
    const Vec3 t = e ? Vec3(e->cross(n)) : n.unitOrthogonal();
    T << t, n.cross(t);
  }
  /// (Tᵀ H T + f I)⁻¹ Tᵀ r, as a vector in space.
  Vec3 solve(const Mat3& H, double f, const Vec3& r) const {
    Eigen::Matrix2d K = T.transpose() * H * T + f * Eigen::Matrix2d::Identity();
    Eigen::Vector2d rhs = T.transpose() * r;
    if (count == 1) K(0, 1) = K(1, 0) = rhs[1] = 0.0, K(1, 1) = 1.0;
    // Deep inside f is no longer concave: along the gradient.
    if (!(K(0, 0) > 0.0 && K.determinant() > 0.0)) K = K.norm() * Eigen::Matrix2d::Identity();
    return T * (K.inverse() * rhs);
  }
};

/// n that separates A and B most, from the start n; A's point is fixed to be `at` if `a` is null.
class Search {
 public:
  Search(const Placed* a, const Vec3& at, const Placed& b, const Vec3* e)
      : a_(a), at_(at), b_(b), e_(e) {}
  Vec3 y(const Vec3& n) const { return b_.point(-n) - (a_ ? a_->point(n) : at_); }
  Mat3 H(const Vec3& n) const {
    const Mat3 ofB = b_.derivative(-n);
    return a_ ? Mat3(ofB + a_->derivative(n)) : ofB;
  }
  Vec3 best(Vec3 n) const {
    double f = n.dot(y(n));
    for (int i = 0; i < kSteps; ++i) {
      const Vec3 step = Tangents(n, e_).solve(H(n), f, y(n));
      double part = 1.0;
      Vec3 next = (n + step).normalized();
      double g = next.dot(y(next));
      // Shorter until it separates more, up to rounding.
      for (; part > 1e-3 && !(g >= f - 1e-15 * std::abs(f)); g = next.dot(y(next)))
        part *= 0.5, next = (n + part * step).normalized();
      if (part <= 1e-3) {
        // f is flat here to its rounding, its gradient is not.
        if (step.norm() < kFlat) n = (n + step).normalized();
        break;
      }
      n = next, f = g;
      if (step.norm() < kFound) break;
    }
    return n;
  }

 private:
  const Placed* a_;
  Vec3 at_;
  const Placed& b_;
  const Vec3* e_;
};

/// How the motion of A's side enters: velocity of its point, H_A (Ω_A × n), and the turn that n
/// makes because it stays across an edge.
struct OfA {
  Vec3 v, wander = Vec3::Zero(), ndot0 = Vec3::Zero();
};

ContactPoint contactAt(const Vec3& n, const Vec3& y, const Mat3& H, const Mat3& HB, const OfA& A,
                       const Placed& B, const Tangents& t) {
  ContactPoint out;
  out.g = n.dot(y), out.P = B.point(-n);
  const Vec3 turn = B.frame.Omega_I.cross(n), vB = B.velocity(out.P);
  const Vec3 ndot = A.ndot0 + t.solve(H, out.g, vB - A.v + HB * turn + A.wander - H * A.ndot0);
  setDirections(out, n, ndot, Vec3::Zero());
  out.Pdot = vB - HB * (ndot - turn);
  return out;
}

/// Feature of B on a point that moves with A: a corner, or (with `e`) on an edge through it.
ContactPoint onPoint(const Frame& A, const Vec3& p, const Placed& B, const Vec3* e) {
  const Vec3 way = B.centre() - p;
  const Vec3 start = e ? Vec3(way - way.dot(*e) * *e) : way;
  const Vec3 n = Search(nullptr, p, B, e).best(start.normalized());
  // The point of the line that is opposite to B's.
  const Vec3 foot = e ? Vec3(p + (B.point(-n) - p).dot(*e) * *e) : p;
  OfA ofA{A.velocity(foot - A.r_OS_I)};
  if (e) ofA.ndot0 = -n.dot(A.Omega_I.cross(*e)) * *e;
  const Mat3 HB = B.derivative(-n);
  return contactAt(n, B.point(-n) - foot, HB, HB, ofA, B, Tangents(n, e));
}

}  // namespace

namespace {

ContactPoint betweenSmoothFrom(const Placed& A, const Placed& B, const Vec3& start) {
  const Search search(&A, Vec3::Zero(), B, nullptr);
  const Vec3 n = search.best(start);
  const Mat3 HA = A.derivative(n), HB = B.derivative(-n);
  const OfA ofA{A.velocity(A.point(n)), HA * A.frame.Omega_I.cross(n)};
  return contactAt(n, search.y(n), HA + HB, HB, ofA, B, Tangents(n, nullptr));
}

}  // namespace

ContactPoint betweenSmooth(const Frame& fA, const SupportFeature& a, const Frame& fB,
                           const SupportFeature& b) {
  const Placed A{fA, a}, B{fB, b};
  const Vec3 way = B.centre() - A.centre();
  return betweenSmoothFrom(A, B, way.norm() > 0.0 ? Vec3(way.normalized()) : Vec3(Vec3::UnitZ()));
}

namespace {

/// Normals of a cone's side, n = cos β e + sin β a, and how much they separate B from its tip.
struct OverSide {
  Vec3 e, t, n, y;
  OverSide(const DiscBody& A, const Placed& B, const Vec3& direction)
      : e(direction),
        t(A.a.cross(e)),
        n(A.cosine() * e + A.sine() * A.a),
        y(B.point(-n) - A.middle(1)) {}
  double f() const { return n.dot(y); }
};

/// Across the side of the cone A: f' = cos β t·y, f'' = −cos β (cos β t·H t + e·y), by angle.
ContactPoint onSide(const DiscBody& A, const Placed& B) {
  const Vec3 way = A.acrossAxis(B.centre() - A.c);
  OverSide at(A, B, way.norm() > 0.0 ? Vec3(way.normalized()) : A.x);
  const auto turned = [&](double angle) {
    return OverSide(A, B, (std::cos(angle) * at.e + std::sin(angle) * at.t).normalized());
  };
  OverSide best = at;
  for (int k = 1; k < kTurns; ++k)
    if (const OverSide other = turned(2.0 * std::numbers::pi * k / kTurns); other.f() > best.f())
      best = other;
  at = best;
  const double cosine = A.cosine();
  const auto bend = [&] { return cosine * at.t.dot(B.derivative(-at.n) * at.t) + at.e.dot(at.y); };
  for (int i = 0; i < kSteps; ++i) {
    const double K = bend(), slope = at.t.dot(at.y);
    double step = std::clamp(K > 0.0 ? slope / K : std::copysign(0.5, slope), -0.5, 0.5);
    OverSide next = turned(step);
    while (std::abs(step) > kFlat && next.f() < at.f()) step *= 0.5, next = turned(step);
    at = next;
    if (std::abs(step) < kFound) break;
  }
  // t·y = 0 for all times: e turns by ν beside the body.
  const Mat3 H = B.derivative(-at.n);
  const Vec3 &n = at.n, &t = at.t, &OmegaA = A.frame->Omega_I, tip = A.middle(1);
  ContactPoint out;
  out.g = at.f(), out.P = B.point(-n);
  const Vec3 vB = B.velocity(out.P), w = vB - A.frame->velocity(tip - A.frame->r_OS_I);
  const Vec3 turn = B.frame.Omega_I.cross(n);
  const double nu = (t.dot(w - H * (OmegaA.cross(n) - turn)) + at.y.dot(OmegaA.cross(t))) / bend();
  const Vec3 ndot = OmegaA.cross(n) + nu * cosine * t;
  setDirections(out, n, ndot, Vec3::Zero());
  out.Pdot = vB - H * (ndot - turn);
  return out;
}

/// Candidates for the largest separation of a round body and a feature.
class OnDisc {
 public:
  OnDisc(const DiscBody& A, const Placed& B) : A_(A), B_(B) {}

  ContactPoint best() {
    if (A_.rho > 0.0)
      for (const double side : {1.0, -1.0})
        if (!(A_.tip && side > 0.0)) cap(side * A_.a);
    if (A_.tip)
      take(onSide(A_, B_), 0.0);
    else if (A_.half > 0.0)
      take(onPoint(*A_.frame, A_.c, B_, &A_.a), A_.rho + A_.r);
    for (int i = 0; i < A_.rims(); ++i) rim(i);
    return best_;
  }

 private:
  /// `tube`: around what the contact was found on.
  void take(ContactPoint at, double tube) {
    const Vec3& n = at.d[0];
    at.g -= tube;
    const double f = n.dot(B_.point(-n)) - A_.support(n);
    if (f > most_) most_ = f, best_ = at;
  }
  void cap(const Vec3& n) {
    const PlacedFace face(*A_.frame, n, A_.c, A_.half + A_.r, A_.x, 1.0, true);
    ContactPoint at;
    face.contact(B_.frame, B_.point(-n), at);
    at.Pdot -= B_.derivative(-n) * (at.ddot[0] - B_.frame.Omega_I.cross(n));
    take(at, 0.0);
  }
  void rim(int i) {
    const Vec3 o = A_.middle(i), way = B_.centre() - o;
    if (A_.radius(i) == 0.0) return take(onPoint(*A_.frame, o, B_, nullptr), A_.r);
    SupportFeature circle;
    circle.kind = SupportFeature::Kind::rim;
    circle.c_K = A_.frame->A_IK.transpose() * (o - A_.frame->r_OS_I);
    circle.axis_K = A_.frame->A_IK.transpose() * A_.a;
    circle.rho = A_.rho, circle.radius = A_.r;
    const Placed a{*A_.frame, circle};
    // From the point of the rim that is nearest to the middle of B, and from beside the cap.
    const bool up = !A_.tip && (i == 1 || A_.a.dot(way) > 0.0);
    const Vec3 n = up ? A_.a : Vec3(-A_.a);
    const Vec3 e = A_.acrossAxis(way), u = A_.acrossAxis(B_.point(-n) - o);
    for (const Vec3& start : {e.norm() > 0.0 ? Vec3(way - A_.rho * e.normalized()) : way,
                              u.norm() > A_.rho ? Vec3(n + kBesideCap * u.normalized()) : way})
      if (start.norm() > 0.0) take(betweenSmoothFrom(a, B_, start.normalized()), 0.0);
  }

  const DiscBody& A_;
  const Placed& B_;
  double most_ = -std::numeric_limits<double>::infinity();
  ContactPoint best_;
};

}  // namespace

ContactPoint smoothOnDisc(const DiscBody& A, const Frame& B, const SupportFeature& feature) {
  const Placed b{B, feature};
  return OnDisc(A, b).best();
}

ContactPoint discOnSmooth(const Frame& A, const SupportFeature& feature, const DiscBody& B) {
  ContactPoint at = smoothOnDisc(B, A, feature);
  turnRound(at);
  return at;
}

ContactPoint smoothOnPolyhedron(const PlacedPolyhedron& A, const Frame& B,
                                const SupportFeature& feature) {
  const Placed b{B, feature};
  const Polyhedron& body = *A.of;
  // The face over which B's outermost point lies and that separates most, else the highest.
  int under = -1, highest = 0;
  double most = -std::numeric_limits<double>::infinity(), height = most;
  for (int i = 0; i < static_cast<int>(body.faces().size()); ++i) {
    const Polyhedron::Face& f = body.face(i);
    const Vec3 p = A.R.transpose() * (b.point(-(A.R * f.n)) - A.c);
    const double h = f.n.dot(p) - f.height;
    if (h > height) height = h, highest = i;
    if (h > most && body.over(f, p, 0.0)) most = h, under = i;
  }
  const auto onFace = [&](int i) {
    ContactPoint out;
    A.face(i, 1.0, false).contact(B, b.point(-(A.R * body.face(i).n)), out);
    const Vec3 n = out.d[0], ndot = A.frame->Omega_I.cross(n);
    setDirections(out, n, ndot, Vec3::Zero());
    out.Pdot = b.velocity(out.P) - b.derivative(-n) * (ndot - B.Omega_I.cross(n));
    return out;
  };
  if (under >= 0 && most >= height - 1e-12 * body.halfWidth()) return onFace(under);

  // An edge or corner: the smallest gap of those whose normal points out of the polyhedron.
  ContactPoint best;
  best.g = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(body.edges().size()); ++i) {
    const Polyhedron::Edge& e = body.edge(i);
    const PlacedEdge edge = A.edge(i);
    const Vec3 way = A.R.transpose() * (b.centre() - edge.o);
    if (body.face(e.f).n.dot(way) < 0.0 && body.face(e.g).n.dot(way) < 0.0) continue;
    const ContactPoint at = onPoint(*A.frame, edge.o, b, &edge.e);
    const Vec3 n = A.R.transpose() * at.d[0];
    const bool inWedge =
        body.face(e.f).n.cross(n).dot(e.e) >= 0.0 && n.cross(body.face(e.g).n).dot(e.e) >= 0.0;
    if (inWedge && std::abs(edge.e.dot(at.P - edge.o)) <= edge.half && at.g < best.g) best = at;
  }
  for (int i = 0; i < static_cast<int>(body.corners().size()); ++i) {
    const ContactPoint at = onPoint(*A.frame, A.vertex(i), b, nullptr);
    const Vec3 n = A.R.transpose() * at.d[0];
    bool inCone = true;
    for (const int k : body.neighbours(i))
      inCone = inCone && n.dot(body.corner(k) - body.corner(i)) <= 0.0;
    if (inCone && at.g < best.g) best = at;
  }
  return std::isfinite(best.g) ? best : onFace(under >= 0 ? under : highest);
}

}  // namespace dynamy
