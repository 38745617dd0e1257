/// Contacts whose laws have rows beyond normal, tangents and spin.
#pragma once
#include <dynamy/contact/contact_sink.hpp>

namespace dynamy {

/// Like pointContact, for any number of rows that a law in space may have. The number of rows
/// determines their meaning:
///
///   up to 3   n, t1, t2       the velocity of B's point relative to A's along them
///   4         … spin          the angular velocity of B relative to A about n
///   5         … M1, M2        the same about t1, t2
///   6         … spin, M1, M2
///   8         … C1, C2        the same along c1, c2, which have the unit of a length: the velocity
///                             of the point of contact over a body
///
/// `c`: the two directions c1 and c2, or null if there are fewer than 8 rows.
void rollingContact(ContactRows& rows, const Frame& A, const Vec3& rhoA_I, const Frame& B,
                    const Vec3& rhoB_I, const Vec3& n, const Vec3& t1, const Vec3& t2,
                    const Vec3* c);

}  // namespace dynamy
