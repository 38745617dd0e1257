#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/disc_features.hpp>
#include <dynamy_elements/contacts/pairs/rim_places.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr int kRimPoints = 8, kOfCorner = 5, kOfEdge = 6;
int number(const auto& parts) { return static_cast<int>(parts.size()); }

}  // namespace

DiscFeatures::DiscFeatures(const PlacedPolyhedron& A, const DiscBody& B, double flat)
    : A_(A),
      B_(B),
      body_(*A.of),
      flat_(flat),
      same_(kSameFeature * std::min(A.of->halfWidth(), B.thickness())),
      size_(std::min(A.of->halfWidth(), B.thickness())) {}

int DiscFeatures::count(const Polyhedron& A) {
  return (2 + kRimPoints) * number(A.faces()) + kOfCorner * number(A.corners()) +
         kOfEdge * number(A.edges());
}

std::string DiscFeatures::name(const Polyhedron& A, int f) {
  const int faces = number(A.faces()), corners = number(A.corners());
  const auto text = [](int i) { return std::to_string(i); };
  if (f < 2 * faces) return "B.rim" + text(f / faces) + "-A.face" + text(f % faces);
  f -= 2 * faces;
  if (f < kRimPoints * faces) {
    const int point = f / faces;
    return "B.rim" + text(point / 4) + ".point" + text(point % 4) + "-A.face" + text(f % faces);
  }
  f -= kRimPoints * faces;
  constexpr const char* kOn[] = {"-B.cap0", "-B.cap1", "-B.side", "-B.tube0", "-B.tube1"};
  if (f < kOfCorner * corners) return "A.corner" + text(f / kOfCorner) + kOn[f % kOfCorner];
  f -= kOfCorner * corners;
  const int at = f % kOfEdge;
  const std::string edge = "A.edge" + text(f / kOfEdge);
  if (at < 2) return edge + (at == 0 ? "-B.side" : "-B.side.1");
  return edge + "-B.rim" + text((at - 2) / 2) + "." + text(at % 2);
}

FollowedPair DiscFeatures::pair(int f) const {
  const int faces = number(body_.faces()), corners = number(body_.corners());
  if (f < 2 * faces) return rimOverFace(f / faces, f % faces);
  f -= 2 * faces;
  if (f < kRimPoints * faces) return pointOverFace(f / faces / 4, f / faces % 4, f % faces);
  f -= kRimPoints * faces;
  if (f < kOfCorner * corners) {
    const int corner = f / kOfCorner, on = f % kOfCorner;
    if (on < 2) return cornerOnCap(on, corner);
    return on == 2 ? cornerOnSide(corner) : cornerOnTube(on - 3, corner);
  }
  f -= kOfCorner * corners;
  const int edge = f / kOfEdge, on = f % kOfEdge;
  return on < 2 ? edgeOnSide(edge, on) : edgeOnRim(edge, (on - 2) / 2, on % 2);
}

FollowedPair DiscFeatures::absent(const Vec3& at) const {
  FollowedPair out;
  setDirections(out.at, Vec3::UnitZ(), Vec3::Zero(), Vec3::Zero());
  out.at.g = size_, out.at.P = at, out.presence = -size_;
  return out;
}

double DiscFeatures::inside(int face, const Vec3& p) const {
  return dynamy::inside(body_, body_.face(face), A_.R.transpose() * (p - A_.c));
}

/// Sines of the angles by which n lies within the normals of a corner, and of an edge.
double DiscFeatures::withinCone(int corner, const Vec3& n) const {
  const Vec3 local = A_.R.transpose() * n;
  double least = std::numeric_limits<double>::infinity();
  for (const int other : body_.neighbours(corner))
    least = std::min(least, -local.dot((body_.corner(other) - body_.corner(corner)).normalized()));
  return least;
}

double DiscFeatures::withinEdge(int edge, const Vec3& n) const {
  return withinNormals(body_, body_.edge(edge), A_.R.transpose() * n);
}

FollowedPair DiscFeatures::rimOverFace(int rim, int face) const {
  if (rim >= B_.rims()) return absent(B_.c);
  // A tip passes the border of a face as a corner does.
  const double beyond = B_.radius(rim) > 0.0 ? kBeyondEnd * size_ : same_;
  return rimOverPlane(A_.face(face, 1.0, true), A_.R * body_.face(face).n, B_, rim, flat_,
                      [&](const ContactPoint& at) { return beyond + inside(face, at.P); });
}

