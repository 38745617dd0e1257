/// Places of a rim that are nearest to another curve, and which normals a rim has.
///
/// The square of the distance of a place of the rim from a line, or from a circle, has minima and
/// maxima along the rim: at most two minima are taken. The samples between which they are looked
/// for begin beside the direction around which two places come together where the other curve slides
/// off: a sample there has one of the two on either side.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/facets.hpp>
#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>

namespace dynamy {

struct RimPlaces {
  int count = 0;
  BodyCurve at[2];
};

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

/// Presence of a place s on a line of the half length `half`, up to kBeyondEnd beyond its ends [m].
inline double beyondEnd(double half, double s) { return (1.0 + kBeyondEnd) * half - std::abs(s); }

/// Sine of the angle by which m, a direction out of B, lies within the normals of a rim at `at`,
/// with the margin `cap` towards the cap, and kBeyondEnd towards the side.
double withinRim(const DiscBody& B, const BodyCurve& at, int rim, const Vec3& m, double cap);

}  // namespace dynamy
