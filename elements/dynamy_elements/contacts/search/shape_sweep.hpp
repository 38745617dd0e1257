/// ShapeSweep: shapes along the path of a step: which shapes are fast, and which contact is passed
/// first (theory 37).
///
///   fast       way of both together > thickness (half the least width) of the thinner shape
///   passed     gap below −d somewhere on the path, d = 1e-6 of the thickness
///
/// In axes of one of two shapes, a point of the other moves almost straight during a piece. The
/// distance from a convex set is convex along a straight line: a minimum is found by sections.
#pragma once
#include <dynamy/contact/swept_path.hpp>
#include <dynamy_elements/contacts/search/broad_phase.hpp>
#include <dynamy_elements/contacts/search/pair_rules.hpp>

namespace dynamy {

class ShapeSweep {
 public:
  ShapeSweep() = default;
  /// `shapes`, `rules`: borrowed.
  ShapeSweep(const ShapeSet& shapes, const PairRules& rules) : shapes_(&shapes), rules_(&rules) {
    balls_.reserve(shapes.size());
  }
  /// How many pieces the path of a step of dt [s] needs; 0: nothing is fast.
  int pieces(const Kinematics& k, double dt);
  Passing firstPassing(const SweptPath& path, int element);

 private:
  /// Calls `f` for the near pairs of balls_, and for each half space with each shape in balls_.
  template <class F>
  void forNearPairs(F&& f);
  /// First passing of feature f, if it begins before `latest` [s].
  Passing passing(const TouchingPair& pair, std::size_t f, const SweptPath& path,
                  double latest) const;

  const ShapeSet* shapes_ = nullptr;
  const PairRules* rules_ = nullptr;
  std::vector<Vec3> turns_;  ///< rotation vectors per frame and piece
  std::vector<BroadPhase::Ball> balls_;
  BroadPhase broad_;
};

}  // namespace dynamy