FollowedPair DiscFeatures::pointOverFace(int rim, int k, int face) const {
  if (rim >= B_.rims() || B_.radius(rim) == 0.0) return absent(B_.c);
  const Vec3 n = A_.R * body_.face(face).n;
  FollowedPair out = pointOverPlane(A_.face(face, 1.0, true), n, B_, rim, k, flat_);
  out.presence = std::min(same_ + inside(face, B_.point(rim, k) - B_.r * n), out.presence);
  return out;
}

FollowedPair DiscFeatures::cornerOnCap(int cap, int corner) const {
  const Vec3 v = A_.vertex(corner);
  if (B_.rho == 0.0 || (B_.tip && cap == 1)) return absent(v);
  const double side = cap == 1 ? 1.0 : -1.0;
  FollowedPair out;
  PlacedFace(*B_.frame, side * B_.a, B_.c, B_.half + B_.r, B_.x, -1.0, true)
      .contact(*A_.frame, v, out.at);
  out.presence = same_ + B_.rho - B_.acrossAxis(v - B_.c).norm();
  return out;
}

FollowedPair DiscFeatures::cornerOnSide(int corner) const {
  const Vec3 v = A_.vertex(corner);
  if (B_.half == 0.0) return absent(v);
  FollowedPair out;
  if (B_.tip) {
    double s = 0.0;
    out.at = pointOnSide(B_, *A_.frame, v, 0.0, s);
    out.presence = beyondEnd(0.5 * B_.slant(), s - 0.5 * B_.slant());
  } else {
    const LineSegment axis(*B_.frame, B_.c, B_.a, B_.half);
    out.at = overSegment(axis, B_.rho + B_.r, v, A_.frame->velocity(v - A_.frame->r_OS_I), 0.0,
                         Vec3::Zero());
    out.presence = beyondEnd(B_.half, B_.a.dot(v - B_.c));
  }
  turnRound(out.at);
  out.presence = std::min(out.presence, size_ * (kBeyondEnd + withinCone(corner, out.at.d[0])));
  return out;
}

FollowedPair DiscFeatures::cornerOnTube(int rim, int corner) const {
  const Vec3 v = A_.vertex(corner);
  if (B_.r == 0.0 || B_.rho == 0.0 || rim >= B_.rims()) return absent(v);
  const Vec3 way = v - B_.middle(rim), beside = B_.acrossAxis(way);
  if (!(beside.norm() > kLevelRim * B_.rho)) return absent(v);
  FollowedPair out;
  out.at = pointOnCurve(B_.rim(rim, way), *A_.frame, v, 0.0, beside.normalized());
  const double outward = out.at.d[0].dot(beside.normalized());
  turnRound(out.at);
  out.presence = size_ * (kBeyondEnd + std::min(outward, withinCone(corner, out.at.d[0])));
  return out;
}

/// The side of a cone has two normals across an edge, mirrored on the plane of edge and axis.
FollowedPair DiscFeatures::edgeOnSide(int edge, int normal) const {
  const PlacedEdge e = A_.edge(edge);
  if (B_.half == 0.0 || (normal == 1 && !B_.tip)) return absent(e.o);
  FollowedPair out;
  if (B_.tip) {
    const Vec3 towards = (normal == 0 ? -1.0 : 1.0) * e.e.cross(B_.a);
    double s = 0.0, along = 0.0;
    if (!lineOnSide(B_, *A_.frame, e.o, e.e, towards, s, along, out.at, kParallel))
      return absent(e.o);
    out.presence =
        std::min(beyondEnd(e.half, along), beyondEnd(0.5 * B_.slant(), s - 0.5 * B_.slant()));
  } else {
    const LineSegment line(*A_.frame, e.o, e.e, e.half), axis(*B_.frame, B_.c, B_.a, B_.half);
    const SegmentCrossing at(line, axis);
    if (at.square < kParallel) return absent(e.o);
    out.at = across(line, 0.0, axis, B_.rho + B_.r, at);
    out.presence = std::min(beyondEnd(e.half, at.s), beyondEnd(B_.half, at.t));
  }
  out.presence = std::min(out.presence, size_ * (kBeyondNormals + withinEdge(edge, out.at.d[0])));
  return out;
}

ContactPoint DiscFeatures::onRim(const PlacedEdge& e, int edge, const BodyCurve& rim) const {
  BodyCurve line = BodyCurve::line(*A_.frame, e.o, e.e, 0.0);
  line.go(e.e.dot(rim.x - line.x));
  const Vec3 d = rim.x - line.x;
  return curveOnCurve(
      line, rim,
      B_.r > 0.0 && d.norm() > 0.5 * B_.r ? d : Vec3(A_.R * outOf(body_, body_.edge(edge))));
}

