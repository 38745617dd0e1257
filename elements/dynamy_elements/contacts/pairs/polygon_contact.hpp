/// Contact of convex polygons in their plane of motion: with each other and with circles.
///
///   corner of B over an edge of A   g = n_A·(p_B − f_A)    n_A fixed in A, and the other way round
///   circle over an edge             g = n·(c − f) − R
///   circle beside a corner          g = |c − p| − R
///   corner beside a capsule         g = n·(s − p) − R      s the point of the axis nearest to p,
///                                                          n ⟂ axis, from the polygon to it
///
/// For two polygons, the edge of either that separates them most is compared with the edge of the
/// other that faces it. The ends of what the two edges share are the two contacts.
#pragma once
#include <dynamy_elements/contacts/pairs/facets.hpp>

namespace dynamy {

/// A polygon in the world, corners counterclockwise about `plane`.
struct PlacedPolygon {
  const Frame* frame = nullptr;
  const std::vector<Vec3>* corners_K = nullptr;
  Vec3 plane = Vec3::Zero();

  int size() const { return static_cast<int>(corners_K->size()); }
  Vec3 corner(int i) const {
    return frame->r_OS_I + frame->A_IK * (*corners_K)[static_cast<std::size_t>(i % size())];
  }
  /// Outward normal of the edge from corner i to the next.
  Vec3 normal(int i) const { return (corner(i + 1) - corner(i)).cross(plane).normalized(); }
};

inline constexpr int kMostPolygonContacts = 4;
using PolygonContacts = std::array<NumberedContact, kMostPolygonContacts>;

/// Finds the contacts of A and B, normals from A to B, if their separation is at most `reach` [m];
/// returns their number. Contacts are numbered: corners of B, corners of A.
int betweenPolygons(const PlacedPolygon& A, const PlacedPolygon& B, double reach, bool rates,
                    PolygonContacts& out);
void closeTogether(const PlacedPolygon& A, double reach, bool rates,
                   std::span<NumberedContact> contacts);
/// Largest separation along the normals of the edges [m].
double separation(const PlacedPolygon& A, const PlacedPolygon& B);

/// Contact of a round feature of B with the polygon A; for centres inside, the nearest edge counts.
ContactPoint ballOnPolygon(const PlacedPolygon& A, const Frame& B, const RoundFeature& ball);

/// Finds the contacts of the capsule of B on the polygon A: the capsule's ends as circles, and
/// corners of A beside it, seen from the side of its axis that separates the two most. Returns
/// their number. The gap of a corner has a sign, so that a capsule without a radius does not lose
/// it. To choose corners by whether the normal points out of the polygon was rejected: for an edge
/// parallel to the axis rounding would decide. Contacts are numbered: ends, corners of A.
inline constexpr int kMostCapsuleOnPolygon = 34;
using CapsuleOnPolygon = std::array<NumberedContact, kMostCapsuleOnPolygon>;
int capsuleOnPolygon(const PlacedPolygon& A, const Frame& B, const TouchingShape& capsule,
                     CapsuleOnPolygon& out);

}  // namespace dynamy
