/// Contact of two boxes: the full manifold of two faces, or one pair of edges.
///
/// The axis of largest separation, one of 15, selects the faces or edges that touch. The corners of
/// the intersection of two faces, seen along the normal, are pairs of features (facets.hpp), each
/// with a number that stays the same. Boxes as polyhedra (polyhedron_contact.hpp) were rejected:
/// six axes, eight corners and products of half lengths make boxes several times faster.
#pragma once
#include <array>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/pairs/facets.hpp>

namespace dynamy {

/// A box in the world with the motion of its frame.
struct PlacedBox {
  const Frame* frame = nullptr;
  Vec3 c = Vec3::Zero();      ///< centre [m]
  Mat3 R = Mat3::Identity();  ///< its axes in the world
  Vec3 half = Vec3::Zero();   ///< half edge lengths [m]
  /// Vertex i from the centre, in the box's axes; if bit k of i is set, on
  /// the positive side of axis k.
  Vec3 corner(int i) const {
    return {i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
            i & 4 ? half.z() : -half.z()};
  }
  Vec3 vertex(int i) const { return c + R * corner(i); }
};
PlacedBox placedBox(const Frame& frame, const TouchingShape& box);

/// Contact number `id` < kBoxFeatures of a pair of boxes: 0–7 vertex of B, 8–15 vertex of A, from
/// 16 on 12 · edge of A + edge of B.
using BoxContact = NumberedContact;
inline constexpr int kBoxFeatures = 16 + 144;
inline constexpr int kMostBoxContacts = 16;

/// Finds the contacts between A and B, normals from A to B; returns their number: 0 if an axis
/// separates them by more than `reach` [m]. `rates`: ddot and Pdot are filled, too.
int betweenBoxes(const PlacedBox& A, const PlacedBox& B, bool rates,
                 std::array<BoxContact, kMostBoxContacts>& out, double reach = kInfinity);

/// Moves contacts of a face of A with gaps up to `reach` [m] into one plane (closeTogetherOn).
void closeTogether(const PlacedBox& A, double reach, bool rates, std::span<BoxContact> contacts);

/// Largest separation of A and B along the 15 axes [m], negative: depth of their overlap. At most
/// their distance, and zero where they touch.
double separation(const PlacedBox& A, const PlacedBox& B);

}  // namespace dynamy
