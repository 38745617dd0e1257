/// What the rims of round bodies have in common on flat faces (disc_features.hpp) and on each other
/// (two_discs.hpp): a rim over a plane, its places nearest to another curve, and its normals.
///
/// The square of the distance of a place of the rim from a line, or from a circle, has minima and
/// maxima along the rim: at most two minima are taken. The samples between which they are looked
/// for begin beside the direction around which two places come together where the other curve slides
/// off: a sample there has one of the two on either side.
#pragma once
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/facets.hpp>
#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>

namespace dynamy {

/// Sine of the tilt below which a rim has no lowest point.
inline constexpr double kLevelRim = 1e-12;

struct RimPlaces {
  int count = 0;
  BodyCurve at[2];
  /// The place that a number means: of two for which `holds`(place) is positive the one with the
  /// smaller `distance`(place) [m], else the one for which it is larger. `presence`: its value [m].
  /// Null: there is no place.
  template <class Holds, class Distance>
  const BodyCurve* chosen(const Holds& holds, const Distance& distance, double& presence) const;
};

template <class Holds, class Distance>
const BodyCurve* RimPlaces::chosen(const Holds& holds, const Distance& distance,
                                   double& presence) const {
  const BodyCurve* best = nullptr;
  double least = 0.0;
  for (int k = 0; k < count; ++k) {
    const double here = holds(at[k]), way = distance(at[k]);
    const bool better =
        best == nullptr || (here > 0.0 && presence > 0.0 ? way < least : here > presence);
    if (better) best = &at[k], presence = here, least = way;
  }
  return best;
}

/// Places of a rim of B nearest to the line of e.
RimPlaces rimPlaces(const DiscBody& B, int rim, const PlacedEdge& e);
/// −1 for places of a sharp rim beyond the tip of A, a cone, where the lines of its side go on; else 1:
/// a tube is apart from the axis there. `way`: from the tip.
inline double nappeAt(const DiscBody& A, const DiscBody& B, const Vec3& way) {
  const bool beyond = A.cosine() * way.dot(A.a) > A.sine() * A.acrossAxis(way).norm();
  return beyond && B.r == 0.0 ? -1.0 : 1.0;
}

/// Places of a rim of B that are lowest over the side of A, a cone, and over its continuation beyond
/// the tip, whose lines go on there.
RimPlaces rimPlacesOverCone(const DiscBody& B, int rim, const DiscBody& A);
/// Places of a rim of B nearest to a rim of A.
RimPlaces rimPlaces(const DiscBody& B, int rim, const DiscBody& A, int other);

/// By how much the lowest point of a rim over a plane with the normal n is below its middle [m].
inline double liftOf(const DiscBody& B, int rim, const Vec3& n) {
  return B.radius(rim) * B.acrossAxis(n).norm();
}

/// The lowest point of a rim of B over a plane with the normal n; `inside`(contact): its presence
/// within the border of the plane [m]. `flat`: a rim whose lowest point is less below its middle
/// lies flat [m], and has no lowest point then.
template <class Inside>
FollowedPair rimOverPlane(const PlacedFace& on, const Vec3& n, const DiscBody& B, int rim,
                          double flat, const Inside& inside);
/// Point k of a rim of B, fixed in it, over the same plane; its presence is that of a rim that lies
/// flat, without regard to a border.
FollowedPair pointOverPlane(const PlacedFace& on, const Vec3& n, const DiscBody& B, int rim, int k,
                            double flat);

template <class Inside>
FollowedPair rimOverPlane(const PlacedFace& on, const Vec3& n, const DiscBody& B, int rim,
                          double flat, const Inside& inside) {
  const double rho = B.radius(rim), lifted = liftOf(B, rim, n),
               raised = lifted - ContactSink::kLowest * flat;
  FollowedPair out;
  if (rho > 0.0 && lifted <= kLevelRim * rho) {
    out = pointOverPlane(on, n, B, rim, 0, flat);
    out.presence = raised;
    return out;
  }
  on.contact(*B.frame, B.c, out.at);
  wander(B, rim, out.at);
  ContactPoint there;
  on.contact(*B.frame, out.at.P, there);
  out.at.g = there.g;
  out.presence = inside(out.at);
  if (rho > 0.0 && raised < out.presence) {
    out.presence = raised;
    if (lifted < DiscBody::kFlat * rho) out.circle = lifted;
  }
  return out;
}

/// Presence of a place s on a line of the half length `half`, up to kBeyondEnd beyond its ends [m].
inline double beyondEnd(double half, double s) { return (1.0 + kBeyondEnd) * half - std::abs(s); }

/// Sine of the angle by which m, a direction out of B, lies within the normals of a rim at `at`,
/// with the margin `cap` towards the cap, and kBeyondEnd towards the side.
double withinRim(const DiscBody& B, const BodyCurve& at, int rim, const Vec3& m, double cap);

}  // namespace dynamy
