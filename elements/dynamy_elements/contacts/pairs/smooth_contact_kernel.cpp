#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>
#include <dynamy_elements/contacts/pairs/smooth_search.hpp>
#include <limits>
#include <numbers>

namespace dynamy {

using namespace smooth;

namespace {

/// Angle to the normal of a cap at which a search beside it begins [rad].
constexpr double kBesideCap = 1e-3;
/// Part of the size by which features may miss the outermost points along their normal.
constexpr double kOutermost = 1e-9;
/// Number of directions around a cone that are tried; the search begins with the best of them.
constexpr int kTurns = 8;
/// Rounding of a gap, relative to the coordinates that it is computed from.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
/// Number of edges and corners that are tried first: those nearest to the middle of a feature.
constexpr int kFirst = 3;

}  // namespace

ContactPoint betweenSmooth(const Frame& fA, const SupportFeature& a, const Frame& fB,
                           const SupportFeature& b) {
  const smooth::Placed A{fA, a}, B{fB, b};
  const Vec3 way = B.centre() - A.centre();
  return smooth::betweenFrom(A, B, way.norm() > 0.0 ? Vec3(way.normalized()) : Vec3(Vec3::UnitZ()));
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

/// Contact with the side of the cone A: f' = cos β t·y, f'' = −cos β (cos β t·H t + e·y), by angle.
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
  // ν, the rate at which e turns relative to the body, follows from t·y = 0 for all times.
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

/// Search of the largest separation of a round body and a feature among candidates.
class OnDisc {
 public:
  OnDisc(const DiscBody& A, const Placed& B) : A_(A), B_(B) {}

  ContactPoint best() {
    if (A_.rho > 0.0)
      for (const double side : {1.0, -1.0})
        if (!(A_.tip && side > 0.0)) cap(side * A_.a);
    if (A_.tip && !nearest_)
      take(onSide(A_, B_), 0.0);
    else if (A_.half > 0.0 && !nearest_)
      take(onPoint(*A_.frame, A_.c, B_, &A_.a), A_.rho + A_.r);
    const int near = A_.rims() == 2 && A_.a.dot(B_.centre() - A_.c) > 0.0 ? 1 : 0;
    if (!nearest_) rim(near);
    if (!nearest_ && A_.rims() == 2) rim(1 - near);
    if (nearest_) return best_;
    // For deep overlap the largest separation need not be a gap of the features found. Then n is
    // fixed in A, and the outermost points count.
    const Vec3 n = best_.d[0];
    if (best_.g - most_ <= kOutermost * (A_.half + A_.rho + A_.r)) return best_;
    return overPlane(*A_.frame, n, A_.support(n) * n, B_);
  }

 private:
  /// Takes a candidate. `tube`: radius of the tube around the feature that touches.
  void take(ContactPoint at, double tube) {
    const Vec3& n = at.d[0];
    at.g -= tube;
    const double f = n.dot(B_.point(-n)) - A_.support(n);
    if (!(f > most_)) return;
    most_ = f, best_ = at;
    // The bodies are apart by at least f. If the point opposite to B's point
    // belongs to A, this is their distance.
    const Vec3 q = at.P - at.g * n;
    const double rounding = kRounding * (q.cwiseAbs().maxCoeff() + A_.half + A_.rho + A_.r);
    nearest_ = f > 0.0 && at.g - f <= rounding && (q - A_.nearest(q)).norm() <= A_.r + rounding;
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
    // The search begins from the point of the rim nearest to the middle of
    // B, and from beside the cap.
    const bool up = !A_.tip && (i == 1 || A_.a.dot(way) > 0.0);
    const Vec3 n = up ? A_.a : Vec3(-A_.a);
    const Vec3 e = A_.acrossAxis(way), u = A_.acrossAxis(B_.point(-n) - o);
    for (const Vec3& start : {e.norm() > 0.0 ? Vec3(way - A_.rho * e.normalized()) : way,
                              u.norm() > A_.rho ? Vec3(n + kBesideCap * u.normalized()) : way})
      if (start.norm() > 0.0 && !nearest_) take(betweenFrom(a, B_, start.normalized()), 0.0);
  }

  const DiscBody& A_;
  const Placed& B_;
  double most_ = -std::numeric_limits<double>::infinity();
  ContactPoint best_;
  bool nearest_ = false;  // best_ is proven to be the nearest
};

/// Edges and corners of a polyhedron that may be nearest to a feature. If the bodies are apart and
/// the normal of such a contact points out of the polyhedron, its gap is their distance.
class OnEdges {
 public:
  OnEdges(const PlacedPolyhedron& A, const Placed& B) : A_(A), B_(B), body_(*A.of) {}

  ContactPoint best(const ContactPoint& onFace) {
    best_ = onFace;
    const int edges = static_cast<int>(body_.edges().size()),
              corners = static_cast<int>(body_.corners().size());
    nearMiddle();
    for (const Near& near : first_)
      if (near.i >= 0 && !found_) tryOne(near.i);
    for (int i = 0; i < edges + corners && !found_; ++i) tryOne(i);
    return best_;
  }

 private:
  struct Near {
    double square = std::numeric_limits<double>::infinity();
    int i = -1;  // number of an edge; numbers of corners follow
  };
  /// Fills first_ with the candidates nearest to the middle of B, in ascending order.
  void nearMiddle() {
    const Vec3 p = A_.R.transpose() * (B_.centre() - A_.c);
    const auto enter = [this](double square, int i) {
      Near other{square, i};
      for (Near& have : first_)
        if (other.square < have.square) std::swap(other, have);
    };
    const int edges = static_cast<int>(body_.edges().size());
    for (int i = 0; i < static_cast<int>(body_.corners().size()); ++i)
      enter((p - body_.corner(i)).squaredNorm(), edges + i);
    for (int i = 0; i < edges; ++i) {
      const Polyhedron::Edge& e = body_.edge(i);
      const Vec3 way = p - e.middle;
      const double along = std::clamp(way.dot(e.e), -e.half, e.half);
      enter((way - along * e.e).squaredNorm(), i);
    }
  }
  void tryOne(int i) {
    const int edges = static_cast<int>(body_.edges().size());
    i < edges ? edge(i) : corner(i - edges);
  }
  void take(const ContactPoint& at) {
    if (at.g > best_.g) best_ = at, found_ = at.g > 0.0;
  }
  void edge(int i) {
    const Polyhedron::Edge& e = body_.edge(i);
    const PlacedEdge edge = A_.edge(i);
    const Vec3 way = A_.R.transpose() * (B_.centre() - edge.o);
    if (body_.face(e.f).n.dot(way) < 0.0 && body_.face(e.g).n.dot(way) < 0.0) return;
    const ContactPoint at = onPoint(*A_.frame, edge.o, B_, &edge.e);
    const Vec3 n = A_.R.transpose() * at.d[0];
    const double least =
        std::min(body_.face(e.f).n.cross(n).dot(e.e), n.cross(body_.face(e.g).n).dot(e.e));
    const bool over = std::abs(edge.e.dot(at.P - edge.o)) <= (1.0 + kOnBorder) * edge.half;
    if (least >= -kOnBorder && over) take(at);
  }
  void corner(int i) {
    const ContactPoint at = onPoint(*A_.frame, A_.vertex(i), B_, nullptr);
    const Vec3 n = A_.R.transpose() * at.d[0];
    for (const int k : body_.neighbours(i)) {
      const Vec3 side = body_.corner(k) - body_.corner(i);
      if (n.dot(side) > kOnBorder * side.norm()) return;
    }
    take(at);
  }

  const PlacedPolyhedron& A_;
  const Placed& B_;
  const Polyhedron& body_;
  std::array<Near, kFirst> first_;
  ContactPoint best_;
  bool found_ = false;
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
  // Of the faces over which B's outermost point lies, the one that
  // separates most; and the highest face.
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
    const Vec3 n = A.R * body.face(i).n;
    return overPlane(*A.frame, n, A.c + body.face(i).height * n, b);
  };
  if (under >= 0 && most >= height - 1e-12 * body.halfWidth()) return onFace(under);

  // Of the edges and corners whose normal points out of the polyhedron, the one that separates
  // most. For deep overlap there may be none, or one that separates less than a face.
  return OnEdges(A, b).best(onFace(highest));
}

}  // namespace dynamy
