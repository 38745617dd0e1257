#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/disc_features.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <limits>
#include <numbers>

namespace dynamy {
namespace {

constexpr int kRimPoints = 8, kOfCorner = 5, kOfEdge = 6;
/// Sine of the tilt below which a rim has no lowest point.
constexpr double kLevelRim = 1e-12;
constexpr int kPlaces = 16;  ///< of a circle, between which its distance to a line has one minimum
constexpr double kBesideFoot = 0.01;  ///< [rad], less than between two places that have a normal
constexpr int kMostHalvings = 60;

int number(const auto& parts) { return static_cast<int>(parts.size()); }

double beyondEnd(double half, double s) { return (1.0 + kBeyondEnd) * half - std::abs(s); }

/// By how much the lowest point of a rim over a plane with the normal n is below its middle [m].
double liftOf(const DiscBody& B, int rim, const Vec3& n) {
  return B.radius(rim) * B.acrossAxis(n).norm();
}

/// A function of an angle at a place, and its rate.
struct Slope {
  double angle, value, rate;
};

/// Does f(angle) rise through zero between l and r? Two places may come together between them: then
/// f has an extremum there, on the other side of zero. If so, l and r become a bracket.
template <class F>
bool risesThroughZero(const F& f, Slope& l, Slope& r) {
  if (l.value < 0.0 && r.value >= 0.0) return true;
  const bool positive = l.value > 0.0;
  if (!(l.value * r.value > 0.0) || (l.rate < 0.0) != positive || (r.rate > 0.0) != positive)
    return false;
  double from = l.angle, to = r.angle;
  for (int k = 0; k < kMostHalvings && to - from > 1e-12; ++k) {
    const Slope m = f(0.5 * (from + to));
    if (m.value * l.value < 0.0) {
      (positive ? l : r) = m;
      return true;
    }
    ((m.rate < 0.0) == positive ? from : to) = m.angle;
  }
  return false;
}

/// The root of f between l and r, where it is below and above zero.
template <class F>
double rootBetween(const F& f, Slope l, Slope r) {
  for (int k = 0; k < kMostHalvings && r.angle - l.angle > 1e-16; ++k) {
    const double secant = (l.angle * r.value - r.angle * l.value) / (r.value - l.value);
    const double m =
        k % 3 == 2 || !(secant > l.angle && secant < r.angle) ? 0.5 * (l.angle + r.angle) : secant;
    if (!(m > l.angle && m < r.angle)) break;
    const Slope at = f(m);
    if (at.value == 0.0) return m;
    (at.value < 0.0 ? l : r) = at;
  }
  return std::abs(l.value) < std::abs(r.value) ? l.angle : r.angle;
}

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

/// Sines of the angles by which n lies within the normals of a corner, of an edge, and of a rim, this
/// one with its margins.
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

/// From the cap on it passes to corners and other crossings, with a margin; to the side with none.
double DiscFeatures::withinRim(const BodyCurve& at, int rim, const Vec3& n) const {
  const double out = kBeyondNormals - n.dot((at.x - at.c) / at.rho);
  if (B_.half == 0.0) return out;
  const Vec3 along =
      B_.tip ? Vec3((B_.middle(1) - at.x) / B_.slant()) : Vec3((rim == 1 ? -1.0 : 1.0) * B_.a);
  return std::min(out, kBeyondEnd + n.dot(along));
}

FollowedPair DiscFeatures::rimOverFace(int rim, int face) const {
  if (rim >= B_.rims()) return absent(B_.c);
  const PlacedFace on = A_.face(face, 1.0, true);
  const Vec3 n = A_.R * body_.face(face).n;
  const double rho = B_.radius(rim), lifted = liftOf(B_, rim, n);
  FollowedPair out;
  if (rho > 0.0 && lifted <= kLevelRim * rho) {
    out = pointOverFace(rim, 0, face);
    out.presence = lifted - ContactSink::kLowest * flat_;
    return out;
  }
  on.contact(*B_.frame, B_.c, out.at);
  wander(B_, rim, out.at);
  ContactPoint there;
  on.contact(*B_.frame, out.at.P, there);
  out.at.g = there.g;
  // A tip passes the border of a face as a corner does.
  out.presence = (rho > 0.0 ? kBeyondEnd * size_ : same_) + inside(face, out.at.P);
  if (const double raised = lifted - ContactSink::kLowest * flat_;
      rho > 0.0 && raised < out.presence) {
    out.presence = raised;
    if (lifted < DiscBody::kFlat * rho) out.circle = lifted;
  }
  return out;
}

FollowedPair DiscFeatures::pointOverFace(int rim, int k, int face) const {
  if (rim >= B_.rims() || B_.radius(rim) == 0.0) return absent(B_.c);
  const Vec3 n = A_.R * body_.face(face).n, p = B_.point(rim, k) - B_.r * n;
  FollowedPair out;
  A_.face(face, 1.0, true).contact(*B_.frame, p, out.at);
  // The contact of a tube with the face stays below the middle of the tube.
  out.at.Pdot += B_.r * (B_.frame->Omega_I.cross(n) - out.at.ddot[0]);
  out.presence = std::min(same_ + inside(face, p), flat_ - liftOf(B_, rim, n));
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

/// The square of the distance of a place of the circle from the line has the derivative 2 ρ d·t, with
/// d across the line and t the tangent: a trigonometric polynomial of degree 2.
DiscFeatures::Nearest DiscFeatures::nearest(const PlacedEdge& e, int rim) const {
  const Vec3 middle = B_.middle(rim), X = B_.x, Y = B_.a.cross(B_.x);
  const double rho = B_.radius(rim);
  const auto slope = [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Vec3 out = c * X + s * Y, t = c * Y - s * X, way = middle - e.o + rho * out;
    const Vec3 d = way - e.e.dot(way) * e.e;
    const double along = e.e.dot(t);
    return Slope{angle, d.dot(t), rho * (1.0 - along * along) - d.dot(out)};
  };
  Nearest out;
  const double width = 2.0 * std::numbers::pi / kPlaces;
  // The places of a line that slides off come together around its place nearest to the middle. The
  // search begins beside it: that of a line along the axis is there.
  const Vec3 foot = e.o - middle - e.e.dot(e.o - middle) * e.e;
  const double first = std::atan2(foot.dot(Y), foot.dot(X)) + kBesideFoot;
  Slope a = slope(first);
  for (int i = 1; i <= kPlaces && out.count < 2; ++i) {
    const Slope b = slope(first + i * width);
    if (Slope l = a, r = b; risesThroughZero(slope, l, r)) {
      const double at = rootBetween(slope, l, r);
      out.at[out.count++] = B_.rim(rim, std::cos(at) * X + std::sin(at) * Y);
    }
    a = b;
  }
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
  const Nearest places = nearest(e, rim);
  const double side = which == 0 ? -1.0 : 1.0;
  const BodyCurve* best = nullptr;
  double most = 0.0, least = 0.0;
  for (int k = 0; k < places.count; ++k) {
    const BodyCurve& at = places.at[k];
    const double along = side * e.e.dot(at.x - at.c) + kBeyondEnd * size_, s = e.e.dot(at.x - e.o),
                 distance = (at.x - e.o - s * e.e).norm();
    const bool better =
        best == nullptr || (along > 0.0 && most > 0.0 ? distance < least : along > most);
    if (better) best = &at, most = along, least = distance;
  }
  // A sharp rim along an edge has no normal.
  if (best == nullptr || (B_.r == 0.0 && e.e.cross(best->t).norm() < kCross)) return absent(e.o);
  FollowedPair out;
  out.at = onRim(e, edge, *best);
  const Vec3& n = out.at.d[0];
  out.presence =
      std::min({most, beyondEnd(e.half, e.e.dot(best->x - e.o)),
                size_ * std::min(kBeyondEnd + withinEdge(edge, n), withinRim(*best, rim, n))});
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
      const Nearest places = nearest(e, rim);
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
