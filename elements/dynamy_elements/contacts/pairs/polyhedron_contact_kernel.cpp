#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/pairs/polyhedra_separation.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>
#include <limits>

namespace dynamy {

int outermost(const Polyhedron& body, const Vec3& d, double& along) {
  const Polyhedron::Columns& p = body.cornerColumns();
  const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
  const double dx = d.x(), dy = d.y(), dz = d.z();
  const std::size_t n = p.size();
  // Side by side: products of a few corners, then the largest of them.
  constexpr std::size_t kTogether = 32;
  double at[kTogether];
  std::size_t best = 0;
  along = -kInfinity;
  for (std::size_t from = 0; from < n; from += kTogether) {
    const std::size_t some = std::min(kTogether, n - from);
    for (std::size_t i = 0; i < some; ++i)
      at[i] = dx * x[from + i] + dy * y[from + i] + dz * z[from + i];
    for (std::size_t i = 0; i < some; ++i)
      if (at[i] > along) along = at[i], best = from + i;
  }
  return static_cast<int>(best);
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

/// The intersection of two faces seen along the normal of A's. All places are tested
/// in axes of A, where a place without a contact costs a few products. A contact is
/// then computed from the bodies' frames.
class FacePair {
 public:
  FacePair(const PlacedPolyhedron& A, int faceA, const PlacedPolyhedron& B, int faceB,
           const PolyhedraSeparation& in, double separation, double ofBodies, double same,
           bool rates, PolyhedraContacts& out)
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
        least_(leastOfFaces(ofBodies, same)),
        rates_(rates),
        found_(4.0 * same),
        out_(out) {
    x_ = A.of->border(a_.first).out, y_ = a_.n.cross(x_);
  }

  int contacts() {
    features();
    // Without any contact an overlap would remain unseen.
    if (found_.size() == 0) least_ = -kInfinity, features();
    const std::span<const NumberedContact> taken(out_.data(),
                                                 static_cast<std::size_t>(found_.size()));
    if (beside_ > same_ && isBeside_ && leastGap(taken) > separation_ + same_) {
      margin_ = beside_;
      verticesOfB(), verticesOfA();
    }
    return found_.size();
  }

 private:
  void features() {
    // If one face lies inside of the other, its vertices are all of the intersection.
    if (!verticesOfB() && !verticesOfA()) edges();
  }
  NumberedContact& last() { return out_[static_cast<std::size_t>(found_.size() - 1)]; }
  bool takes(const Vec3& p_A) { return found_.takes(x_.dot(p_A), y_.dot(p_A)); }
  /// Drops the last contact if it is deeper than the bodies.
  void check() {
    if (last().at.g < least_) found_.drop();
  }
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
      const Vec3 p_A = in_.t() + in_.C() * B_.of->corner(v);
      const bool inside = over(*A_.of, a_, p_A);
      all = all && inside;
      if (!inside || i % stride(b_.count) != 0 || !takes(p_A)) continue;
      last().id = v;
      onA.contact(*B_.frame, B_.vertex(v), last().at);
      check();
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
      const bool inside = over(*B_.of, b_, in_.C().transpose() * (p_A - in_.t()));
      all = all && inside;
      if (!inside || i % stride(a_.count) != 0 || !takes(p_A)) continue;
      last().id = corners + v;
      onB.contact(*A_.frame, A_.vertex(v), last().at);
      check();
    }
    return all;
  }

  void edges() {
    for (int j = b_.first; j < b_.first + b_.count; ++j) {
      const int edgeB = B_.of->border(j).edge;
      const Polyhedron::Edge& b = B_.of->edge(edgeB);
      const PlacedEdge in{in_.t() + in_.C() * b.middle, in_.C() * b.e, b.half};
      for (int i = a_.first; i < a_.first + a_.count; ++i) edge(A_.of->border(i).edge, edgeB, in);
    }
  }
  void edge(int i, int j, const PlacedEdge& b) {
    const Polyhedron::Edge& e = A_.of->edge(i);
    // Most lines cross beyond the ends of the edges, which is seen before they are divided.
    const Vec3 way = b.o - e.middle;
    const double c = e.e.dot(b.e), da = way.dot(e.e), db = way.dot(b.e),
                 square = e.e.cross(b.e).squaredNorm();
    if (isBeyond(da - c * db, (e.half + same_) * square) ||
        isBeyond(c * da - db, (b.half + same_) * square))
      return;
    const EdgeCrossing seen({e.middle, e.e, e.half}, b);
    // Only edges count that cross at an angle, with a normal like that of the face.
    if (seen.parallel || std::abs(seen.n.dot(a_.n)) < kLikeFace) return;
    if (std::abs(seen.s) > e.half + same_ || std::abs(seen.t) > b.half + same_) return;
    if (!takes(seen.PB)) return;
    const PlacedEdge edgeA = A_.edge(i), edgeB = B_.edge(j);
    const int corners = static_cast<int>(A_.of->corners().size() + B_.of->corners().size());
    last().id = corners + i * static_cast<int>(B_.of->edges().size()) + j;
    last().at = edgeOnEdge(*A_.frame, edgeA, *B_.frame, edgeB, EdgeCrossing(edgeA, edgeB),
                           A_.R * a_.n, rates_);
    check();
  }

  const PlacedPolyhedron &A_, &B_;
  const Polyhedron::Face &a_, &b_;
  int faceA_, faceB_;
  const PolyhedraSeparation& in_;
  double same_, beside_, margin_, separation_;
  double least_;           ///< least gap of a contact
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
  PolyhedraSeparation separation(A, B);
  const PolyhedraAxis face = separation.faces(reach);
  if (face.separation > reach) return 0;
  const PolyhedraAxis edge = separation.edges(face, face.separation + 4.0 * same, same);
  if (edge.separation > reach) return 0;
  if (edge.i >= 0) {
    const PlacedEdge a = A.edge(edge.i), b = B.edge(edge.j);
    const EdgeCrossing at(a, b);
    if (std::abs(at.s) <= a.half && std::abs(at.t) <= b.half) {
      const int corners = static_cast<int>(A.of->corners().size() + B.of->corners().size());
      out[0] = {corners + edge.i * static_cast<int>(B.of->edges().size()) + edge.j,
                edgeOnEdge(*A.frame, a, *B.frame, b, at, A.R * edge.n, rates)};
      return 1;
    }
  }
  const int faceA = face.i >= 0 ? face.i : faceAlong(*A.of, face.n);
  const int faceB = face.j >= 0 ? face.j : faceAlong(*B.of, -(separation.C().transpose() * face.n));
  // Without a pair of edges the separation is that of faces.
  const double ofBodies = edge.i >= 0 ? edge.separation : face.separation;
  return FacePair(A, faceA, B, faceB, separation, face.separation, ofBodies, same, rates, out)
      .contacts();
}

void closeTogether(const PlacedPolyhedron& A, double reach, bool rates,
                   std::span<NumberedContact> contacts) {
  closeTogetherOn(*A.frame, reach, rates, contacts, [&](Vec3& n, Vec3& t) {
    const Polyhedron::Face& f = A.of->face(faceAlong(*A.of, A.R.transpose() * n));
    n = A.R * f.n, t = A.R * A.of->border(f.first).out;
  });
}

double separation(const PlacedPolyhedron& A, const PlacedPolyhedron& B) {
  PolyhedraSeparation all(A, B);
  const PolyhedraAxis face = all.faces(kInfinity);
  return all.edges(face, face.separation, 0.0).separation;
}

}  // namespace dynamy
