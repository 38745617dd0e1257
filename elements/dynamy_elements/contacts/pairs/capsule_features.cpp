#include <algorithm>
#include <dynamy/contact/followed_features.hpp>
#include <dynamy_elements/contacts/pairs/box_contact.hpp>
#include <dynamy_elements/contacts/pairs/capsule_features.hpp>
#include <dynamy_elements/contacts/pairs/round_contact.hpp>
#include <dynamy_elements/contacts/shapes/surface.hpp>

namespace dynamy {
namespace {

double insideOf(const LineSegment& a, double s) {
  return (1.0 + kBeyondEnd) * a.half - std::abs(s);
}

double distanceTo(const LineSegment& a, const Vec3& p) {
  const double s = std::clamp(a.e.dot(p - a.o), -a.half, a.half);
  return (p - a.o - s * a.e).norm();
}

/// Presence of an end that is a half ball, with the normal n from it to the other body.
double onCap(double radius, const Vec3& outward, const Vec3& n) {
  return radius * (kBeyondEnd + outward.dot(n));
}

Vec3 outward(const LineSegment& axis, int end) { return end == 0 ? Vec3(-axis.e) : axis.e; }

/// A pair that is not there.
FollowedPair absent(const Vec3& at, double size, const Vec3& plane) {
  FollowedPair out;
  const Vec3 n = plane.isZero(0.0) ? Vec3::UnitZ() : Vec3(plane.unitOrthogonal());
  setDirections(out.at, n, Vec3::Zero(), plane);
  out.at.g = size, out.at.P = at, out.presence = -size;
  return out;
}

/// Number k of an edge of a box: its axis is k/4, bits 0 and 1 are the signs on the two others.
struct BoxEdge {
  int along, u, v;
  double atU, atV;  ///< ±1
  explicit BoxEdge(int k)
      : along(k / 4),
        u((along + 1) % 3),
        v((along + 2) % 3),
        atU((k & 1) != 0 ? 1.0 : -1.0),
        atV((k & 2) != 0 ? 1.0 : -1.0) {}
};

}  // namespace

CapsuleFeatures::CapsuleFeatures(const Frame& A, const TouchingShape& body, const Frame& B,
                                 const TouchingShape& capsule)
    : A_(A),
      B_(B),
      body_(body),
      capsule_(capsule),
      R_(body.surface ? A.A_IK : Mat3(A.A_IK * body.A_KB)),
      c_(body.surface ? A.r_OS_I : Vec3(A.r_OS_I + A.A_IK * body.p_K)),
      axis_(capsuleAxis(B, capsule)),
      radius_(capsule.thickness) {}

int CapsuleFeatures::count(const TouchingShape& body) {
  return body.surface ? 2 + body.surface->edges() + body.surface->corners() : 2 + 12 + 8;
}

int CapsuleFeatures::edges() const { return body_.surface ? body_.surface->edges() : 12; }

int CapsuleFeatures::corners() const { return body_.surface ? body_.surface->corners() : 8; }

CapsuleFeatures::Edge CapsuleFeatures::edge(int i) const {
  Vec3 middle, e, nf, ng;
  double half = 0.0;
  if (body_.surface) {
    const Surface& s = *body_.surface;
    const Surface::Edge& at = s.edge(i);
    const Vec3 &a = s.at(at.a), &b = s.at(at.b);
    middle = 0.5 * (a + b), half = 0.5 * (b - a).norm(), e = (b - a) / (2.0 * half);
    nf = s.faces()[static_cast<std::size_t>(at.f)].n;
    ng = s.faces()[static_cast<std::size_t>(at.g)].n;
  } else {
    const BoxEdge at(i);
    nf = at.atU * Vec3::Unit(at.u), ng = at.atV * Vec3::Unit(at.v);
    e = Vec3::Unit(at.along), half = body_.half[at.along];
    middle = body_.half[at.u] * nf + body_.half[at.v] * ng;
  }
  return {LineSegment(A_, c_ + R_ * middle, R_ * e, half), R_ * nf, R_ * ng,
          nf.cross(ng).dot(e) < 0.0 ? -1.0 : 1.0};
}

double CapsuleFeatures::Edge::within(const Vec3& n) const {
  return std::min(along * nf.cross(n).dot(line.e), along * n.cross(ng).dot(line.e));
}

Vec3 CapsuleFeatures::corner(int i) const {
  if (body_.surface) return c_ + R_ * body_.surface->at(body_.surface->corner(i).v);
  return c_ + R_ * placedBox(A_, body_).corner(i);
}

double CapsuleFeatures::withinCone(int i, const Vec3& n) const {
  const Vec3 m = R_.transpose() * n;
  double least = std::numeric_limits<double>::infinity();
  if (body_.surface) {
    const Surface& s = *body_.surface;
    const Surface::Corner& at = s.corner(i);
    for (const int other : at.others)
      least = std::min(least, -m.dot((s.at(other) - s.at(at.v)).normalized()));
    return least;
  }
  const Vec3 p = placedBox(A_, body_).corner(i);
  for (int k = 0; k < 3; ++k) least = std::min(least, p[k] < 0.0 ? -m[k] : m[k]);
  return least;
}

FollowedPair CapsuleFeatures::end(int i) const {
  const RoundFeature& ball = capsule_.features[static_cast<std::size_t>(i)];
  FollowedPair out;
  bool overFace = false;
  if (body_.surface) {
    SurfaceContacts all;
    const int n = body_.surface->contacts(A_, B_, ball, kInfinity, all);
    if (n == 0) return absent(axis_.o, axis_.half + radius_, Vec3::Zero());
    const auto nearest = std::min_element(
        all.begin(), all.begin() + n,
        [](const SurfaceContact& a, const SurfaceContact& b) { return a.at.g < b.at.g; });
    out.at = nearest->at;
    overFace = nearest->id < static_cast<int>(body_.surface->faces().size());
  } else {
    out.at = ballOnBox(A_, body_, B_, ball, Vec3::Zero());
    const Vec3 c = R_.transpose() * (B_.r_OS_I + B_.A_IK * ball.c_K - c_);
    overFace = (c.array().abs() > body_.half.array()).count() < 2;
  }
  // Where a side lies on a face, its ends carry it.
  out.presence =
      overFace ? FollowedFeatures::kAlways : onCap(radius_, outward(axis_, i), -out.at.d[0]);
  return out;
}

FollowedPair CapsuleFeatures::pair(int f) const {
  if (f < 2) return end(f);
  f -= 2;
  FollowedPair out;
  if (f < edges()) {
    const Edge e = edge(f);
    const SegmentCrossing at(e.line, axis_);
    if (at.square < kParallel) return absent(e.line.o, e.line.half, Vec3::Zero());
    out.at = across(e.line, 0.0, axis_, radius_, at);
    out.presence = std::min({insideOf(e.line, at.s), insideOf(axis_, at.t),
                             radius_ * (kBeyondNormals + e.within(out.at.d[0]))});
    return out;
  }
  f -= edges();
  const Vec3 c = corner(f);
  out.at = overSegment(axis_, radius_, c, A_.velocity(c - A_.r_OS_I), 0.0, Vec3::Zero());
  turnRound(out.at);
  out.presence = std::min(insideOf(axis_, axis_.e.dot(c - axis_.o)),
                          radius_ * (kBeyondEnd + withinCone(f, out.at.d[0])));
  return out;
}

void CapsuleFeatures::near(const Nearness& within, std::vector<int>& out) const {
  for (int i = 0; i < 2; ++i)
    if (end(i).at.g <= within.reach) out.push_back(i);
  const double reach = radius_ + within.reach, far = axis_.half + reach;
  for (int i = 0; i < edges(); ++i) {
    const Edge e = edge(i);
    if ((e.line.o - axis_.o).norm() > e.line.half + far ||
        distance(PlacedEdge{e.line.o, e.line.e, e.line.half},
                 PlacedEdge{axis_.o, axis_.e, axis_.half}) > reach)
      continue;
    const SegmentCrossing at(e.line, axis_);
    const double sine = std::sqrt(at.square),
                 beyond = kBeyondNormals + 2.0 * within.turn / std::max(sine, 1e-3);
    const bool lies = at.square < kParallel || beyond > 1.0 ||
                      e.within(across(e.line, 0.0, axis_, radius_, at).d[0]) >= -beyond;
    if (lies) out.push_back(2 + i);
  }
  for (int i = 0; i < corners(); ++i)
    if (distanceTo(axis_, corner(i)) <= reach) out.push_back(2 + edges() + i);
}

FollowedPair TwoCapsules::pair(int f) const {
  FollowedPair out;
  if (f == 0) {
    const SegmentCrossing at(axisA_, axisB_);
    if (at.square < kParallel || !plane_.isZero(0.0))
      return absent(axisA_.o, std::min(a_.bound, b_.bound), plane_);
    out.at = across(axisA_, a_.thickness, axisB_, b_.thickness, at);
    out.presence = std::min(insideOf(axisA_, at.s), insideOf(axisB_, at.t));
    return out;
  }
  const int end = (f - 1) % 2;
  const auto number = static_cast<std::size_t>(end);
  if (f < 3) {
    out.at = ballOnCapsule(A_, a_, B_, b_.features[number], plane_);
    out.presence = onCap(b_.thickness, outward(axisB_, end), -out.at.d[0]);
    return out;
  }
  const Vec3 rhoA = A_.A_IK * a_.features[number].c_K, c = A_.r_OS_I + rhoA;
  out.at = overSegment(axisB_, b_.thickness, c, A_.velocity(rhoA), a_.thickness, plane_);
  turnRound(out.at);
  out.presence = std::min(insideOf(axisB_, axisB_.e.dot(c - axisB_.o)),
                          onCap(a_.thickness, outward(axisA_, end), out.at.d[0]));
  return out;
}

void TwoCapsules::near(const Nearness& within, std::vector<int>& out) const {
  const double reach = a_.thickness + b_.thickness + within.reach;
  if (plane_.isZero(0.0) && distance(PlacedEdge{axisA_.o, axisA_.e, axisA_.half},
                                     PlacedEdge{axisB_.o, axisB_.e, axisB_.half}) <= reach)
    out.push_back(0);
  const auto end = [](const LineSegment& axis, int i) {
    return Vec3(axis.o + (i == 0 ? -axis.half : axis.half) * axis.e);
  };
  for (int i = 0; i < 2; ++i)
    if (distanceTo(axisA_, end(axisB_, i)) <= reach) out.push_back(1 + i);
  for (int i = 0; i < 2; ++i)
    if (distanceTo(axisB_, end(axisA_, i)) <= reach) out.push_back(3 + i);
}

}  // namespace dynamy
