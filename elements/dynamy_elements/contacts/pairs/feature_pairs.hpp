/// Pairs of features of two convex bodies, one by one, so that each gap can be followed on its own.
///
///   vertex of B over a face of A    g = n_A·(p_B − f_A)            and the other way round
///   edge of A, edge of B            g = n·(p_B − p_A),   n = ± e_A × e_B/|…|, out of A
///   corner, edge of polygons        as vertex and face, in a plane
///
/// The gap g is that of a point over a plane or of two lines, and it continues smoothly where the
/// features do not lie over one another. The presence [m] is positive where they do; it is the
/// least distance to where they cease to:
///
///   vertex        its distance from the borders of the face, plus kSameFeature of the body
///   edges         distance of the crossing from the ends of both edges, plus the same; at most the
///                 margin of n within the normals of the faces that meet there, on both bodies
///
/// The contacts of facets.hpp were rejected: there each corner has one contact, whatever face it is
/// over, and its gap jumps where that face changes.
#pragma once
#include <dynamy_elements/contacts/pairs/polygon_contact.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>

namespace dynamy {

/// Sine of the angle by which a normal may lie beyond those of the faces that meet in a feature:
/// more than rounding and drift turn faces that lie on each other.
inline constexpr double kBeyondNormals = 0.05;

/// Part of a half length or radius up to which features of round bodies count beyond where another
/// pair takes over, whose gap there differs by half of the square of this.
inline constexpr double kBeyondEnd = 1e-7;

/// A pair of features at its place.
struct FollowedPair {
  ContactPoint at;
  double presence = 0.0;  ///< [m]
  /// Of the lowest point of a rim that lies nearly flat: by how much it is below its middle [m]; −1:
  /// it is none.
  double circle = -1.0;
};

/// How far and by which angle two bodies may move relative to each other before
/// their features are searched again.
struct Nearness {
  double reach = 0.0;  ///< [m]
  double turn = 0.0;   ///< [rad]
};

/// Number of pairs of features of two polyhedra, which are numbered: vertex of B · faces of A +
/// face, then vertex of A · faces of B + face, then edge of A · edges of B + edge.
int featurePairs(const Polyhedron& A, const Polyhedron& B);
/// Number of pairs of features of two polygons, which are numbered: corner of B · edges of A +
/// edge, then corner of A · edges of B + edge.
int featurePairs(const std::vector<Vec3>& A, const std::vector<Vec3>& B);

/// Contact of the pair f of features and its presence [m]. `rates`: ddot and Pdot are filled, too.
ContactPoint featurePair(const PlacedPolyhedron& A, const PlacedPolyhedron& B, int f, bool rates,
                         double& presence);
ContactPoint featurePair(const PlacedPolygon& A, const PlacedPolygon& B, int f, bool rates,
                         double& presence);

/// Least distance of p, in axes of the body, from the borders of the face; positive inside [m].
double inside(const Polyhedron& body, const Polyhedron::Face& f, const Vec3& p);
/// Sine of the angle by which n lies within the normals of the two faces at edge e, n ⟂ e; in axes
/// of the body.
double withinNormals(const Polyhedron& body, const Polyhedron::Edge& e, const Vec3& n);
/// A direction out of the body at edge e, in its axes.
Vec3 outOf(const Polyhedron& body, const Polyhedron::Edge& e);
/// Distance of two edges [m].
double distance(const PlacedEdge& a, const PlacedEdge& b);

/// Appends, in ascending order, the pairs that may touch while A and B move by at most `within`.
void nearFeatures(const PlacedPolyhedron& A, const PlacedPolyhedron& B, const Nearness& within,
                  std::vector<int>& out);
void nearFeatures(const PlacedPolygon& A, const PlacedPolygon& B, const Nearness& within,
                  std::vector<int>& out);

}  // namespace dynamy
