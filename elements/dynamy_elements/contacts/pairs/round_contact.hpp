/// Contacts of capsules and cylinders: closest points of segments, edges and rims.
///
///   ball, capsule      g = |c − p| − R_A − R_B     p of the axis, nearest to c
///   capsule, capsule   ends of each on the other, and where their axes cross
///   ball, cylinder     g = |c − p| − R             p of the cylinder, nearest to c
///   ball, torus        g = |c − p| − r − R         p of the disc, nearest to c
///   box, capsule       ends on the box; corners and edges of the box on the axis
///
/// Each contact is a pair of features with a number that stays the same. Its gap, normal
/// and rates are its own and exact at any distance. All pairs are reported whose closest
/// points lie on the features and whose normal points out of both bodies, so that a capsule
/// rests on two of them. A search for the one pair of closest points was rejected: it jumps
/// from end to end while a capsule rolls.
#pragma once
#include <dynamy_elements/contacts/pairs/box_contact.hpp>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

/// Contacts of a capsule on a box: ends of the capsule, edges and corners of the box.
inline constexpr int kCapsuleOnBox = 2 + 12 + 8;
inline constexpr int kCapsules = 5;
inline constexpr int kMostRoundContacts = kCapsuleOnBox;
using RoundContacts = std::array<BoxContact, kMostRoundContacts>;

/// Contact of a round feature of B with the capsule A.
ContactPoint ballOnCapsule(const Frame& A, const TouchingShape& capsule, const Frame& B,
                           const RoundFeature& ball, const Vec3& plane);
/// Contact of a round feature of B with the cylinder A, in space; for centres
/// inside, the nearest face counts.
ContactPoint ballOnCylinder(const Frame& A, const TouchingShape& cylinder, const Frame& B,
                            const RoundFeature& ball);

/// Contact of a round feature of B with the torus A, in space, whose hole is closed.
ContactPoint ballOnTorus(const Frame& A, const TouchingShape& torus, const Frame& B,
                         const RoundFeature& ball);

/// Contacts of two capsules, from A to B; returns how many.
int betweenCapsules(const Frame& A, const TouchingShape& a, const Frame& B, const TouchingShape& b,
                    const Vec3& plane, RoundContacts& out);
/// Contacts of the capsule of B on the box of A, in space; returns how many.
int capsuleOnBox(const Frame& A, const TouchingShape& box, const Frame& B,
                 const TouchingShape& capsule, RoundContacts& out);

}  // namespace dynamy
