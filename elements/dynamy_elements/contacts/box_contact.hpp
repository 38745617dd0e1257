/// Contact of two boxes: the full manifold of two faces, or one pair of edges.
///
///   vertex of B over a face of A   g = n_A·(p_B − f_A)        n_A fixed in A
///   vertex of A over a face of B   g = n_B·(p_A − f_B)        n_B fixed in B
///   edge of A, edge of B           g = n·(p_B − p_A)          n = ±e_A × e_B/|e_A × e_B|
///
/// p_A, p_B on edges are the closest points of the two lines. Gap, normal and γ_N = ġ are exact
/// before and after touching. The axis of largest separation (15 axes) tells the faces or edges;
/// the corners of the intersection of two faces, seen along the normal, are such pairs of features,
/// each with a number that stays. Clipping one face against the sides of the other was rejected: a
/// clipped point belongs to no feature, so that its gap is not what its velocity integrates.
#pragma once
#include <array>
#include <dynamy_elements/contacts/contact_geometry.hpp>
#include <span>

namespace dynamy {

/// A box in the world with the motion of its frame.
struct PlacedBox {
  const Frame* frame = nullptr;
  Vec3 c = Vec3::Zero();      ///< centre [m]
  Mat3 R = Mat3::Identity();  ///< its axes in the world
  Vec3 half = Vec3::Zero();   ///< half edge lengths [m]
  /// Vertex i from the centre, in the box's axes; bit k set: on the positive side of axis k.
  Vec3 corner(int i) const {
    return {i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
            i & 4 ? half.z() : -half.z()};
  }
  Vec3 vertex(int i) const { return c + R * corner(i); }
};
PlacedBox placedBox(const Frame& frame, const TouchingShape& box);

/// Contact number `id` < kBoxFeatures of a pair of boxes: 0–7 vertex of B, 8–15 vertex of A, from
/// 16 on 12 · edge of A + edge of B.
struct BoxContact {
  int id = 0;
  ContactPoint at;
};
inline constexpr int kBoxFeatures = 16 + 144;
inline constexpr int kMostBoxContacts = 16;

/// Contacts between A and B, normals from A to B, at any distance; returns how many. `rates`: with
/// ddot and Pdot.
int betweenBoxes(const PlacedBox& A, const PlacedBox& B, bool rates,
                 std::array<BoxContact, kMostBoxContacts>& out);

/// Contacts of a face of A whose gaps are at most `reach` [m], and thus close together, are moved
/// into one plane along that face; where there are three and more, so that their gaps tell how far
/// the two faces can be tilted, all slide along it. Normals, gaps and γ_N stay. Otherwise sticking
/// contacts contradict each other by the tilt, and every contact has to slide by almost nothing.
void closeTogether(const PlacedBox& A, double reach, bool rates, std::span<BoxContact> contacts);

/// Largest separation of A and B along the 15 axes [m], negative: depth of their overlap. At most
/// their distance, and zero where they touch.
double separation(const PlacedBox& A, const PlacedBox& B);

}  // namespace dynamy
