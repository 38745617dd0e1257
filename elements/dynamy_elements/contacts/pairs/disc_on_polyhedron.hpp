/// Contact of a round body (disc_body.hpp) with a polyhedron or box: a can on a table, a wheel over
/// a kerb.
///
///   f(n) = −h_B(−n) − h_A(n),   |n| = 1
///
/// is the separation. It is largest along the normal of a face of A or of a cap of B, or between an
/// edge or corner of A and a rim or the side of B. Each case is solved on its own: faces and caps
/// are known, on the arc of normals of an edge f'' + f ≤ 0, and a corner has its nearest point. All
/// pairs of features that face along n touch: rims over faces (38.1), four points of a rim that
/// lies flat, corners over caps and the side, edges on rims and on the side. Each pair has a gap
/// and a normal of its own.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>

namespace dynamy {

inline constexpr int kMostDiscContacts = 32;
using DiscContacts = std::array<NumberedContact, kMostDiscContacts>;

/// Number of possible contacts, which are numbered: rim 0, 1 of B, its eight points, corners of A,
/// edges of A on the side, then 4 · edge of A + 2 · rim + which of two crossings.
int discFeatures(const Polyhedron& A);

/// Finds the contacts between A and B, normals from A to B, if their separation is at most `reach`
/// [m]; returns their number. Contacts of a face of A with gaps up to `close` [m] are moved into
/// one plane (closeTogetherOn). `rates`: also the rates of their new directions.
int discOnPolyhedron(const PlacedPolyhedron& A, const DiscBody& B, double reach, double close,
                     bool rates, DiscContacts& out);

/// Largest separation of A and B [m], negative: depth of their overlap.
double separation(const PlacedPolyhedron& A, const DiscBody& B);

}  // namespace dynamy
