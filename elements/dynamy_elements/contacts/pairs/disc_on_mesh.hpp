/// Contact of a round body (disc_body.hpp) with a mesh or height field: a wheel on a terrain.
///
/// The pairs of features are: rims over faces, and four points of a rim that lies flat; edges that
/// stand out, on rims and on the side; corners that stand out, on rims, side and caps. A pair
/// counts if its closest points lie on both features and its normal points out of both.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/surface_contact.hpp>

namespace dynamy {

/// Number of possible contacts, which are numbered: (rim, or 2 + point) · faces + face, then
/// corners, edges on the side, then 4 · edge + 2 · rim + which of two crossings.
std::uint64_t discOnMeshFeatures(const Surface& mesh);

/// Finds the contacts of B on the mesh of A with gaps between −reach and
/// `reach` [m]; returns their number.
int discOnMesh(const Frame& A, const Surface& mesh, const DiscBody& B, double reach,
               OnSurfaceContacts& out);

}  // namespace dynamy
