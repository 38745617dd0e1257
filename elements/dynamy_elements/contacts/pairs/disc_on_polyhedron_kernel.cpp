#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/disc_arc.hpp>
#include <dynamy_elements/contacts/pairs/disc_on_polyhedron.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <dynamy_elements/contacts/pairs/support_witnesses.hpp>
#include <limits>
#include <numbers>

namespace dynamy {
namespace {

/// Most corners of a face that are tested; of more only every second, third … is.
constexpr int kMostDiscCorners = 8;

/// A direction with its separation f, and the feature of A that it belongs to.
struct Apart {
  double f = -kInfinity;
  Vec3 n = Vec3::UnitZ();
  int face = -1, edge = -1, corner = -1;
};

/// Search of the direction of largest separation among candidates, with both bodies in the world.
/// Faces, edges and corners that a pair of points excludes are passed over (support_witnesses.hpp).
class Search {
 public:
  Search(const PlacedPolyhedron& A, const DiscBody& B) : A_(A), B_(B), body_(*A.of) {}

  /// Faces and caps come first: another direction has to separate by more than `more`.
  Apart best(double reach, double more) {
    faces(reach);
    if (best_.f > reach) return best_;
    if (B_.rho > 0.0)
      for (const double side : {1.0, -1.0}) {
        const Vec3 n = side * B_.a;
        take({value(n), n});
      }
    const double least = best_.f + more;
    Excluded out(body_, least - rounding());
    out.by(inA(B_.c - A_.c) - body_.middle());
    around(kNear, out);
    if (!std::all_of(body_.edges().begin(), body_.edges().end(),
                     [&](const Polyhedron::Edge& e) { return out.edge(e); }))
      around(kFar, out);
    for (int i = 0; i < count(body_.edges()); ++i)
      if (!out.edge(body_.edge(i))) edge(i, least);
    // A corner can be nearest to a smooth part only if the bodies are
    // apart, or if the part is the side.
    for (int i = 0; i < count(body_.corners()); ++i)
      if (!out.corner(i)) corner(i, least);
    return best_;
  }

 private:
  /// Tilts of a normal [rad]: the points that are outermost along tilted normals lie around each
  /// other. With the first they are almost as near as along the normal itself.
  static constexpr double kNear = 1e-3, kFar = 0.5;

  template <class Parts>
  static int count(const Parts& parts) {
    return static_cast<int>(parts.size());
  }
  Vec3 inA(const Vec3& v) const { return A_.R.transpose() * v; }
  /// Error of a separation, with a margin of a hundred [m].
  double rounding() const { return 1e-13 * (A_.c.norm() + B_.c.norm() + body_.radius() + B_.rho); }
  double value(const Vec3& n) const {
    double along = 0.0;
    outermost(body_, A_.R.transpose() * n, along);
    return -B_.support(-n) - n.dot(A_.c) - along;
  }
  Apart ofFace(int i) const {
    const Polyhedron::Face& f = body_.face(i);
    const Vec3 n = A_.R * f.n;
    return {-B_.support(-n) - n.dot(A_.c) - f.height, n, i};
  }
  /// The search ends once the separation exceeds `reach`. Of equal ones the first counts.
  void faces(double reach) {
    // It begins at the face that B's middle is furthest from.
    const Vec3 c = inA(B_.c - A_.c), middle = c - body_.middle();
    int first = 0;
    double furthest = -kInfinity;
    for (int i = 0; i < count(body_.faces()); ++i)
      if (const double s = body_.face(i).n.dot(c) - body_.face(i).height; s > furthest)
        furthest = s, first = i;
    const Apart start = ofFace(first);
    const Vec3 w = inA(B_.furthest(-start.n) - A_.c) -
                   body_.corner(body_.border(body_.face(first).first).corner);
    double most = start.f;
    const double rounded = rounding();
    if (most > reach) best_ = start;
    for (int i = 0; i < count(body_.faces()) && !(best_.f > reach); ++i) {
      const Vec3& n = body_.face(i).n;
      if (i == first) {
        take(start);
      } else if (std::min(n.dot(middle), n.dot(w)) >= most - rounded) {
        take(ofFace(i)), most = std::max(most, best_.f);
      }
    }
  }
  /// Excludes by the outermost points along the best normal, tilted by `tilt` in six directions.
  void around(double tilt, Excluded& out) const {
    const Vec3 x = tilt * best_.n.unitOrthogonal(), y = best_.n.cross(x);
    for (int k = 0; k < 6; ++k) {
      const double angle = std::numbers::pi / 3.0 * k;
      const Vec3 n = best_.n + std::cos(angle) * x + std::sin(angle) * y;
      double along = 0.0;
      const int v = outermost(body_, inA(n), along);
      out.by(inA(B_.furthest(-n) - A_.c) - body_.corner(v));
    }
  }
  void take(const Apart& with, double least = -kInfinity) {
    if (with.f > std::max(best_.f, least)) best_ = with;
  }
  void edge(int i, double least);
  void corner(int i, double least);
  /// The normal n at corner i.
  void along(int i, const Vec3& n, double least);

