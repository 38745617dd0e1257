#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/contacts/pairs/box_contact.hpp>

namespace dynamy {
namespace {

/// Edge of a box; its number is 4 · axis + 2 bits for the signs along the other two axes.
PlacedEdge placedEdge(const PlacedBox& box, int number) {
  const int axis = number / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
  Vec3 local = Vec3::Zero();
  local[u] = number & 1 ? box.half[u] : -box.half[u];
  local[v] = number & 2 ? box.half[v] : -box.half[v];
  return {box.c + box.R * local, box.R.col(axis), box.half[axis]};
}

/// Largest separation among axes of one kind, and the axis.
struct BoxAxis {
  double separation = -1e300;
  int i = -1, j = -1;
  double sign = 1.0;  ///< of the direction from A to B
};

/// Separations of two boxes in axes of A, where an axis costs a few products:
/// C = R_Aᵀ R_B, t = R_Aᵀ (c_B − c_A).
struct BoxSeparation {
  Mat3 C, a;  ///< a: |C|
  Vec3 t, hA, hB;
  BoxSeparation(const PlacedBox& A, const PlacedBox& B)
      : C(A.R.transpose() * B.R),
        a(C.cwiseAbs()),
        t(A.R.transpose() * (B.c - A.c)),
        hA(A.half),
        hB(B.half) {}

  /// Separation along face normals: i = 0 … 2 for faces of A, 3 … 5 for faces of B.
  BoxAxis faces() const {
    BoxAxis best;
    for (int i = 0; i < 6; ++i) {
      const int k = i % 3;
      const double along = i < 3 ? t[k] : t.dot(C.col(k));
      const double s =
          std::abs(along) - (i < 3 ? hA[k] + a(k, 0) * hB[0] + a(k, 1) * hB[1] + a(k, 2) * hB[2]
                                   : hB[k] + a.col(k).dot(hA));
      if (s > best.separation) best = {s, i, -1, along < 0.0 ? -1.0 : 1.0};
    }
    return best;
  }

  /// Separation along the axes e_i × e_j of an edge of A and an edge of B. Axes that do not
  /// separate by more than `least` are skipped before their root is computed.
  BoxAxis edges(double least) const {
    BoxAxis best;
    const double bound = std::min(least, 0.0);  // the root is at most 1
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const double along = t[i2] * C(i1, j) - t[i1] * C(i2, j);
        const double over = std::abs(along) - hA[i1] * a(i2, j) - hA[i2] * a(i1, j) -
                            hB[j1] * a(i, j2) - hB[j2] * a(i, j1);
        const double square = 1.0 - C(i, j) * C(i, j);
        if (over <= bound || square < kCross * kCross) continue;
        const double s = over / std::sqrt(square);
        if (s > best.separation) best = {s, i, j, along < 0.0 ? -1.0 : 1.0};
      }
    return best;
  }
};

/// Signed axis ±(k + 1) of the face of `box` whose normal is nearest to n.
int faceAlong(const PlacedBox& box, const Vec3& n) {
  int best = 0;
  double most = -1.0;
  for (int k = 0; k < 3; ++k) {
    const double along = box.R.col(k).dot(n);
    if (std::abs(along) > most) most = std::abs(along), best = along < 0.0 ? -k - 1 : k + 1;
  }
  return best;
}
int axisOf(int face) { return std::abs(face) - 1; }
Vec3 normalOf(const PlacedBox& box, int face) {
  return (face > 0 ? 1.0 : -1.0) * box.R.col(axisOf(face));
}

/// Face of a box in the world; `sign` +1: the box is A.
PlacedFace placedFace(const PlacedBox& box, int face, double sign, bool rates) {
  const int k = axisOf(face);
  return {*box.frame, normalOf(box, face), box.c, box.half[k], box.R.col((k + 1) % 3), sign, rates};
}

/// One of the four edges that border a face: its number, which axis it is along, and its middle.
struct Border {
  int number = 0, axis = 0;
  Vec3 middle;  ///< in axes of its box
};

/// Writes the four borders of a face in the order of their numbers.
void borders(const Vec3& half, int face, Border* out) {
  const int k = axisOf(face), positive = face > 0 ? 1 : 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == k) continue;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int side = 0; side < 2; ++side, ++out) {
      const int bitU = u == k ? positive : side, bitV = u == k ? side : positive;
      out->number = 4 * axis + bitU + 2 * bitV, out->axis = axis;
      out->middle[axis] = 0.0;
      out->middle[u] = bitU ? half[u] : -half[u], out->middle[v] = bitV ? half[v] : -half[v];
    }
  }
}

