/// Contact of two convex polyhedra: the full manifold of two faces, or one pair of edges.
///
/// As of two boxes (box_contact.hpp), with the axes of all faces, and of those edges that can be
/// nearest: the arcs between the normals of their faces cross on the unit sphere
/// [Gregorius 2013, The separating axis test between convex polyhedra]. Then e_A × e_B is a face of
/// A − B, and the separation along it costs one product.
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
  /// Plane of face i; `sign` +1: it is A's.
  PlacedFace face(int i, double sign, bool rates) const;
};
PlacedPolyhedron placedPolyhedron(const Frame& frame, const TouchingShape& shape);

/// The corner outermost along d, and how far out it is, in axes of the body.
int outermost(const Polyhedron& body, const Vec3& d, double& along);
/// The face that looks along n most, of those around the corner that is outermost there.
int faceAlong(const Polyhedron& body, const Vec3& n);

/// Number of a contact: corners of B, corners of A, then edge of A · edges of B + edge of B.
int polyhedraFeatures(const Polyhedron& A, const Polyhedron& B);
inline constexpr int kMostPolyhedraContacts = 32;
using PolyhedraContacts = std::array<NumberedContact, kMostPolyhedraContacts>;

/// Contacts between A and B, normals from A to B, if their separation is at most `reach` [m];
/// returns how many. `rates`: with ddot and Pdot. Of faces with more than 12 corners every second
/// counts, of more than 24 every third, …
int betweenPolyhedra(const PlacedPolyhedron& A, const PlacedPolyhedron& B, double reach, bool rates,
                     PolyhedraContacts& out);

/// Contacts of A's faces as those of one face (closeTogetherOn).
void closeTogether(const PlacedPolyhedron& A, double reach, bool rates,
                   std::span<NumberedContact> contacts);

/// Largest separation of A and B along the axes of faces and edges [m], negative: depth of their
/// overlap. At most their distance, and zero where they touch.
double separation(const PlacedPolyhedron& A, const PlacedPolyhedron& B);

}  // namespace dynamy