  const PlacedPolyhedron& A_;
  const DiscBody& B_;
  const Polyhedron& body_;
  Apart best_;
};

void Search::edge(int i, double least) {
  const Polyhedron::Edge& e = body_.edge(i);
  const Vec3 n0 = A_.R * body_.face(e.f).n, nE = A_.R * body_.face(e.g).n;
  const Vec3 m = (A_.R * e.e).cross(n0);
  const DiscArc arc{B_, n0, m, B_.c - A_.edge(i).o};
  arc.tops(std::atan2(m.dot(nE), n0.dot(nE)), std::max(best_.f, least),
           [&](const Vec3& n, double f) {
             take({f, n, -1, i}, least);
           });
}

void Search::corner(int i, double least) {
  const Vec3 v = A_.vertex(i), way = v - B_.c, beside = B_.acrossAxis(way);
  const Vec3 e = beside.norm() > 0.0 ? unitAcross(beside, B_.a) : B_.x;
  // B's side, also for a corner inside. Of its rim the nearest point, in the plane of its normals:
  // where the bodies touch the rest of d is rounding. What is beyond these ends at edges' arcs.
  const bool beyond = std::abs(way.dot(B_.a)) > (1.0 + kSameFeature) * B_.half;
  if (B_.half > 0.0 && (B_.tip || !beyond)) along(i, -B_.cosine() * e - B_.sine() * B_.a, least);
  const Vec3 d = B_.nearest(v) - v, near = d.dot(e) * e + d.dot(B_.a) * B_.a;
  if (const double length = near.norm(); length > 0.0) along(i, near / length, least);
}

void Search::along(int i, const Vec3& n, double least) {
  const Vec3 n_A = A_.R.transpose() * n;
  for (const int k : body_.neighbours(i))
    if (n_A.dot(body_.corner(k) - body_.corner(i)) > 0.0) return;
  take({-B_.support(-n) - n.dot(A_.vertex(i)), n, -1, -1, i}, least);
}

/// All contacts along the direction n.
class Manifolds {
 public:
  Manifolds(const PlacedPolyhedron& A, const DiscBody& B, const Apart& apart, double same,
            DiscContacts& out)
      : A_(A),
        B_(B),
        body_(*A.of),
        apart_(apart),
        same_(same),
        loose_(4.0 * kSameFeature * std::max(A.of->halfWidth(), B.thickness())),
        found_(4.0 * same),
        out_(out) {
    x_ = apart.n.unitOrthogonal(), y_ = apart.n.cross(x_);
    part_ = B.part(-apart.n), rim_ = B.rimAlong(-apart.n);
  }

