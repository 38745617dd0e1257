#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/contacts/box_contact.hpp>

namespace dynamy {
namespace {

/// Of the smaller box: features nearer than this are one.
constexpr double kSame = 1e-6;
/// Sine of the angle from which two edges have a normal of their own.
constexpr double kCross = 0.05;

/// Edge number 4 · axis + 2 bits for the signs of the other two axes.
struct Edge {
  Vec3 o, e;  ///< middle, unit direction
  double half;
  Edge(const PlacedBox& box, int number) {
    const int axis = number / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
    Vec3 local = Vec3::Zero();
    local[u] = number & 1 ? box.half[u] : -box.half[u];
    local[v] = number & 2 ? box.half[v] : -box.half[v];
    o = box.c + box.R * local, e = box.R.col(axis), half = box.half[axis];
  }
};

/// Largest separation along the axes of one kind, and which.
struct Axis {
  double separation = -1e300;
  int i = -1, j = -1;
  double sign = 1.0;  ///< of the direction from A to B
};

/// Both boxes in axes of A: C = R_Aᵀ R_B, t = R_Aᵀ (c_B − c_A), so that an axis costs a few
/// products.
struct Separation {
  Mat3 C, a;  ///< a: |C|
  Vec3 t, hA, hB;
  Separation(const PlacedBox& A, const PlacedBox& B)
      : C(A.R.transpose() * B.R),
        a(C.cwiseAbs()),
        t(A.R.transpose() * (B.c - A.c)),
        hA(A.half),
        hB(B.half) {}

  /// i = 0 … 2: faces of A, 3 … 5: faces of B.
  Axis faces() const {
    Axis best;
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

  /// Axes e_i × e_j of an edge of A and an edge of B.
  Axis edges() const {
    Axis best;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double square = 1.0 - C(i, j) * C(i, j);
        if (square < kCross * kCross) continue;
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const double along = t[i2] * C(i1, j) - t[i1] * C(i2, j);
        const double s = (std::abs(along) - hA[i1] * a(i2, j) - hA[i2] * a(i1, j) -
                          hB[j1] * a(i, j2) - hB[j2] * a(i, j1)) /
                         std::sqrt(square);
        if (s > best.separation) best = {s, i, j, along < 0.0 ? -1.0 : 1.0};
      }
    return best;
  }
};

/// Signed axis ±(k + 1) of the face of `box` that looks along n most.
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

/// Vertex `p` moving with `mover` over the face of `box`; `sign` +1: box is A.
ContactPoint vertexOnFace(const PlacedBox& box, int face, const PlacedBox& mover, const Vec3& p,
                          double sign) {
  ContactPoint out;
  const int k = axisOf(face);
  const Vec3 n = normalOf(box, face);
  out.g = n.dot(p - box.c) - box.half[k];
  out.d[0] = sign * n;
  // The other two axes of the face, right-handed with n.
  out.d[1] = box.R.col((k + 1) % 3);
  out.d[2] = out.d[0].cross(out.d[1]);
  for (int i = 0; i < 3; ++i) out.ddot[i] = box.frame->Omega_I.cross(out.d[i]);
  out.P = p;
  out.Pdot = mover.frame->velocity(p - mover.frame->r_OS_I);
  return out;
}

/// Closest points of two lines, parameters from the middles; false: parallel.
struct Crossing {
  double s = 0.0, t = 0.0;
  Vec3 PA, PB, n;
  bool of(const Edge& a, const Edge& b) {
    const Vec3 cross = a.e.cross(b.e), d = b.o - a.o;
    const double square = cross.squaredNorm(), c = a.e.dot(b.e);
    if (square < kCross * kCross) return false;
    const double da = d.dot(a.e), db = d.dot(b.e);
    s = (da - c * db) / square, t = (c * da - db) / square;
    PA = a.o + s * a.e, PB = b.o + t * b.e;
    n = cross / std::sqrt(square);
    return true;
  }
};

ContactPoint edgeOnEdge(const PlacedBox& A, const Edge& a, const PlacedBox& B, const Edge& b,
                        const Crossing& at, const Vec3& towardsB) {
  ContactPoint out;
  const Frame &fA = *A.frame, &fB = *B.frame;
  const double sign = at.n.dot(towardsB) < 0.0 ? -1.0 : 1.0;
  const Vec3 n = sign * at.n, d = at.PB - at.PA;
  const Vec3 eAdot = fA.Omega_I.cross(a.e), eBdot = fB.Omega_I.cross(b.e);
  const Vec3 cross = a.e.cross(b.e), crossdot = eAdot.cross(b.e) + a.e.cross(eBdot);
  const Vec3 ndot = sign * (crossdot - at.n * at.n.dot(crossdot)) / cross.norm();
  out.g = n.dot(d);
  out.d[0] = n, out.d[1] = a.e, out.d[2] = n.cross(a.e);
  out.ddot[0] = ndot, out.ddot[1] = eAdot, out.ddot[2] = ndot.cross(a.e) + n.cross(eAdot);
  // d ⟂ e_A, e_B for all times: ḋ·e + d·ė = 0 with ḋ = v_B − v_A + ṫ e_B − ṡ e_A gives ṫ.
  const Vec3 vB = fB.velocity(at.PB - fB.r_OS_I), v = vB - fA.velocity(at.PA - fA.r_OS_I);
  const double c = a.e.dot(b.e), ra = v.dot(a.e) + d.dot(eAdot), rb = v.dot(b.e) + d.dot(eBdot);
  const double tdot = (c * ra - rb) / (1.0 - c * c);
  out.P = at.PB;
  out.Pdot = vB + tdot * b.e;
  return out;
}

/// Collects contacts; points that coincide seen along the normal are one, the first counts.
class Manifold {
 public:
  Manifold(const Vec3& n, double same, std::array<BoxContact, kMostBoxContacts>& out)
      : n_(n), same2_(same * same), out_(&out) {}
  /// Is there room for a contact at P, and none yet?
  bool wants(const Vec3& P) const {
    for (int i = 0; i < size_; ++i) {
      const Vec3 d = (*out_)[static_cast<std::size_t>(i)].at.P - P;
      const double along = n_.dot(d);
      if (d.squaredNorm() - along * along <= same2_) return false;
    }
    return size_ < kMostBoxContacts;
  }
  void add(int id, const ContactPoint& at) {
    (*out_)[static_cast<std::size_t>(size_++)] = {id, at};
  }
  int size() const { return size_; }