bool onFace(int vertex, int face) { return ((vertex >> axisOf(face)) & 1) == (face > 0 ? 1 : 0); }

/// The intersection of two faces seen along the normal of A's. All places are tested
/// in axes of A, where a place without a contact costs a few products. A contact is
/// then computed from the bodies' frames.
class BoxFacePair {
 public:
  BoxFacePair(const PlacedBox& A, int faceA, const PlacedBox& B, int faceB, const BoxSeparation& in,
              double separation, double ofBodies, double same, bool rates,
              std::array<BoxContact, kMostBoxContacts>& out)
      : A_(A),
        B_(B),
        faceA_(faceA),
        faceB_(faceB),
        in_(in),
        same_(same),
        beside_(besideFace(separation, same)),
        margin_(same),
        separation_(separation),
        least_(leastOfFaces(ofBodies, same)),
        rates_(rates),
        x_((axisOf(faceA) + 1) % 3),
        y_((axisOf(faceA) + 2) % 3),
        found_(4.0 * same),
        out_(out) {}

  int contacts() {
    features();
    // Without any contact an overlap would remain unseen.
    if (found_.size() == 0) least_ = -kInfinity, features();
    if (beside_ > same_ && isBeside_ && leastGap(taken()) > separation_ + same_) {
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
  std::span<const BoxContact> taken() const {
    return {out_.data(), static_cast<std::size_t>(found_.size())};
  }
  BoxContact& last() { return out_[static_cast<std::size_t>(found_.size() - 1)]; }
  bool takes(const Vec3& p_A) { return found_.takes(p_A[x_], p_A[y_]); }
  /// Drops the last contact if it is deeper than the bodies.
  void check() {
    if (last().at.g < least_) found_.drop();
  }
  /// Is p, given from the centre of a box in its axes, over the face along axis k?
  bool over(const Vec3& half, int k, const Vec3& p) {
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    const auto within = [&](double margin) {
      return std::abs(p[u]) <= half[u] + margin && std::abs(p[v]) <= half[v] + margin;
    };
    if (within(margin_)) return true;
    isBeside_ = isBeside_ || within(beside_);
    return false;
  }

  /// Adds the vertices of B's face that are over A's face; true: all of them are.
  bool verticesOfB() {
    const PlacedFace onA = placedFace(A_, faceA_, 1.0, rates_);
    int inside = 0;
    for (int i = 0; i < 8; ++i) {
      if (!onFace(i, faceB_)) continue;
      const Vec3 p_A = in_.t + in_.C * B_.corner(i);
      if (!over(A_.half, axisOf(faceA_), p_A)) continue;
      ++inside;
      if (!takes(p_A)) continue;
      last().id = i;
      onA.contact(*B_.frame, B_.vertex(i), last().at);
      check();
    }
    return inside == 4;
  }
  bool verticesOfA() {
    const PlacedFace onB = placedFace(B_, faceB_, -1.0, rates_);
    int inside = 0;
    for (int i = 0; i < 8; ++i) {
      if (!onFace(i, faceA_)) continue;
      const Vec3 p_A = A_.corner(i), p_B = in_.C.transpose() * (p_A - in_.t);
      if (!over(B_.half, axisOf(faceB_), p_B)) continue;
      ++inside;
      if (!takes(p_A)) continue;
      last().id = 8 + i;
      onB.contact(*A_.frame, A_.vertex(i), last().at);
      check();
    }
    return inside == 4;
  }

  void edges() {
    Border a[4], b[4];
    borders(A_.half, faceA_, a), borders(B_.half, faceB_, b);
    for (Border& edge : b) edge.middle = in_.t + in_.C * edge.middle;
    for (const Border& i : a)
      for (const Border& j : b) edge(i, j);
  }

  /// Contact of two edges at their closest points o_A + s e_A, o_B + t e_B; middles in axes of A.
  void edge(const Border& a, const Border& b) {
    const int k = axisOf(faceA_);
    const Vec3 eB = in_.C.col(b.axis), d = b.middle - a.middle;
    const int u = (a.axis + 1) % 3, v = (a.axis + 2) % 3;
    const double square = eB[u] * eB[u] + eB[v] * eB[v];
    // Only edges count that cross at an angle, with a normal like that of the face: k is u or v.
    const double normal = k == u ? eB[v] : eB[u];
    if (square < kCross * kCross || normal * normal < kLikeFace * kLikeFace * square) return;
    const double c = eB[a.axis], da = d[a.axis], db = d.dot(eB);
    const double mostA = A_.half[a.axis] + same_, mostB = B_.half[b.axis] + same_;
    const double overA = da - c * db, overB = c * da - db;
    // Most lines cross beyond the ends of the edges, which is seen before they are divided.
    if (isBeyond(overA, mostA * square) || isBeyond(overB, mostB * square)) return;
    const double s = overA / square, t = overB / square;
    if (std::abs(s) > mostA || std::abs(t) > mostB) return;
    if (!takes(b.middle + t * eB)) return;
    const PlacedEdge edgeA = placedEdge(A_, a.number), edgeB = placedEdge(B_, b.number);
    const EdgeCrossing at(edgeA, edgeB);
    last().id = 16 + 12 * a.number + b.number;
    last().at = edgeOnEdge(*A_.frame, edgeA, *B_.frame, edgeB, at, normalOf(A_, faceA_), rates_);
    check();
  }

  const PlacedBox &A_, &B_;
  int faceA_, faceB_;
  const BoxSeparation& in_;
  double same_, beside_, margin_, separation_;
  double least_;           ///< least gap of a contact
  bool isBeside_ = false;  ///< a vertex is beside a face, but not over it
  bool rates_;
  int x_, y_;  ///< axes of A in its face
  Manifold<kMostBoxContacts> found_;
  std::array<BoxContact, kMostBoxContacts>& out_;
};

/// Number of the edge along `axis` that is outermost in direction n.
int outerEdge(const PlacedBox& box, int axis, const Vec3& n) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return 4 * axis + (box.R.col(u).dot(n) > 0.0 ? 1 : 0) + (box.R.col(v).dot(n) > 0.0 ? 2 : 0);
}

}  // namespace

