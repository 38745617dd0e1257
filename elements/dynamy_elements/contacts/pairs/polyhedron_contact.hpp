/// Contact of two convex polyhedra: the full manifold of two faces, or one pair of edges.
///
/// The method is that of two boxes (box_contact.hpp), with the axes of all faces and of those pairs
/// of edges that can be nearest. For these, the arcs between the normals of their faces cross on
/// the unit sphere [Gregorius 2013, The separating axis test between convex polyhedra]. Then e_A ×
/// e_B is the normal of a face of A − B, and the separation along it costs one product.
#pragma once
#include <dynamy_elements/contacts/pairs/facets.hpp>
#include <dynamy_elements/contacts/shapes/polyhedron.hpp>

namespace dynamy {

/// A polyhedron in the world with the motion of its frame; `c`, `R`: place and axes of the shape.
struct PlacedPolyhedron {
  const Frame* frame = nullptr;
  const Polyhedron* of = nullptr;
  Vec3 c = Vec3::Zero();
  Mat3 R = Mat3::Identity();

  Vec3 vertex(int i) const { return c + R * of->corner(i); }
  PlacedEdge edge(int i) const {
    const Polyhedron::Edge& e = of->edge(i);
    return {c + R * e.middle, R * e.e, e.half};
  }
  /// Plane of face i; `sign` +1: this polyhedron is A.
  PlacedFace face(int i, double sign, bool rates) const;
};
PlacedPolyhedron placedPolyhedron(const Frame& frame, const TouchingShape& shape);

/// The outermost corner along d, in axes of the body; `along`: its coordinate along d [m].
int outermost(const Polyhedron& body, const Vec3& d, double& along);
/// Of the faces around the outermost corner along n, the one whose normal is nearest to n.
int faceAlong(const Polyhedron& body, const Vec3& n);

/// Number of possible contacts, which are numbered: corners of B, corners of A, then edge of A ·
/// edges of B + edge of B.
int polyhedraFeatures(const Polyhedron& A, const Polyhedron& B);
inline constexpr int kMostPolyhedraContacts = 32;
using PolyhedraContacts = std::array<NumberedContact, kMostPolyhedraContacts>;

/// Finds the contacts between A and B, normals from A to B, if their separation is at most `reach`
/// [m]; returns their number. `rates`: ddot and Pdot are filled, too. On faces with more than 12
/// corners every second corner counts, on those with more than 24 every third, …
int betweenPolyhedra(const PlacedPolyhedron& A, const PlacedPolyhedron& B, double reach, bool rates,
                     PolyhedraContacts& out);

/// Moves contacts of a face of A with gaps up to `reach` [m] into one plane (closeTogetherOn).
void closeTogether(const PlacedPolyhedron& A, double reach, bool rates,
                   std::span<NumberedContact> contacts);

/// Largest separation of A and B along the axes of faces and edges [m], negative: depth of their
/// overlap. At most their distance, and zero where they touch.
double separation(const PlacedPolyhedron& A, const PlacedPolyhedron& B);

}  // namespace dynamy
