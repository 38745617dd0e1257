#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Sine of the angle of two edges below which they are parallel and have no normal.
constexpr double kParallelEdges = 1e-4;

double sameOf(const PlacedPolyhedron& A, const PlacedPolyhedron& B) {
  return kSameFeature * std::min(A.of->halfWidth(), B.of->halfWidth());
}

/// Two crossing edges with the normal of their lines, out of A; all in the same axes.
struct Crossing {
  bool parallel = false;
  double s = 0.0, t = 0.0, sine = 0.0;
  Vec3 n = Vec3::UnitZ();
  Crossing(const PlacedEdge& a, const PlacedEdge& b, const Vec3& outOfA) {
    const Vec3 cross = a.e.cross(b.e), d = b.o - a.o;
    const double square = cross.squaredNorm(), c = a.e.dot(b.e);
    sine = std::sqrt(square), parallel = sine < kParallelEdges;
    if (parallel) return;
    const double da = d.dot(a.e), db = d.dot(b.e);
    s = (da - c * db) / square, t = (c * da - db) / square;
    n = (cross.dot(outOfA) < 0.0 ? -1.0 : 1.0) / sine * cross;
  }
};

/// Vertex v of `mover` over face f of `body`.
ContactPoint vertexOnFace(const PlacedPolyhedron& body, int f, const PlacedPolyhedron& mover, int v,
                          double sign, double same, bool rates, double& presence) {
  const Vec3 p = mover.vertex(v);
  const Polyhedron& of = *body.of;
  presence = same + inside(of, of.face(f), body.R.transpose() * (p - body.c));
  ContactPoint out;
  body.face(f, sign, rates).contact(*mover.frame, p, out);
  return out;
}

ContactPoint edgesCrossing(const PlacedPolyhedron& A, int i, const PlacedPolyhedron& B, int j,
                           double same, double& presence) {
  const PlacedEdge a = A.edge(i), b = B.edge(j);
  const Polyhedron::Edge &ofA = A.of->edge(i), &ofB = B.of->edge(j);
  const Crossing at(a, b, A.R * outOf(*A.of, ofA));
  if (at.parallel) {  // parallel edges have no contact
    presence = -std::min(a.half, b.half);
    ContactPoint out;
    setDirections(out, A.R * A.of->face(ofA.f).n, Vec3::Zero(), Vec3::Zero());
    out.g = std::min(a.half, b.half), out.P = a.o;
    return out;
  }
  const double least = std::min(a.half, b.half);
  const double turn =
      kBeyondNormals + std::min(withinNormals(*A.of, ofA, A.R.transpose() * at.n),
                                withinNormals(*B.of, ofB, -(B.R.transpose() * at.n)));
  presence =
      std::min({same + a.half - std::abs(at.s), same + b.half - std::abs(at.t), least * turn});
  return edgeOnEdge(*A.frame, a, *B.frame, b, EdgeCrossing(a, b), at.n);
}

/// Appends the near pairs of vertices of one body (mover) and faces of the other (body), in axes of
/// the latter: x ↦ R x + c.
void nearVertices(const Polyhedron& body, const Polyhedron& mover, const Mat3& R, const Vec3& c,
                  const Nearness& within, int number, std::vector<int>& out) {
  const int vertices = static_cast<int>(mover.corners().size()),
            faces = static_cast<int>(body.faces().size());
  for (int v = 0; v < vertices; ++v) {
    const Vec3 p = R * mover.corner(v) + c;
    for (int f = 0; f < faces; ++f) {
      const Polyhedron::Face& face = body.face(f);
      if (std::abs(face.n.dot(p) - face.height) > within.reach ||
          inside(body, face, p) < -within.reach)
        continue;
      // None of the vertex's neighbours lies further below.
      const Vec3 n = R.transpose() * face.n;
      bool lowest = true;
      for (const int w : mover.neighbours(v)) {
        const Vec3 way = mover.corner(w) - mover.corner(v);
        lowest = lowest && n.dot(way) >= -(kBeyondNormals + within.turn) * way.norm();
      }
      if (lowest) out.push_back(number + v * faces + f);
    }
  }
}

void nearEdges(const Polyhedron& A, const Polyhedron& B, const Mat3& R, const Vec3& c,
               const Nearness& within, int number, std::vector<int>& out) {
  const int edgesA = static_cast<int>(A.edges().size()),
            edgesB = static_cast<int>(B.edges().size());
  for (int i = 0; i < edgesA; ++i) {
    const Polyhedron::Edge& ofA = A.edge(i);
    const PlacedEdge a{ofA.middle, ofA.e, ofA.half};
    for (int j = 0; j < edgesB; ++j) {
      const Polyhedron::Edge& ofB = B.edge(j);
      const PlacedEdge b{R * ofB.middle + c, R * ofB.e, ofB.half};
      if ((b.o - a.o).norm() > a.half + b.half + within.reach || distance(a, b) > within.reach)
        continue;
      const Crossing at(a, b, outOf(A, ofA));
      if (at.sine + within.turn < kParallelEdges) continue;
      const double beyond = kBeyondNormals + 2.0 * within.turn / std::max(at.sine, kParallelEdges);
      const bool lies = at.parallel || beyond > 1.0 ||
                        std::min(withinNormals(A, ofA, at.n),
                                 withinNormals(B, ofB, -(R.transpose() * at.n))) >= -beyond;
      if (lies) out.push_back(number + i * edgesB + j);
    }
  }
}

}  // namespace

