#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <dynamy_elements/contacts/pairs/two_discs.hpp>
#include <numbers>

namespace dynamy {
namespace {

constexpr int kCapRims = 4, kCapPoints = 16;  ///< numbers of pairs, of rims on one body
constexpr int kParts = 8;                     ///< of a rim
/// Sine between two axes up to which their rims lie in nearly one plane.
constexpr double kOnePlane = 0.5;
/// Part of the size within which a sharp rim is at the tip of a cone.
constexpr double kAtTip = 1e-4;
/// Of the depth of a tip below a cap, from its presence there.
constexpr double kBelow = 10.0;

/// Length of the side along its lines [m].
double sideLength(const DiscBody& D) { return D.tip ? D.slant() : 2.0 * D.half; }

/// Sine of the angle by which m, a direction out of D, points from the side to a rim.
double towardsRim(const DiscBody& D, int rim, const Vec3& m) {
  if (D.half == 0.0) return 1.0;
  return rim == 1 ? D.fromSide(m) : -D.fromSide(m);
}

/// A direction out of D at a place of a rim.
Vec3 outOfRim(const DiscBody& D, int rim, const BodyCurve& at) {
  Vec3 out = (at.x - at.c) / at.rho;
  if (D.half == 0.0) return out;
  return D.cosine() * out + D.sine() * D.a + (rim == 1 ? 1.0 : -1.0) * D.a;
}

/// Distance of p from the circle of a rim [m].
double fromRim(const DiscBody& D, int rim, const Vec3& p) {
  const Vec3 way = p - D.middle(rim);
  return std::hypot(way.dot(D.a), D.acrossAxis(way).norm() - D.radius(rim));
}

/// Features of B on the caps and the side of A.
struct RimsOn {
  const DiscBody &A, &B;
  double flat, size;

  bool hasCap(int cap) const { return A.rho > 0.0 && !(A.tip && cap == 1); }
  double insideCap(const Vec3& p) const { return A.rho - A.acrossAxis(p - A.c).norm(); }
  Vec3 normal(int cap) const { return (cap == 1 ? 1.0 : -1.0) * A.a; }
  PlacedFace face(int cap) const {
    return {*A.frame, normal(cap), A.c, A.half + A.r, A.x, 1.0, true};
  }

  /// Of a ball of B's tube about p from the side of a cone, more beyond its tip, whose places count
  /// where there is no other; else of p from the axis [m].
  double distanceOf(const Vec3& p) const {
    const Vec3 way = p - (A.tip ? A.middle(1) : A.c);
    const double out = A.acrossAxis(way).norm();
    if (!A.tip) return out;
    const double nappe = nappeAt(A, B, way);
    return std::abs(out * A.cosine() + nappe * A.sine() * A.a.dot(way) - B.r) +
           (nappe < 0.0 ? A.slant() : 0.0);
  }

  bool overCap(int rim, int cap, FollowedPair& out) const {
    if (rim >= B.rims() || !hasCap(cap)) return false;
    const bool tip = B.radius(rim) + B.r == 0.0;
    out = rimOverPlane(face(cap), normal(cap), B, rim, flat, [&](const ContactPoint& at) {
      // A tip counts beyond the border up to where its side takes over; one that touches the side of
      // the body there is not over the cap.
      return insideCap(at.P) +
             (tip ? kAtTip * size - kBelow * std::max(0.0, -at.g) : kBeyondEnd * size);
    });
    return true;
  }

  bool pointOverCap(int rim, int k, int cap, FollowedPair& out) const {
    if (rim >= B.rims() || B.radius(rim) == 0.0 || !hasCap(cap)) return false;
    out = pointOverPlane(face(cap), normal(cap), B, rim, k, flat);
    const double inside = insideCap(B.point(rim, k) - B.r * normal(cap));
    out.presence = std::min(kSameFeature * size + inside, out.presence);
    return true;
  }

