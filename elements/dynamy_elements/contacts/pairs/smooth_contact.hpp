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
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/polygon_contact.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>
#include <dynamy_elements/contacts/pairs/surface_contact.hpp>

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

/// Contacts of a feature of B on the mesh of A with gaps between −reach and `reach` [m]; returns
/// how many: its lowest point over faces, edges that stand out and corners. Numbers as those of a
/// ball (surface.hpp).
int smoothOnMesh(const Frame& A, const Surface& mesh, const Frame& B, const SupportFeature& feature,
                 double reach, OnSurfaceContacts& out);

/// In the plane of motion with the normal `plane`: two features, one on a polygon, inside of which
/// the nearest edge counts, and a capsule on one.
ContactPoint smoothInPlane(const Frame& A, const SupportFeature& a, const Frame& B,
                           const SupportFeature& b, const Vec3& plane);
ContactPoint smoothOnPolygon(const PlacedPolygon& A, const Frame& B, const SupportFeature& feature);
ContactPoint capsuleOnSmooth(const Frame& A, const SupportFeature& feature, const Frame& B,
                             const TouchingShape& capsule, const Vec3& plane);

}  // namespace dynamy
