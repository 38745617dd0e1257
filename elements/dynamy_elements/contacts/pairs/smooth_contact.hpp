/// Contact of smooth convex bodies, known by their support functions, with each other and with
/// polyhedra.
///
///   g = max over |n| = 1 of f(n),   f = n·y,   y = x_B(−n) − x_A(n)
///
/// x_A and x_B are the support points. If the bodies are apart, g is the distance and y = g n; if
/// they overlap, −g is the depth. The gradient of f is y, and its second derivative is
/// −(H_A + H_B) − f I. With this matrix Newton's method finds n, and it also gives the rate of n
/// while the bodies move. On an edge e of a polyhedron n is sought among the directions orthogonal
/// to e, on a face it is known. Distances of sampled surfaces were rejected: their normals jump.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/polygon_contact.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>
#include <dynamy_elements/contacts/pairs/surface_contact.hpp>

namespace dynamy {

/// Contact of two features with smooth support functions, in space.
ContactPoint betweenSmooth(const Frame& A, const SupportFeature& a, const Frame& B,
                           const SupportFeature& b);
/// Contact of a feature of B with the polyhedron A; for features inside, the nearest face counts.
ContactPoint smoothOnPolyhedron(const PlacedPolyhedron& A, const Frame& B,
                                const SupportFeature& feature);
/// Contact of a feature of B with the cylinder, cone, torus or capsule A: the largest of the
/// separations along its caps, across its side and from its rims and tip.
ContactPoint smoothOnDisc(const DiscBody& A, const Frame& B, const SupportFeature& feature);
/// The contact of smoothOnDisc with the roles exchanged: the feature belongs to A.
ContactPoint discOnSmooth(const Frame& A, const SupportFeature& feature, const DiscBody& B);

/// Finds the contacts of a feature of B on the mesh of A with gaps between −reach and `reach` [m];
/// returns their number. The lowest point of the feature touches faces, edges that stand out and
/// corners. Contacts have the numbers of those of a ball (surface.hpp).
int smoothOnMesh(const Frame& A, const Surface& mesh, const Frame& B, const SupportFeature& feature,
                 double reach, OnSurfaceContacts& out);

/// Contacts in the plane of motion with the normal `plane`: of two features, of a feature with a
/// polygon, inside of which the nearest edge counts, and of a capsule with a feature.
ContactPoint smoothInPlane(const Frame& A, const SupportFeature& a, const Frame& B,
                           const SupportFeature& b, const Vec3& plane);
ContactPoint smoothOnPolygon(const PlacedPolygon& A, const Frame& B, const SupportFeature& feature);
ContactPoint capsuleOnSmooth(const Frame& A, const SupportFeature& feature, const Frame& B,
                             const TouchingShape& capsule, const Vec3& plane);

}  // namespace dynamy