  /// A tip or the end of a capsule on the side.
  bool endOnSide(int rim, FollowedPair& out) const {
    const Vec3 p = B.middle(rim);
    if (A.tip) {
      double s = 0.0;
      out.at = pointOnSide(A, *B.frame, p, B.r, s);
      out.presence = beyondEnd(0.5 * A.slant(), s - 0.5 * A.slant());
    } else {
      const LineSegment axis(*A.frame, A.c, A.a, A.half);
      out.at = overSegment(axis, A.rho + A.r, p, B.frame->velocity(p - B.frame->r_OS_I), B.r,
                           Vec3::Zero());
      out.presence = beyondEnd(A.half, A.a.dot(p - A.c));
    }
    const double towards = kBeyondEnd + towardsRim(B, rim, -out.at.d[0]);
    out.presence = std::min(out.presence, size * towards);
    return true;
  }

  /// Place `which` is the one on the negative or positive half of the rim along the axis of A; the
  /// nearest of two, and if there is none, the one that is nearest to this half.
  bool onSide(int rim, int which, FollowedPair& out) const {
    if (rim >= B.rims() || A.half == 0.0) return false;
    if (B.radius(rim) == 0.0) return which == 0 && endOnSide(rim, out);
    const RimPlaces places =
        A.tip ? rimPlacesOverCone(B, rim, A) : rimPlaces(B, rim, PlacedEdge{A.c, A.a, A.half});
    const double side = which == 0 ? -1.0 : 1.0;
    double most = 0.0;
    const BodyCurve* best = places.chosen(
        [&](const BodyCurve& at) { return side * A.a.dot(at.x - at.c) + kBeyondEnd * size; },
        [&](const BodyCurve& at) { return distanceOf(at.x); }, most);
    // A rim through the axis of a cylinder has no normal to its side.
    if (best == nullptr || (!A.tip && !(distanceOf(best->x) > kCross * (A.rho + A.r))))
      return false;
    BodyCurve at = *best;
    double beyond = 0.0;
    if (A.tip) {
      double s = 0.0;
      if (!placeOnSide(A, at, nappeAt(A, B, at.x - A.middle(1)), s, out.at)) return false;
      // At the tip a sharp rim has no normal: its place is there once it is apart.
      const double apart = B.r > 0.0 ? -kBeyondEnd * A.slant() : kAtTip * size;
      beyond = std::min(s + kBeyondEnd * A.slant(), A.slant() - s - apart);
    } else {
      BodyCurve axis = BodyCurve::line(*A.frame, A.c, A.a, A.rho + A.r);
      axis.go(A.a.dot(at.x - A.c));
      out.at = curveOnCurve(axis, at, at.x - axis.x);
      beyond = beyondEnd(A.half, A.a.dot(at.x - A.c));
    }
    out.presence =
        std::min({most, beyond, size * withinRim(B, at, rim, -out.at.d[0], kBeyondNormals)});
    return true;
  }

