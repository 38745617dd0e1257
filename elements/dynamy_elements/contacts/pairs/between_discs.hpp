/// Contact of two round bodies (disc_body.hpp): coins on each other, crossed and parallel
/// cylinders, tyres, a capsule on a cylinder.
///
/// The separation f(n) = −h_B(−n) − h_A(n) is largest along the normal of a cap, across the axis of
/// A or B, or between two rims. The first two cases are solved as on polyhedra (disc_arc.hpp).
/// Between the rims i, j Newton's method finds the largest of f_ij, the separation of two discs,
///
///   ∇f_ij = y,   ∇²f_ij = −(H_A + H_B) − f_ij I on the plane across n                (theory 38.2)
///
/// beginning with the best of a grid of directions. All features that face along n touch: rims and
/// four points of them over caps, crossings of rims, rims on sides, sides on sides.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_on_polyhedron.hpp>

namespace dynamy {

/// Numbers of contacts: rims of B over A's cap, eight points of them; the same of A over B's cap;
/// sides; rims of A on B's side, then of B on A's side, two crossings each; for the rims i of A and
/// j of B 4 i + 2 j + which of two crossings.
inline constexpr int kSides = 20, kAOnSide = 21, kBOnSide = 25, kRimPairs = 29, kDiscPair = 37;

/// Finds the contacts between A and B, normals from A to B, if their separation is at most `reach`
/// [m]; returns their number. Contacts on a cap with gaps up to `close` [m] are moved into one
/// plane (closeTogetherOn). `rates`: also the rates of their new directions.
int betweenDiscs(const DiscBody& A, const DiscBody& B, double reach, double close, bool rates,
                 DiscContacts& out);

/// Largest separation of A and B [m], negative: depth of their overlap.
double separation(const DiscBody& A, const DiscBody& B);

}  // namespace dynamy
