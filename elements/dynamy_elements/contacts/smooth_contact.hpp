/// Contact of smooth convex bodies, known by their support functions, with each other and with
/// polyhedra.
///
///   g = max over |n| = 1 of f(n),   f = n·y,   y = x_B(−n) − x_A(n)
///
/// x are the support points: apart, g is the distance and y = g n; overlapping, −g is the depth.
/// The gradient of f is y and its second derivative −(H_A + H_B) − f I, so that Newton's method
/// finds n, and the same matrix tells how n turns while the bodies move. On an edge e of a
/// polyhedron n is sought across e, on a face it is known. Distances of sampled surfaces were
/// rejected: their normals jump.
#pragma once
#include <dynamy_elements/contacts/disc_body.hpp>
#include <dynamy_elements/contacts/polyhedron_contact.hpp>

namespace dynamy {

/// Two features with smooth support functions, in space.
ContactPoint betweenSmooth(const Frame& A, const SupportFeature& a, const Frame& B,
                           const SupportFeature& b);
/// Feature of B on the polyhedron A; inside the nearest face counts.
ContactPoint smoothOnPolyhedron(const PlacedPolyhedron& A, const Frame& B,
                                const SupportFeature& feature);
/// Feature of B on the cylinder, cone, torus or capsule A: the largest of the separations along its
/// caps, across its side and from its rims and tip.
ContactPoint smoothOnDisc(const DiscBody& A, const Frame& B, const SupportFeature& feature);
/// The same seen from the feature, which is A's.
ContactPoint discOnSmooth(const Frame& A, const SupportFeature& feature, const DiscBody& B);

}  // namespace dynamy