PlacedBox placedBox(const Frame& frame, const TouchingShape& box) {
  return {&frame, frame.r_OS_I + frame.A_IK * box.p_K, frame.A_IK * box.A_KB, box.half};
}

int betweenBoxes(const PlacedBox& A, const PlacedBox& B, bool rates,
                 std::array<BoxContact, kMostBoxContacts>& out, double reach) {
  const double same = kSameFeature * std::min(A.half.minCoeff(), B.half.minCoeff());
  const BoxSeparation separation(A, B);
  const BoxAxis face = separation.faces();
  if (face.separation > reach) return 0;
  const double least = face.separation + 4.0 * same;
  const BoxAxis edge = separation.edges(least);
  if (edge.separation > reach) return 0;
  if (edge.separation > least) {
    const Vec3 n = edge.sign * A.R.col(edge.i).cross(B.R.col(edge.j)).normalized();
    const int i = outerEdge(A, edge.i, n), j = outerEdge(B, edge.j, -n);
    const PlacedEdge a = placedEdge(A, i), b = placedEdge(B, j);
    const EdgeCrossing at(a, b);
    if (!at.parallel && std::abs(at.s) <= a.half && std::abs(at.t) <= b.half) {
      out[0] = {16 + 12 * i + j, edgeOnEdge(*A.frame, a, *B.frame, b, at, n, rates)};
      return 1;
    }
  }
  const Vec3 n = face.sign * (face.i < 3 ? A.R.col(face.i) : B.R.col(face.i - 3));
  return BoxFacePair(A, faceAlong(A, n), B, faceAlong(B, -n), separation, face.separation,
                     std::max(face.separation, edge.separation), same, rates, out)
      .contacts();
}

void closeTogether(const PlacedBox& A, double reach, bool rates, std::span<BoxContact> contacts) {
  closeTogetherOn(*A.frame, reach, rates, contacts, [&](Vec3& n, Vec3& t) {
    const int face = faceAlong(A, n);
    n = normalOf(A, face), t = A.R.col((axisOf(face) + 1) % 3);
  });
}

double separation(const PlacedBox& A, const PlacedBox& B) {
  const BoxSeparation all(A, B);
  const double ofFaces = all.faces().separation;
  return std::max(ofFaces, all.edges(ofFaces).separation);
}

}  // namespace dynamy