/// Place `which` is the one on the negative or positive half of the circle along the edge; the nearest
/// of two, and if there is none, the one that is nearest to this half.
FollowedPair DiscFeatures::edgeOnRim(int edge, int rim, int which) const {
  const PlacedEdge e = A_.edge(edge);
  if (rim >= B_.rims() || B_.radius(rim) == 0.0) return absent(e.o);
  const RimPlaces places = rimPlaces(B_, rim, e);
  const double side = which == 0 ? -1.0 : 1.0;
  double most = 0.0;
  const BodyCurve* best = places.chosen(
      [&](const BodyCurve& at) { return side * e.e.dot(at.x - at.c) + kBeyondEnd * size_; },
      [&](const BodyCurve& at) { return (at.x - e.o - e.e.dot(at.x - e.o) * e.e).norm(); }, most);
  // A sharp rim along an edge has no normal.
  if (best == nullptr || (B_.r == 0.0 && e.e.cross(best->t).norm() < kCross)) return absent(e.o);
  FollowedPair out;
  out.at = onRim(e, edge, *best);
  const Vec3& n = out.at.d[0];
  out.presence = std::min({most, beyondEnd(e.half, e.e.dot(best->x - e.o)),
                           size_ * std::min(kBeyondEnd + withinEdge(edge, n),
                                            withinRim(B_, *best, rim, -n, kBeyondNormals))});
  return out;
}

void DiscFeatures::near(const Nearness& within, std::vector<int>& out) const {
  const int faces = number(body_.faces()), corners = number(body_.corners()),
            edges = number(body_.edges());
  const double reach = within.reach, around = B_.rho + B_.r + reach;
  const auto closes = [&](const FollowedPair& pair, int face) {
    return std::abs(pair.at.g) <= reach && inside(face, pair.at.P) >= -reach;
  };
  for (int f = 0; f < 2 * faces; ++f)
    if (f / faces < B_.rims() && closes(rimOverFace(f / faces, f % faces), f % faces))
      out.push_back(f);
  for (int f = 0; f < kRimPoints * faces; ++f) {
    const int rim = f / faces / 4, face = f % faces;
    if (rim >= B_.rims() || B_.radius(rim) == 0.0) continue;
    const double lifted = liftOf(B_, rim, A_.R * body_.face(face).n);
    if (lifted > flat_ + reach + within.turn * B_.radius(rim)) continue;
    if (closes(pointOverFace(rim, f / faces % 4, face), face)) out.push_back(2 * faces + f);
  }
  int first = (2 + kRimPoints) * faces;
  const PlacedEdge axis{B_.c, B_.a, B_.half};
  for (int v = 0; v < corners; ++v, first += kOfCorner) {
    const Vec3 p = A_.vertex(v), way = p - B_.c;
    if ((B_.nearest(p) - p).norm() > B_.r + reach) continue;
    for (int cap = 0; cap < 2; ++cap)
      if (B_.rho > 0.0 && !(B_.tip && cap == 1) &&
          std::abs((cap == 1 ? 1.0 : -1.0) * way.dot(B_.a) - B_.half - B_.r) <= reach)
        out.push_back(first + cap);
    if (B_.half > 0.0) out.push_back(first + 2);
    for (int rim = 0; rim < B_.rims() && B_.r > 0.0; ++rim) out.push_back(first + 3 + rim);
  }
  for (int i = 0; i < edges; ++i, first += kOfEdge) {
    const PlacedEdge e = A_.edge(i);
    if (distance(e, axis) > around) continue;
    const double most = kBeyondNormals + 20.0 * within.turn;
    const auto lies = [&](const Vec3& n) { return most > 1.0 || withinEdge(i, n) >= -most; };
    for (int normal = 0; normal < (B_.tip ? 2 : 1) && B_.half > 0.0; ++normal)
      if (const FollowedPair side = edgeOnSide(i, normal);
          std::abs(side.at.g) <= reach && lies(side.at.d[0]))
        out.push_back(first + normal);
    for (int rim = 0; rim < B_.rims(); ++rim) {
      if (B_.radius(rim) == 0.0) continue;
      const RimPlaces places = rimPlaces(B_, rim, e);
      bool any = false;
      for (int k = 0; k < places.count; ++k) {
        const double s = e.e.dot(places.at[k].x - e.o);
        any = any || (std::abs(s) <= e.half + reach &&
                      (places.at[k].x - e.o - s * e.e).norm() <= B_.r + reach);
      }
      for (int k = 0; k < 2 && any; ++k) out.push_back(first + 2 + 2 * rim + k);
    }
  }
}

}  // namespace dynamy
