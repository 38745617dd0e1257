/// Pairs of features of two convex bodies one by one, so that each gap can be followed for itself.
///
///   vertex of B over a face of A    g = n_A·(p_B − f_A)            and the other way round
///   edge of A, edge of B            g = n·(p_B − p_A),   n = ± e_A × e_B/|…|, out of A
///   corner, edge of polygons        as vertex and face, in a plane
///
/// g is that of a plane or of two lines and goes on smoothly where the features do not lie over one
/// another. Where they do is told by the presence, the least way to where they cease to [m]:
///
///   vertex        to the borders of the face, kSameFeature of the body beyond them
///   edges         of the crossing to their ends, as far beyond; and n within the normals of the
///                 faces that meet there, on both bodies
///
/// The contacts of facets.hpp, of which each corner has one whatever face it is over, were
/// rejected: their gaps jump where the face changes.
#pragma once
#include <dynamy_elements/contacts/pairs/polygon_contact.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>

namespace dynamy {

/// How far apart, and by which angle, two bodies may move against each other before they are looked
/// at again.
struct Nearness {
  double reach = 0.0;  ///< [m]
  double turn = 0.0;   ///< [rad]
};

/// Numbers: vertex of B · faces of A + face, then vertex of A · faces of B + face, then edge of A ·
/// edges of B + edge.
int featurePairs(const Polyhedron& A, const Polyhedron& B);
/// Corner of B · edges of A + edge, then corner of A · edges of B + edge.
int featurePairs(const std::vector<Vec3>& A, const std::vector<Vec3>& B);

/// Pair f of features. `rates`: with ddot and Pdot.
ContactPoint featurePair(const PlacedPolyhedron& A, const PlacedPolyhedron& B, int f, bool rates,
                         double& presence);
ContactPoint featurePair(const PlacedPolygon& A, const PlacedPolygon& B, int f, bool rates,
                         double& presence);

/// Appends the pairs that may touch while A and B move by no more than `within`, ascending.
void nearFeatures(const PlacedPolyhedron& A, const PlacedPolyhedron& B, const Nearness& within,
                  std::vector<int>& out);
void nearFeatures(const PlacedPolygon& A, const PlacedPolygon& B, const Nearness& within,
                  std::vector<int>& out);

}  // namespace dynamy