  int contacts() {
    const int face = flatFace();
    if (apart_.corner >= 0) corner(apart_.corner, true);
    if (apart_.edge >= 0) edge(apart_.edge, true);
    if (face >= 0) {
      overFace(face);
      const Polyhedron::Face& f = body_.face(face);
      const int stride = (f.count + kMostDiscCorners - 1) / kMostDiscCorners;
      for (int i = f.first; i < f.first + f.count; i += stride) corner(body_.border(i).corner);
      for (int i = f.first; i < f.first + f.count; ++i) edge(body_.border(i).edge);
    } else {
      flatEdges();
    }
    if (found_.size() == 0) return any(face);
    return tellsOverlap(apart_.f, loose_, std::span(out_.data(), found_.size()))
               ? found_.size()
               : outermostPoints();
  }
  /// The face of A with a normal near n, −1: none.
  int flatFace() const {
    if (apart_.face >= 0) return apart_.face;
    const Vec3 n = A_.R.transpose() * apart_.n;
    const int f = faceAlong(body_, n);
    const bool flat = body_.face(f).n.cross(n).norm() < DiscBody::kFlat;
    return flat && body_.face(f).n.dot(n) > 0.0 ? f : -1;
  }

 private:
  using Part = DiscBody::Part;

  bool like(const Vec3& n) const { return n.dot(apart_.n) > kLikeFace; }
  /// Adds a contact unless there is one at its place. Edges, rims and sides that cross far from the
  /// place where the bodies meet may have a gap below the largest separation: not one of theirs.
  void add(int id, const ContactPoint& at) {
    if (like(at.d[0]) && at.g >= apart_.f - loose_ && found_.takes(x_.dot(at.P), y_.dot(at.P)))
      out_[static_cast<std::size_t>(found_.size() - 1)] = {id, at};
  }
  Vec3 inA(const Vec3& p) const { return A_.R.transpose() * (p - A_.c); }

  void overFace(int face) {
    const Polyhedron::Face& f = body_.face(face);
    const PlacedFace onA = A_.face(face, 1.0, true);
    const Vec3 n = A_.R * f.n;
    const bool flat = part_ == Part::cap;
    for (int rim = 0; rim < B_.rims(); ++rim) {
      // Unless B lies on its side, its far rim is above the near one.
      if ((part_ != Part::side && rim != rim_) || !B_.touches(-n, rim)) continue;
      const ContactPoint at = lowest(onA, rim);
      if (body_.over(f, inA(at.P), same_)) add(rim, at);
    }
    for (int k = 0; k < (flat ? 4 : 0); ++k) {
      const Vec3 p = B_.point(rim_, k) - B_.r * n;
      if (!body_.over(f, inA(p), same_)) continue;
      ContactPoint at;
      onA.contact(*B_.frame, p, at);
      // The contact of a tube with the face stays below the middle of the tube.
      at.Pdot += B_.r * (B_.frame->Omega_I.cross(n) - at.ddot[0]);
      add(2 + 4 * rim_ + k, at);
    }
  }
  ContactPoint lowest(const PlacedFace& onA, int rim) const {
    ContactPoint at;
    onA.contact(*B_.frame, B_.c, at);
    wander(B_, rim, at);
    ContactPoint there;
    onA.contact(*B_.frame, at.P, there);
    at.g = there.g;
    return at;
  }