double inside(const Polyhedron& body, const Polyhedron::Face& f, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = f.first; i < f.first + f.count; ++i)
    least = std::min(least, body.border(i).out.dot(body.corner(body.border(i).corner) - p));
  return least;
}

double withinNormals(const Polyhedron& body, const Polyhedron::Edge& e, const Vec3& n) {
  return std::min(body.face(e.f).n.cross(n).dot(e.e), n.cross(body.face(e.g).n).dot(e.e));
}

Vec3 outOf(const Polyhedron& body, const Polyhedron::Edge& e) {
  return body.face(e.f).n + body.face(e.g).n;
}

double distance(const PlacedEdge& a, const PlacedEdge& b) {
  const Vec3 d = b.o - a.o;
  const double c = a.e.dot(b.e), da = d.dot(a.e), db = d.dot(b.e), square = 1.0 - c * c;
  double s = square > 0.0 ? std::clamp((da - c * db) / square, -a.half, a.half) : 0.0;
  const double t = std::clamp(c * s - db, -b.half, b.half);
  s = std::clamp(c * t + da, -a.half, a.half);
  return (d + t * b.e - s * a.e).norm();
}

int featurePairs(const Polyhedron& A, const Polyhedron& B) {
  return static_cast<int>(B.corners().size() * A.faces().size() +
                          A.corners().size() * B.faces().size() +
                          A.edges().size() * B.edges().size());
}

ContactPoint featurePair(const PlacedPolyhedron& A, const PlacedPolyhedron& B, int f, bool rates,
                         double& presence) {
  const int facesA = static_cast<int>(A.of->faces().size()),
            facesB = static_cast<int>(B.of->faces().size()),
            edgesB = static_cast<int>(B.of->edges().size());
  const double same = sameOf(A, B);
  if (const int all = static_cast<int>(B.of->corners().size()) * facesA; f < all)
    return vertexOnFace(A, f % facesA, B, f / facesA, 1.0, same, rates, presence);
  else
    f -= all;
  if (const int all = static_cast<int>(A.of->corners().size()) * facesB; f < all)
    return vertexOnFace(B, f % facesB, A, f / facesB, -1.0, same, rates, presence);
  else
    f -= all;
  return edgesCrossing(A, f / edgesB, B, f % edgesB, same, presence);
}

void nearFeatures(const PlacedPolyhedron& A, const PlacedPolyhedron& B, const Nearness& within,
                  std::vector<int>& out) {
  const Mat3 R = A.R.transpose() * B.R;
  const Vec3 c = A.R.transpose() * (B.c - A.c);
  const int first = static_cast<int>(B.of->corners().size() * A.of->faces().size()),
            second = static_cast<int>(A.of->corners().size() * B.of->faces().size());
  nearVertices(*A.of, *B.of, R, c, within, 0, out);
  nearVertices(*B.of, *A.of, R.transpose(), -(R.transpose() * c), within, first, out);
  nearEdges(*A.of, *B.of, R, c, within, first + second, out);
}

int featurePairs(const std::vector<Vec3>& A, const std::vector<Vec3>& B) {
  return 2 * static_cast<int>(A.size() * B.size());
}

namespace {

/// Edge i of a polygon.
struct Side {
  Vec3 o, e, n;
  double length;
  Side(const PlacedPolygon& of, int i) : o(of.corner(i)) {
    const Vec3 way = of.corner(i + 1) - o;
    length = way.norm(), e = way / length, n = e.cross(of.plane);
  }
  double inside(const Vec3& p) const {
    const double s = e.dot(p - o);
    return std::min(s, length - s);
  }
};

void nearCorners(const PlacedPolygon& body, const PlacedPolygon& mover, const Nearness& within,
                 int number, std::vector<int>& out) {
  const int n = mover.size();
  for (int v = 0; v < n; ++v) {
    const Vec3 p = mover.corner(v), next = mover.corner(v + 1) - p,
               last = mover.corner(v + n - 1) - p;
    for (int i = 0; i < body.size(); ++i) {
      const Side side(body, i);
      const double least = -(kBeyondNormals + within.turn);
      if (std::abs(side.n.dot(p - side.o)) <= within.reach && side.inside(p) >= -within.reach &&
          side.n.dot(next) >= least * next.norm() && side.n.dot(last) >= least * last.norm())
        out.push_back(number + v * body.size() + i);
    }
  }
}

}  // namespace

ContactPoint featurePair(const PlacedPolygon& A, const PlacedPolygon& B, int f, bool rates,
                         double& presence) {
  const int ofB = A.size() * B.size();
  const bool onA = f < ofB;
  const PlacedPolygon &body = onA ? A : B, &mover = onA ? B : A;
  if (!onA) f -= ofB;
  const Side side(body, f % body.size());
  const Vec3 p = mover.corner(f / body.size());
  presence = kSameFeature * side.length + side.inside(p);
  const double sign = onA ? 1.0 : -1.0;
  ContactPoint out;
  PlacedFace(*body.frame, side.n, side.o, 0.0, sign * side.n.cross(body.plane), sign, rates)
      .contact(*mover.frame, p, out);
  return out;
}

void nearFeatures(const PlacedPolygon& A, const PlacedPolygon& B, const Nearness& within,
                  std::vector<int>& out) {
  nearCorners(A, B, within, 0, out);
  nearCorners(B, A, within, A.size() * B.size(), out);
}

}  // namespace dynamy