  /// Pair f of those of the rims of B on A.
  bool find(int f, FollowedPair& out) const {
    if (f < kCapRims) return overCap(f / 2, f % 2, out);
    f -= kCapRims;
    if (f < kCapPoints) return pointOverCap(f / 8, f / 2 % 4, f % 2, out);
    f -= kCapPoints;
    return onSide(f / 2, f % 2, out);
  }
};

}  // namespace

TwoDiscs::TwoDiscs(const DiscBody& A, const DiscBody& B, double flat)
    : A_(A), B_(B), flat_(flat), size_(std::min(A.thickness(), B.thickness())) {}

std::string TwoDiscs::name(int f) {
  const auto text = [](int i) { return std::to_string(i); };
  if (f >= kRims) {
    const int rims = (f - kRims) / kOfRims, which = (f - kRims) % kOfRims;
    return "A.rim" + text(rims / 2) + "-B.rim" + text(rims % 2) +
           (which < 2 ? "." + text(which) : ".part" + text(which - 2));
  }
  if (f >= kSides) return f == kSides ? "sides" : "sides.1";
  const bool ofA = f >= kOnBody;
  f %= kOnBody;
  const std::string rim = ofA ? "A.rim" : "B.rim", on = ofA ? "-B." : "-A.";
  if (f < kCapRims) return rim + text(f / 2) + on + "cap" + text(f % 2);
  f -= kCapRims;
  if (f < kCapPoints)
    return rim + text(f / 8) + ".point" + text(f / 2 % 4) + on + "cap" + text(f % 2);
  f -= kCapPoints;
  return rim + text(f / 2) + "." + text(f % 2) + on + "side";
}

FollowedPair TwoDiscs::pair(int f) const {
  FollowedPair out;
  if (find(f, out)) return out;
  out = {};
  setDirections(out.at, Vec3::UnitZ(), Vec3::Zero(), Vec3::Zero());
  out.at.g = size_, out.at.P = B_.c, out.presence = -size_;
  return out;
}

bool TwoDiscs::find(int f, FollowedPair& out) const {
  if (f >= kRims) {
    const int rim = (f - kRims) / kOfRims;
    return rims(rim / 2, rim % 2, (f - kRims) % kOfRims, out);
  }
  if (f >= kSides) return sides(f - kSides, out);
  if (f < kOnBody) return RimsOn{A_, B_, flat_, size_}.find(f, out);
  if (!RimsOn{B_, A_, flat_, size_}.find(f - kOnBody, out)) return false;
  turnRound(out.at);
  return true;
}

/// The sides of cones have two normals across each other.
bool TwoDiscs::sides(int normal, FollowedPair& out) const {
  if (A_.half == 0.0 || B_.half == 0.0) return false;
  if (!A_.tip && !B_.tip) {
    const LineSegment a(*A_.frame, A_.c, A_.a, A_.half), b(*B_.frame, B_.c, B_.a, B_.half);
    const SegmentCrossing at(a, b);
    if (normal == 1 || at.square < kParallel) return false;
    out.at = across(a, A_.rho + A_.r, b, B_.rho + B_.r, at);
    out.presence = std::min(beyondEnd(A_.half, at.s), beyondEnd(B_.half, at.t));
    return true;
  }
  const Vec3 towards = (normal == 0 ? 1.0 : -1.0) * A_.a.cross(B_.a);
  double sA = 0.0, sB = 0.0;
  if (!sideOnSide(A_, B_, towards, sA, sB, out.at, kParallel)) return false;
  const double lA = 0.5 * sideLength(A_), lB = 0.5 * sideLength(B_);
  out.presence = std::min(beyondEnd(lA, sA - lA), beyondEnd(lB, sB - lB));
  return true;
}

/// Rims of which at least one has no radius.
bool TwoDiscs::ends(int i, int j, FollowedPair& out) const {
  if (!(A_.r + B_.r > 0.0)) return false;
  const Vec3 a = A_.middle(i), b = B_.middle(j), way = b - a;
  const auto velocity = [](const DiscBody& D, const Vec3& p) {
    return D.frame->velocity(p - D.frame->r_OS_I);
  };
  double outA = 0.0, outB = 0.0;
  const auto onTube = [&](const DiscBody& D, int rim, const DiscBody& of, int end) {
    const Vec3 p = of.middle(end), to = p - D.middle(rim), beside = D.acrossAxis(to);
    if (!(beside.norm() > kLevelRim * D.rho)) return false;
    const BodyCurve at = D.rim(rim, to);
    out.at = pointOnCurve(at, *of.frame, p, of.r, beside.normalized());
    outA = withinRim(D, at, rim, out.at.d[0], kBeyondEnd);
    outB = kBeyondEnd + towardsRim(of, end, -out.at.d[0]);
    return true;
  };
  if (A_.radius(i) > 0.0) {
    if (!onTube(A_, i, B_, j)) return false;
  } else if (B_.radius(j) > 0.0) {
    if (!onTube(B_, j, A_, i)) return false;
    turnRound(out.at);
  } else {
    out.at = fromWay(way, velocity(B_, b) - velocity(A_, a), A_.r, B_.r, a, velocity(A_, a),
                     Vec3::UnitZ(), Vec3::Zero());
    outA = kBeyondEnd + towardsRim(A_, i, out.at.d[0]);
    outB = kBeyondEnd + towardsRim(B_, j, -out.at.d[0]);
  }
  out.presence = size_ * std::min(outA, outB);
  return true;
}

/// The place of A's rim i for number `which`, and how far that number holds.
bool TwoDiscs::choose(int i, int j, int which, BodyCurve& at, double& presence) const {
  const Vec3 middle = A_.middle(i);
  const double sine = A_.a.cross(B_.a).norm(), rho = A_.radius(i);
  const Vec3 aside = A_.a.cross(B_.middle(j) - middle);
  const double length = aside.norm();
  if (which < 2 && !(length > kLevelRim * rho)) return false;
  const RimPlaces places = rimPlaces(A_, i, B_, j);
  const Vec3 Y = A_.a.cross(A_.x);
  const auto holds = [&](const BodyCurve& place) {
    const Vec3 way = place.x - middle;
    if (which < 2) return (which == 0 ? -1.0 : 1.0) * aside.dot(way) / length + kBeyondEnd * size_;
    const double angle = std::atan2(Y.dot(way), A_.x.dot(way)),
                 width = 2.0 * std::numbers::pi / kParts;
    const double off = std::remainder(angle - width * (which - 1.5), 2.0 * std::numbers::pi);
    return rho * (0.5 * width - std::abs(off)) + kBeyondEnd * size_;
  };
  const BodyCurve* best = places.chosen(
      holds, [&](const BodyCurve& place) { return fromRim(B_, j, place.x); }, presence);
  if (best == nullptr) return false;
  at = *best;
  const double plane = kBeyondEnd + (which < 2 ? kOnePlane - sine : sine - kOnePlane);
  presence = std::min(presence, size_ * plane);
  return true;
}

bool TwoDiscs::rims(int i, int j, int which, FollowedPair& out) const {
  if (i >= A_.rims() || j >= B_.rims()) return false;
  const double a = A_.radius(i), b = B_.radius(j);
  if (a == 0.0 || b == 0.0) return which == 0 && ends(i, j, out);
  BodyCurve x;
  double presence = 0.0;
  if (!choose(i, j, which, x, presence)) return false;
  const BodyCurve y = B_.rim(j, x.x - B_.middle(j));
  const double tubes = A_.r + B_.r;
  // Sharp rims along each other have no normal.
  if (tubes == 0.0 && x.t.cross(y.t).norm() < kCross) return false;
  const Vec3 d = y.x - x.x;
  out.at = curveOnCurve(x, y, d.norm() > 0.5 * tubes && tubes > 0.0 ? d : outOfRim(A_, i, x));
  // Rims that lie flat tilt by this much before one point is the lowest.
  const double tilt = kBeyondEnd + flat_ / std::min(a, b);
  const Vec3& n = out.at.d[0];
  out.presence = std::min(
      {presence, size_ * withinRim(A_, x, i, n, tilt), size_ * withinRim(B_, y, j, -n, tilt)});
  return true;
}

void TwoDiscs::near(const Nearness& within, std::vector<int>& out) const {
  // A presence changes with the ways of bodies, and with the turns of normals.
  const double turns = kBeyondNormals + 20.0 * within.turn;
  const double least = -within.reach - turns * size_ - within.turn * std::max(A_.rho, B_.rho);
  for (int f = 0; f < kCount; ++f) {
    if (f >= kRims && (f - kRims) % kOfRims == 0) {
      const int rim = (f - kRims) / kOfRims;
      if (!rimsNear(rim / 2, rim % 2, within.reach)) {
        f += kOfRims - 1;
        continue;
      }
    }
    if (FollowedPair at; find(f, at) && std::abs(at.at.g) <= within.reach && at.presence >= least)
      out.push_back(f);
  }
}

/// Is a place of A's rim i within `reach` of B's rim j?
bool TwoDiscs::rimsNear(int i, int j, double reach) const {
  if (i >= A_.rims() || j >= B_.rims()) return false;
  if (A_.radius(i) == 0.0 || B_.radius(j) == 0.0) return true;
  const RimPlaces places = rimPlaces(A_, i, B_, j);
  for (int k = 0; k < places.count; ++k)
    if (fromRim(B_, j, places.at[k].x) <= A_.r + B_.r + reach) return true;
  return false;
}

}  // namespace dynamy
