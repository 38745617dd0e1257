/// Contacts of capsules and cylinders: closest points of segments, edges and rims.
///
///   ball, capsule      g = |c − p| − R_A − R_B     p of the axis, nearest to c
///   capsule, capsule   ends of each on the other, and where their axes cross
///   ball, cylinder     g = |c − p| − R             p of the cylinder, nearest to c
///   box, capsule       ends on the box; corners and edges of the box on the axis
///
/// Each is a pair of features with a gap, normal and rates of its own that are exact at any
/// distance, and a number that stays. All whose closest points lie on the features and whose normal
/// points out of both bodies are given, so that a capsule rests on two of them. A search for the
/// one pair of closest points was rejected: it jumps from end to end while a capsule rolls.
#pragma once
#include <dynamy_elements/contacts/pairs/box_contact.hpp>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

/// Ends, edges and corners of a capsule on a box.
inline constexpr int kCapsuleOnBox = 2 + 12 + 8;
inline constexpr int kCapsules = 5;
inline constexpr int kMostRoundContacts = kCapsuleOnBox;
using RoundContacts = std::array<BoxContact, kMostRoundContacts>;

/// Feature of B on the capsule of A.
ContactPoint ballOnCapsule(const Frame& A, const TouchingShape& capsule, const Frame& B,
                           const RoundFeature& ball, const Vec3& plane);
/// Feature of B on the cylinder of A, in space; inside the nearest face counts.
ContactPoint ballOnCylinder(const Frame& A, const TouchingShape& cylinder, const Frame& B,
                            const RoundFeature& ball);

/// Contacts of two capsules, from A to B; returns how many.
int betweenCapsules(const Frame& A, const TouchingShape& a, const Frame& B, const TouchingShape& b,
                    const Vec3& plane, RoundContacts& out);
/// Contacts of the capsule of B on the box of A, in space; returns how many.
int capsuleOnBox(const Frame& A, const TouchingShape& box, const Frame& B,
                 const TouchingShape& capsule, RoundContacts& out);

}  // namespace dynamy
