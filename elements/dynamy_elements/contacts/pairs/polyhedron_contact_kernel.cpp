#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>
#include <limits>

namespace dynamy {
namespace {}  // namespace

int outermost(const Polyhedron& body, const Vec3& d, double& along) {
  int best = 0;
  along = -kInfinity;
  const int n = static_cast<int>(body.corners().size());
  for (int i = 0; i < n; ++i)
    if (const double a = d.dot(body.corner(i)); a > along) along = a, best = i;
  return best;
}

int faceAlong(const Polyhedron& body, const Vec3& n) {
  double along = 0.0, most = -kInfinity;
  int best = 0;
  for (const int f : body.facesAt(outermost(body, n, along)))
    if (const double x = body.face(f).n.dot(n); x > most) most = x, best = f;
  return best;
}

namespace {

/// Most corners of a face for which corners and crossings of edges fit into kMostPolyhedraContacts.
constexpr int kMostCorners = 12;

/// Largest separation among axes of one kind, and the axis; n from A to B in axes of A.
struct Axis {
  double separation = -kInfinity;
  int i = -1, j = -1;
  Vec3 n = Vec3::UnitZ();
};

/// Separations of both polyhedra in axes of A: C = R_Aᵀ R_B, t = R_Aᵀ (c_B − c_A).
struct Separation {
  const Polyhedron &A, &B;
  Mat3 C;
  Vec3 t;
  Separation(const PlacedPolyhedron& a, const PlacedPolyhedron& b)
      : A(*a.of), B(*b.of), C(a.R.transpose() * b.R), t(a.R.transpose() * (b.c - a.c)) {}

  /// Separation along face normals; the search ends once it exceeds `reach`.
  Axis faces(double reach) const {
    Axis best;
    const int nA = static_cast<int>(A.faces().size()), nB = static_cast<int>(B.faces().size());
    double along = 0.0;
    for (int i = 0; i < nA && best.separation <= reach; ++i) {
      const Polyhedron::Face& f = A.face(i);
      outermost(B, -(C.transpose() * f.n), along);
      const double s = f.n.dot(t) - along - f.height;
      if (s > best.separation) best = {s, i, -1, f.n};
    }
    for (int i = 0; i < nB && best.separation <= reach; ++i) {
      const Polyhedron::Face& f = B.face(i);
      const Vec3 n = -(C * f.n);
      outermost(A, n, along);
      const double s = n.dot(t) - along - f.height;
      if (s > best.separation) best = {s, -1, i, n};
    }
    return best;
  }

  /// Pairs of edges whose cross product is a face normal of A − B and
  /// separates by more than `least`.
  Axis edges(double least) const {
    Axis best;
    best.separation = least;
    const int nA = static_cast<int>(A.edges().size()), nB = static_cast<int>(B.edges().size());
    for (int j = 0; j < nB; ++j) {
      const Polyhedron::Edge& b = B.edge(j);
      const Vec3 eB = C * b.e, oB = t + C * b.middle;
      const Vec3 c = -(C * B.face(b.f).n), d = -(C * B.face(b.g).n);
      for (int i = 0; i < nA; ++i) {
        const Polyhedron::Edge& a = A.edge(i);
        // The arcs of the normals cross: the ends of each are on both sides of the other, and they
        // lie on one half of the sphere.
        const double ca = c.dot(a.e), da = d.dot(a.e);
        if (ca * da >= 0.0) continue;
        const double ab = A.face(a.f).n.dot(eB), bb = A.face(a.g).n.dot(eB);
        if (ab * bb >= 0.0 || ca * bb <= 0.0) continue;
        const Vec3 cross = a.e.cross(eB);
        const double square = cross.squaredNorm();
        if (square < kCross * kCross) continue;
        const double sign = cross.dot(A.face(a.f).n + A.face(a.g).n) < 0.0 ? -1.0 : 1.0;
        const double s = sign * cross.dot(oB - a.middle) / std::sqrt(square);
        if (s > best.separation) best = {s, i, j, sign / std::sqrt(square) * cross};
      }
    }
    return best;
  }
};

/// The intersection of two faces seen along the normal of A's. All places are tested
/// in axes of A, where a place without a contact costs a few products. A contact is
/// then computed from the bodies' frames.
class FacePair {
 public:
  FacePair(const PlacedPolyhedron& A, int faceA, const PlacedPolyhedron& B, int faceB,
           const Separation& in, double separation, double same, bool rates, PolyhedraContacts& out)
      : A_(A),
        B_(B),
        a_(A.of->face(faceA)),
        b_(B.of->face(faceB)),
        faceA_(faceA),
        faceB_(faceB),
        in_(in),
        same_(same),
        beside_(besideFace(separation, same)),
        margin_(same),
        separation_(separation),
        rates_(rates),
        found_(4.0 * same),
        out_(out) {
    x_ = A.of->border(a_.first).out, y_ = a_.n.cross(x_);
  }

