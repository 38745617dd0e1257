/// Direction of largest separation of two round bodies (disc_body.hpp).
///
///   f(n) = −h_B(−n) − h_A(n) ≤ |x_B − x_A|   for all points x_A of A, x_B of B
///
/// is largest along the normal of a cap, across the axis of A or B, or between two rims. The first
/// two cases are solved as on polyhedra (disc_arc.hpp). Between the rims i, j Newton's method finds
/// the largest of f_ij, the separation of two discs,
///
///   ∇f_ij = y,   ∇²f_ij = −(H_A + H_B) − f_ij I on the plane across n                (theory 38.2)
///
/// beginning with the way between two near points. Where two points are no further apart than f(n),
/// no direction separates more, and the search ends: so bodies on each other and apart take a few
/// looks. Bodies that overlap take all candidates, and rims the best of a grid of directions.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <limits>

namespace dynamy {

struct DiscsApart {
  double f = -std::numeric_limits<double>::infinity();
  Vec3 n = Vec3::UnitZ();
};

/// Caps are preferred: another direction has to separate by more than `more` [m]; with it others may
/// separate by 1e-11 of the bodies' size more. A separation above `enough` [m] need not be the largest.
DiscsApart furthestApart(const DiscBody& A, const DiscBody& B, double more, double enough);

}  // namespace dynamy
