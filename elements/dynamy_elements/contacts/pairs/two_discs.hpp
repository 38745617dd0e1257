/// Pairs of features of two round bodies (disc_body.hpp), one by one, so that each gap can be
/// followed on its own: cylinders, cones and tori with each other and with capsules. (disc_features.hpp
/// does so for a round body and flat faces.)
///
///   rim over a cap      its lowest point; one of four points while it lies flat
///   rim on a side       its place nearest to the axis, or lowest over the side of a cone
///   side on side        between the closest points of two lines
///   rim on rim          g between the closest places of two circles
///
/// A rim of radius 0 is a tip, or the end of a capsule: over a cap, on a side, on a tube. Presences
/// [m] as in disc_features.hpp: where another pair takes over with the same first derivative of the
/// gap both end at the same place, else there is a margin.
///
/// Two rims have two places where they cross, which come together where one slides off the other.
/// Rims in nearly the same plane have one on each side of the line between their middles; others one
/// in each of eight parts of A's rim, since a coin that stands on a rim has its only place on that
/// line.
#pragma once
#include <dynamy_elements/contacts/pairs/rim_places.hpp>
#include <string>

namespace dynamy {

class TwoDiscs {
 public:
  /// `flat`: a rim whose lowest point is less below its middle lies flat [m].
  TwoDiscs(const DiscBody& A, const DiscBody& B, double flat);
  /// Pairs are numbered: of the rims of B on A 2 rim + cap, then 2 (4 rim + point) + cap, then
  /// 2 rim + which of two places on the side; the same of the rims of A on B; two normals of the
  /// sides; for the rims i of A and j of B 10 (2 i + j) + which of two places and of eight parts.
  static constexpr int kOnBody = 24, kSides = 48, kRims = 50, kOfRims = 10, kCount = 90;
  static std::string name(int f);
  FollowedPair pair(int f) const;
  /// Appends, in ascending order, the pairs that may touch while A and B move by at most `within`.
  void near(const Nearness& within, std::vector<int>& out) const;

 private:
  /// False: there is no such pair.
  bool find(int f, FollowedPair& out) const;
  bool sides(int normal, FollowedPair& out) const;
  bool rims(int i, int j, int which, FollowedPair& out) const;
  bool ends(int i, int j, FollowedPair& out) const;
  bool rimsNear(int i, int j, double reach) const;
  bool choose(int i, int j, int which, BodyCurve& at, double& presence) const;

  const DiscBody &A_, &B_;
  double flat_, size_;
};

}  // namespace dynamy
