/// Contacts of capsules with polyhedra and meshes, and of polyhedra with meshes.
///
///   capsule      its ends as balls; edges and corners that stand out on its axis
///   polyhedron   its corners over faces, corners that stand out over its faces, edges on edges
///
/// A pair of features counts if its closest points lie on both and its normal points
/// out of both: the normal is in the wedge or cone of normals of the one feature,
/// and its opposite in that of the other.
#pragma once
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>
#include <dynamy_elements/contacts/shapes/surface.hpp>
#include <span>

namespace dynamy {

inline constexpr int kMostOnSurface = 48;
using OnSurfaceContacts = std::array<NumberedContact, kMostOnSurface>;

/// Finds the contacts of the capsule of B on the surface of A with gaps up to `reach` [m], in
/// space; returns their number. They are numbered: end · features of the surface + feature, then
/// edges, then corners.
int capsuleOnSurface(const Frame& A, const Surface& surface, const Frame& B,
                     const TouchingShape& capsule, double reach, OnSurfaceContacts& out);
int capsuleFeatures(const Surface& surface);

/// Finds the contacts of B on the mesh of A with gaps between −reach and `reach` [m]; returns their
/// number. They are numbered: corner of B · faces + face, then corners of the mesh, then edge ·
/// edges of B + edge.
int polyhedronOnMesh(const Frame& A, const Surface& mesh, const PlacedPolyhedron& B, double reach,
                     bool rates, OnSurfaceContacts& out);
std::uint64_t meshFeatures(const Surface& mesh, const Polyhedron& B);

/// Moves the points of contacts that have the normal of the lowest one into one plane.
void levelled(const Frame& A, std::span<NumberedContact> contacts);

}  // namespace dynamy