  /// Contact of corner i with the part of B that faces −n; `best`: or with the rim.
  void corner(int i, bool best = false) {
    const Vec3 v = A_.vertex(i), way = v - B_.c;
    const double z = way.dot(B_.a), beside = B_.acrossAxis(way).norm();
    const int id = 10 + i;
    if (B_.tip && part_ != Part::cap && (part_ == Part::side || best)) {
      onCone(id, v, best);
    } else if (part_ == Part::cap && beside <= B_.rho + same_) {
      const double side = apart_.n.dot(B_.a) < 0.0 ? 1.0 : -1.0;
      const PlacedFace cap(*B_.frame, side * B_.a, B_.c, B_.half + B_.r, B_.x, -1.0, true);
      ContactPoint at;
      cap.contact(*A_.frame, v, at);
      add(id, at);
    } else if ((part_ == Part::side || best) && std::abs(z) <= B_.half + same_) {
      onPoint(id, B_.axis(), v);
    } else if (best) {
      onPoint(id, B_.rim(rim_, -apart_.n), v);
    }
  }
  /// A contact whose normal is from B.
  void addFromB(int id, ContactPoint at) {
    for (const int k : {0, 1}) at.d[k] = -at.d[k], at.ddot[k] = -at.ddot[k];
    add(id, at);
  }
  void onPoint(int id, const BodyCurve& curve, const Vec3& v) {
    addFromB(id, pointOnCurve(curve, *A_.frame, v, 0.0, -apart_.n));
  }
  /// Contact of a corner with the side of a cone; `best`: or with its rim, or its tip.
  void onCone(int id, const Vec3& v, bool best) {
    double s = 0.0;
    const ContactPoint at = pointOnSide(B_, *A_.frame, v, 0.0, s);
    if (s >= -same_ && s <= B_.slant() + same_) return addFromB(id, at);
    if (!best) return;
    if (rim_ == 0) return onPoint(id, B_.rim(0, -apart_.n), v);
    const Vec3 p = B_.middle(1), vA = A_.frame->velocity(v - A_.frame->r_OS_I);
    const Vec3 w = B_.frame->velocity(p - B_.frame->r_OS_I) - vA;
    add(id, fromWay(p - v, w, 0.0, B_.r, v, vA, apart_.n, Vec3::Zero()));
  }

  bool onEdge(const PlacedEdge& e, const Vec3& p) const {
    return std::abs(e.e.dot(p - e.o)) <= e.half + same_;
  }
  /// Contacts of edge i. `best`: n belongs to this edge, which then counts also without crossings.
  void edge(int i, bool best = false) {
    const PlacedEdge e = A_.edge(i);
    const BodyCurve line = BodyCurve::line(*A_.frame, e.o, e.e, 0.0);
    const int onRim = 10 + static_cast<int>(body_.corners().size() + body_.edges().size()) + 4 * i;
    const int onSide = 10 + static_cast<int>(body_.corners().size()) + i;
    if (B_.tip) {
      edgeOnCone(e, line, onSide, onRim, best);
    } else if (part_ != Part::cap && B_.half > 0.0 && e.e.cross(B_.a).norm() > kCross) {
      BodyCurve own = line, axis = B_.axis();
      if (toClosest(own, axis) && onEdge(e, own.x) &&
          std::abs(B_.a.dot(axis.x - B_.c)) <= B_.half + same_)
        add(onSide, curveOnCurve(own, axis, apart_.n));
    }
    if (B_.rho == 0.0) return;
    if (part_ == Part::cap) {
      BodyCurve crossing[2];
      const int n = B_.crossings(rim_, e.o, e.e, apart_.n, crossing);
      for (int k = 0; k < n; ++k) onRimAt(e, line, crossing[k], onRim + 2 * rim_ + k);
      if (n > 0) return;
    }
    if (!best) return;
    for (int rim = 0; rim < B_.rims(); ++rim)
      if (B_.radius(rim) > 0.0 && (part_ == Part::side || rim == rim_)) {
        const BodyCurve at = B_.rim(rim, -apart_.n);
        onRimAt(e, line, at, onRim + 2 * rim + (e.e.dot(at.x - at.c) > 0.0 ? 1 : 0));
      }
  }
  /// Contact of an edge with the side of a cone, and with its tip.
  void edgeOnCone(const PlacedEdge& e, const BodyCurve& line, int onSide, int onRim, bool best) {
    if (part_ == Part::cap) return;
    double s = 0.0, along = 0.0;
    ContactPoint at;
    if (lineOnSide(B_, *A_.frame, e.o, e.e, -apart_.n, s, along, at) &&
        std::abs(along) <= e.half + same_ && s >= -same_ && s <= B_.slant() + same_)
      add(onSide, at);
    if (!best || (part_ != Part::side && rim_ == 0)) return;
    at = pointOnCurve(line, *B_.frame, B_.middle(1), B_.r, apart_.n);
    if (onEdge(e, B_.middle(1))) add(onRim + 2, at);
  }
  void onRimAt(const PlacedEdge& e, BodyCurve line, BodyCurve rim, int id) {
    line.go(e.e.dot(rim.x - line.x));
    if (toClosest(line, rim) && onEdge(e, line.x)) add(id, curveOnCurve(line, rim, apart_.n));
  }