 private:
  Vec3 n_;
  double same2_;
  std::array<BoxContact, kMostBoxContacts>* out_;
  int size_ = 0;
};

/// Is p, seen along the face's normal, on the face?
bool over(const PlacedBox& box, int face, const Vec3& p, double same) {
  const Vec3 local = box.R.transpose() * (p - box.c);
  for (int k = 0; k < 3; ++k)
    if (k != axisOf(face) && std::abs(local[k]) > box.half[k] + same) return false;
  return true;
}

bool onFace(int vertex, int face) { return ((vertex >> axisOf(face)) & 1) == (face > 0 ? 1 : 0); }
/// Edge `number` borders the face.
bool bordersFace(int number, int face) {
  const int axis = number / 4, k = axisOf(face);
  if (axis == k) return false;
  const int bit = k == (axis + 1) % 3 ? number & 1 : (number >> 1) & 1;
  return bit == (face > 0 ? 1 : 0);
}

/// The four edges that border a face.
void edgesOf(int face, int* numbers) {
  int n = 0;
  for (int i = 0; i < 12; ++i)
    if (bordersFace(i, face)) numbers[n++] = i;
}

int betweenFaces(const PlacedBox& A, int faceA, const PlacedBox& B, int faceB, double same,
                 std::array<BoxContact, kMostBoxContacts>& out) {
  const Vec3 nA = normalOf(A, faceA);
  Manifold manifold(nA, 4.0 * same, out);
  for (int i = 0; i < 8; ++i) {
    if (!onFace(i, faceB)) continue;
    const Vec3 p = B.vertex(i);
    if (over(A, faceA, p, same) && manifold.wants(p))
      manifold.add(i, vertexOnFace(A, faceA, B, p, 1.0));
  }
  for (int i = 0; i < 8; ++i) {
    if (!onFace(i, faceA)) continue;
    const Vec3 p = A.vertex(i);
    if (over(B, faceB, p, same) && manifold.wants(p))
      manifold.add(8 + i, vertexOnFace(B, faceB, A, p, -1.0));
  }
  int edgesA[4], edgesB[4];
  edgesOf(faceA, edgesA), edgesOf(faceB, edgesB);
  const Edge b[4] = {{B, edgesB[0]}, {B, edgesB[1]}, {B, edgesB[2]}, {B, edgesB[3]}};
  for (const int i : edgesA) {
    const Edge a(A, i);
    for (int j = 0; j < 4; ++j) {
      Crossing at;
      if (!at.of(a, b[j]) || std::abs(at.s) > a.half + same || std::abs(at.t) > b[j].half + same)
        continue;
      if (std::abs(at.n.dot(nA)) < 0.7 || !manifold.wants(at.PB)) continue;
      manifold.add(16 + 12 * i + edgesB[j], edgeOnEdge(A, a, B, b[j], at, nA));
    }
  }
  return manifold.size();
}

/// Number of the edge along `axis` that is outermost in direction n.
int outerEdge(const PlacedBox& box, int axis, const Vec3& n) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return 4 * axis + (box.R.col(u).dot(n) > 0.0 ? 1 : 0) + (box.R.col(v).dot(n) > 0.0 ? 2 : 0);
}

}  // namespace

PlacedBox placedBox(const Frame& frame, const TouchingShape& box) {
  return {&frame, frame.r_OS_I + frame.A_IK * box.p_K, frame.A_IK * box.A_KB, box.half};
}

int betweenBoxes(const PlacedBox& A, const PlacedBox& B, double reach,
                 std::array<BoxContact, kMostBoxContacts>& out) {
  const double balls = A.half.norm() + B.half.norm() + reach;
  if ((B.c - A.c).squaredNorm() > balls * balls) return 0;
  const double same = kSame * std::min(A.half.minCoeff(), B.half.minCoeff());
  const Separation separation(A, B);
  const Axis face = separation.faces(), edge = separation.edges();
  if (edge.separation > face.separation + 4.0 * same) {
    const Vec3 n = edge.sign * A.R.col(edge.i).cross(B.R.col(edge.j)).normalized();
    const int i = outerEdge(A, edge.i, n), j = outerEdge(B, edge.j, -n);
    const Edge a(A, i), b(B, j);
    Crossing at;
    const bool meets = at.of(a, b);
    if (meets && std::abs(at.s) <= a.half && std::abs(at.t) <= b.half) {
      out[0] = {16 + 12 * i + j, edgeOnEdge(A, a, B, b, at, n)};
      return 1;
    }
  }
  const Vec3 n = face.sign * (face.i < 3 ? A.R.col(face.i) : B.R.col(face.i - 3));
  return betweenFaces(A, faceAlong(A, n), B, faceAlong(B, -n), same, out);
}

double separation(const PlacedBox& A, const PlacedBox& B) {
  const Separation all(A, B);
  return std::max(all.faces().separation, all.edges().separation);
}

}  // namespace dynamy
