/// Pairs of features of a round body (disc_body.hpp) and a box or polyhedron, one by one, so that
/// each gap can be followed on its own (feature_pairs.hpp does so for flat faces).
///
///   rim over a face             its lowest point                 g = n·(P − f)
///   point of a rim              one of four, while it lies flat  the same
///   corner over a cap           g = n·(v − c) − ℓ − r
///   corner or edge on the side  as of a line with a tube, or of the side of a cone
///   edge on a rim               g between the closest points of line and circle
///   corner on the tube of a torus                                g = |v − x| − r
///
/// The gap continues where the features do not lie over one another, and the presence [m] is
/// positive where they do. Where another pair takes over with the same first derivative of the gap
/// (from a rim to the border of a face, from an edge to its corner, from a side to its rim) both end
/// at the same place, as on capsules (capsule_features.hpp); else there is a margin, as between
/// flat faces.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_on_polyhedron.hpp>
#include <dynamy_elements/contacts/pairs/feature_pairs.hpp>
#include <string>

namespace dynamy {

class DiscFeatures {
 public:
  /// `flat`: a rim whose lowest point is less below its middle lies flat [m].
  DiscFeatures(const PlacedPolyhedron& A, const DiscBody& B, double flat);
  /// Number of pairs. They are numbered: rim · faces + face, then the same of eight points of
  /// rims; for each corner: two caps, the side, two tubes; for each edge: the side, with one of two
  /// normals, then 2 · rim + the negative or positive half of it along the edge.
  static int count(const Polyhedron& A);
  static std::string name(const Polyhedron& A, int f);
  FollowedPair pair(int f) const;
  /// Appends, in ascending order, the pairs that may touch while A and B move by at most `within`.
  void near(const Nearness& within, std::vector<int>& out) const;

 private:
  double inside(int face, const Vec3& p) const;  ///< of a face, p in the world
  double withinCone(int corner, const Vec3& n) const;
  double withinEdge(int edge, const Vec3& n) const;
  ContactPoint onRim(const PlacedEdge& e, int edge, const BodyCurve& rim) const;

  FollowedPair rimOverFace(int rim, int face) const;
  FollowedPair pointOverFace(int rim, int k, int face) const;
  FollowedPair cornerOnCap(int cap, int corner) const;
  FollowedPair cornerOnSide(int corner) const;
  FollowedPair cornerOnTube(int rim, int corner) const;
  FollowedPair edgeOnSide(int edge, int normal) const;
  FollowedPair edgeOnRim(int edge, int rim, int which) const;
  FollowedPair absent(const Vec3& at) const;

  const PlacedPolyhedron& A_;
  const DiscBody& B_;
  const Polyhedron& body_;
  double flat_, same_, size_;
};

}  // namespace dynamy