  int contacts() {
    // If one face lies inside of the other, its vertices are all of the intersection.
    if (!verticesOfB() && !verticesOfA()) edges();
    const std::span<const NumberedContact> taken(out_.data(),
                                                 static_cast<std::size_t>(found_.size()));
    if (beside_ > same_ && isBeside_ && leastGap(taken) > separation_ + same_) {
      margin_ = beside_;
      verticesOfB(), verticesOfA();
    }
    return found_.size();
  }

 private:
  NumberedContact& last() { return out_[static_cast<std::size_t>(found_.size() - 1)]; }
  bool takes(const Vec3& p_A) { return found_.takes(x_.dot(p_A), y_.dot(p_A)); }
  /// Is p, in axes of `body`, over its face f?
  bool over(const Polyhedron& body, const Polyhedron::Face& f, const Vec3& p) {
    if (body.over(f, p, margin_)) return true;
    isBeside_ = isBeside_ || body.over(f, p, beside_);
    return false;
  }
  static int stride(int corners) { return (corners + kMostCorners - 1) / kMostCorners; }

  /// Adds the vertices of B's face that are over A's face; true: all of them are.
  bool verticesOfB() {
    const PlacedFace onA = A_.face(faceA_, 1.0, rates_);
    bool all = true;
    for (int i = 0; i < b_.count; ++i) {
      const int v = B_.of->border(b_.first + i).corner;
      const Vec3 p_A = in_.t + in_.C * B_.of->corner(v);
      const bool inside = over(*A_.of, a_, p_A);
      all = all && inside;
      if (!inside || i % stride(b_.count) != 0 || !takes(p_A)) continue;
      last().id = v;
      onA.contact(*B_.frame, B_.vertex(v), last().at);
    }
    return all;
  }
  bool verticesOfA() {
    const PlacedFace onB = B_.face(faceB_, -1.0, rates_);
    const int corners = static_cast<int>(B_.of->corners().size());
    bool all = true;
    for (int i = 0; i < a_.count; ++i) {
      const int v = A_.of->border(a_.first + i).corner;
      const Vec3 p_A = A_.of->corner(v);
      const bool inside = over(*B_.of, b_, in_.C.transpose() * (p_A - in_.t));
      all = all && inside;
      if (!inside || i % stride(a_.count) != 0 || !takes(p_A)) continue;
      last().id = corners + v;
      onB.contact(*A_.frame, A_.vertex(v), last().at);
    }
    return all;
  }

