/// Contact of two round bodies (disc_body.hpp): coins on each other, crossed and parallel
/// cylinders, tyres, a capsule on a cylinder.
///
/// Along the direction of largest separation (disc_separation.hpp) all features that face each other
/// touch: rims and four points of them over caps, crossings of rims, rims on sides, sides on sides.
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