  /// If an edge lies along the part of B: the edges across n, with their corners.
  void flatEdges() {
    const Vec3 n = A_.R.transpose() * apart_.n;
    double along = 0.0;
    const int lowest = outermost(body_, n, along);
    for (int i = 0; i < static_cast<int>(body_.edges().size()); ++i) {
      const Polyhedron::Edge& e = body_.edge(i);
      const double middle = n.dot(e.middle);
      if (i != apart_.edge && along - middle > 1e-12 + e.half * DiscBody::kFlat) continue;
      if (std::abs(e.e.dot(n)) > DiscBody::kFlat) continue;
      edge(i, true);
      for (const double s : {-1.0, 1.0}) nearestCorner(e.middle + s * e.half * e.e);
    }
    corner(lowest);
  }
  void nearestCorner(const Vec3& p) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(body_.corners().size()); ++i)
      if ((body_.corner(i) - p).squaredNorm() < (body_.corner(best) - p).squaredNorm()) best = i;
    corner(best);
  }

  /// If features fit only up to rounding: a contact of the feature that n belongs to, or of the face
  /// along n, unless B is beside that face.
  int any(int face) {
    if (face < 0 || !B_.touches(-A_.R * body_.face(face).n)) return outermostPoints();
    out_[0] = {rim_, lowest(A_.face(face, 1.0, true), rim_)};
    return out_[0].at.g >= apart_.f - loose_ ? 1 : outermostPoints();
  }
  /// A single contact of the outermost points along n. If n belongs to a face or edge of A, it
  /// stays fixed in A, else in B.
  int outermostPoints() {
    const Vec3& n = apart_.n;
    double along = 0.0;
    const int v = outermost(body_, A_.R.transpose() * n, along);
    NumberedContact& c = out_[0];
    c.id = 10 + v;
    if ((apart_.face >= 0 || apart_.edge >= 0) && B_.touches(-n, rim_)) {
      setDirections(c.at, n, A_.frame->Omega_I.cross(n), Vec3::Zero());
      wander(B_, rim_, c.at);
      c.at.g = n.dot(c.at.P - A_.c) - along;
      return 1;
    }
    const PlacedFace cap(*B_.frame, -n, B_.c, B_.support(-n) + n.dot(B_.c), x_, -1.0, true);
    cap.contact(*A_.frame, A_.vertex(v), c.at);
    return 1;
  }

  const PlacedPolyhedron& A_;
  const DiscBody& B_;
  const Polyhedron& body_;
  const Apart& apart_;
  double same_, loose_;
  Vec3 x_, y_;
  Part part_ = Part::rim;
  int rim_ = 0;
  Manifold<kMostDiscContacts> found_;
  DiscContacts& out_;
};

double sameOf(const PlacedPolyhedron& A, const DiscBody& B) {
  return kSameFeature * std::min(A.of->halfWidth(), B.thickness());
}

}  // namespace

int discFeatures(const Polyhedron& A) {
  return 10 + static_cast<int>(A.corners().size() + 5 * A.edges().size());
}

int discOnPolyhedron(const PlacedPolyhedron& A, const DiscBody& B, double reach, double close,
                     bool rates, DiscContacts& out) {
  const double same = sameOf(A, B);
  const Apart apart = Search(A, B).best(reach, 4.0 * same);
  if (apart.f > reach) return 0;
  Manifolds all(A, B, apart, same, out);
  const int n = all.contacts();
  if (all.flatFace() >= 0)
    closeTogether(A, close, rates, {out.data(), static_cast<std::size_t>(n)});
  return n;
}

double separation(const PlacedPolyhedron& A, const DiscBody& B) {
  return Search(A, B).best(kInfinity, 0.0).f;
}

}  // namespace dynamy