  void edges() {
    for (int j = b_.first; j < b_.first + b_.count; ++j) {
      const int edgeB = B_.of->border(j).edge;
      const Polyhedron::Edge& b = B_.of->edge(edgeB);
      const PlacedEdge in{in_.t + in_.C * b.middle, in_.C * b.e, b.half};
      for (int i = a_.first; i < a_.first + a_.count; ++i) edge(A_.of->border(i).edge, edgeB, in);
    }
  }
  void edge(int i, int j, const PlacedEdge& b) {
    const Polyhedron::Edge& e = A_.of->edge(i);
    const EdgeCrossing seen({e.middle, e.e, e.half}, b);
    // Only edges count that cross at an angle, with a normal like that of the face.
    if (seen.parallel || std::abs(seen.n.dot(a_.n)) < kLikeFace) return;
    if (std::abs(seen.s) > e.half + same_ || std::abs(seen.t) > b.half + same_) return;
    if (!takes(seen.PB)) return;
    const PlacedEdge edgeA = A_.edge(i), edgeB = B_.edge(j);
    const int corners = static_cast<int>(A_.of->corners().size() + B_.of->corners().size());
    last().id = corners + i * static_cast<int>(B_.of->edges().size()) + j;
    last().at =
        edgeOnEdge(*A_.frame, edgeA, *B_.frame, edgeB, EdgeCrossing(edgeA, edgeB), A_.R * a_.n);
  }

  const PlacedPolyhedron &A_, &B_;
  const Polyhedron::Face &a_, &b_;
  int faceA_, faceB_;
  const Separation& in_;
  double same_, beside_, margin_, separation_;
  bool isBeside_ = false;  ///< a vertex is beside a face, but not over it
  bool rates_;
  Vec3 x_, y_;  ///< in A's face
  Manifold<kMostPolyhedraContacts> found_;
  PolyhedraContacts& out_;
};

}  // namespace

PlacedPolyhedron placedPolyhedron(const Frame& frame, const TouchingShape& shape) {
  return {&frame, shape.polyhedron, frame.r_OS_I + frame.A_IK * shape.p_K, frame.A_IK * shape.A_KB};
}

PlacedFace PlacedPolyhedron::face(int i, double sign, bool rates) const {
  const Polyhedron::Face& f = of->face(i);
  return {*frame, R * f.n, c, f.height, R * of->border(f.first).out, sign, rates};
}

int polyhedraFeatures(const Polyhedron& A, const Polyhedron& B) {
  return static_cast<int>(A.corners().size() + B.corners().size() +
                          A.edges().size() * B.edges().size());
}

int betweenPolyhedra(const PlacedPolyhedron& A, const PlacedPolyhedron& B, double reach, bool rates,
                     PolyhedraContacts& out) {
  const double same = kSameFeature * std::min(A.of->halfWidth(), B.of->halfWidth());
  const Separation separation(A, B);
  const Axis face = separation.faces(reach);
  if (face.separation > reach) return 0;
  const Axis edge = separation.edges(face.separation + 4.0 * same);
  if (edge.separation > reach) return 0;
  if (edge.i >= 0) {
    const PlacedEdge a = A.edge(edge.i), b = B.edge(edge.j);
    const EdgeCrossing at(a, b);
    if (std::abs(at.s) <= a.half && std::abs(at.t) <= b.half) {
      const int corners = static_cast<int>(A.of->corners().size() + B.of->corners().size());
      out[0] = {corners + edge.i * static_cast<int>(B.of->edges().size()) + edge.j,
                edgeOnEdge(*A.frame, a, *B.frame, b, at, A.R * edge.n)};
      return 1;
    }
  }
  const int faceA = face.i >= 0 ? face.i : faceAlong(*A.of, face.n);
  const int faceB = face.j >= 0 ? face.j : faceAlong(*B.of, -(separation.C.transpose() * face.n));
  return FacePair(A, faceA, B, faceB, separation, face.separation, same, rates, out).contacts();
}

void closeTogether(const PlacedPolyhedron& A, double reach, bool rates,
                   std::span<NumberedContact> contacts) {
  closeTogetherOn(*A.frame, reach, rates, contacts, [&](Vec3& n, Vec3& t) {
    const Polyhedron::Face& f = A.of->face(faceAlong(*A.of, A.R.transpose() * n));
    n = A.R * f.n, t = A.R * A.of->border(f.first).out;
  });
}

double separation(const PlacedPolyhedron& A, const PlacedPolyhedron& B) {
  const Separation all(A, B);
  return all.edges(all.faces(kInfinity).separation).separation;
}

}  // namespace dynamy
