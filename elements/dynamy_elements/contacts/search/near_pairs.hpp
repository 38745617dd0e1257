/// NearPairs: the pairs of shapes that may touch within a step.
///
/// Each shape has a ball around it, widened by the distance at which it finds others. BroadPhase
/// finds the balls that overlap; half spaces are compared with all balls. Pairs that cannot touch
/// however fast they are, since they move side by side, are left out again (theory 38.3).
#pragma once
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy/contact/path_reach.hpp>
#include <dynamy_elements/contacts/search/broad_phase.hpp>
#include <dynamy_elements/contacts/search/pair_rules.hpp>

namespace dynamy {

/// The pairs that `broad` has found near each other among the shapes, each of which has a ball or a
/// box around it. Throws ModelError naming two of them if there are more than a step could take.
const std::vector<BroadPhase::Pair>& nearPairs(const BroadPhase& broad,
                                               const std::vector<BroadPhase::Pair>& found,
                                               const ShapeSet& shapes);

class NearPairs {
 public:
  NearPairs() = default;
  /// `shapes`, `rules`: borrowed.
  NearPairs(const ShapeSet& shapes, const PairRules& rules)
      : shapes_(&shapes), rules_(&rules), reach_(shapes.size()) {
    balls_.reserve(shapes.size());
  }

  /// Places the balls. Shapes see further if they are few, or requested by key.
  void place(const Kinematics& k, const ContactRequest& request);
  /// Calls f(i, j) for the pairs of shapes that can touch on a path from `start`, where bodies stay
  /// within `reach`: boxes hold their balls all the way, so that no other pair touches on it.
  template <class F>
  void onPath(const Kinematics& start, const PathReach& reach, F&& f) {
    placeOnPath(start, reach);
    for (const int h : shapes_->halfSpaces()) {
      const Flat flat(shapes_->inSpace()[static_cast<std::size_t>(h)], start);
      for (std::size_t i = 0; i < boxes_.size(); ++i)
        if (meetsOnPath(flat, static_cast<std::size_t>(h), i, reach)) f(h, static_cast<int>(i));
    }
    for (const auto& [i, j] : nearPairs(broad_, broad_.near(boxes_), *shapes_)) f(i, j);
  }
  /// Largest gap at which the shapes i and j are found [m].
  double reach(std::size_t i, std::size_t j) const { return reach_[i] + reach_[j]; }
  /// Calls f(h, i) for each half space h and each shape i it can meet. Half spaces meet all of few
  /// shapes, to follow their gaps, and the near ones of many.
  template <class F>
  void overHalfSpaces(const Kinematics& k, const ContactRequest& request, F&& f) {
    turned_.assign(balls_.size(), 0.0);
    const bool all = !rules_->few().empty() || request.refresh;
    for (const int h : shapes_->halfSpaces()) {
      const Flat flat(shapes_->inSpace()[static_cast<std::size_t>(h)], k);
      const auto meet = [&](int i) {
        if (meets(flat, static_cast<std::size_t>(h), static_cast<std::size_t>(i), k, all)) f(h, i);
      };
      if (rests(h))
        for (const int i : moving_) meet(i);
      else
        for (int i = 0; i < static_cast<int>(balls_.size()); ++i) meet(i);
    }
  }
  /// Calls f(i, j) for the near pairs of other shapes. Called after overHalfSpaces().
  template <class F>
  void others(const Kinematics& k, F&& f) {
    if (moving_.empty()) return;
    const bool moving = tau_ > 0.0;
    const std::size_t each = moving ? BroadPhase::kPassed : BroadPhase::kNeighbours;
    const std::vector<BroadPhase::Pair>& near =
        nearPairs(broad_, broad_.near(balls_, each), *shapes_);
    if (moving) followTurns(k, near);
    for (std::size_t m = 0; m < near.size(); ++m)
      if ((!moving || gap_[m] <= way_[m]) && !(rests(near[m].first) && rests(near[m].second)))
        f(near[m].first, near[m].second);
  }

 private:
  /// A half space at its place.
  struct Flat {
    const Frame& A;
    Vec3 n, p;
    Flat(const TouchingShape& s, const Kinematics& k)
        : A(k.frame(s.frame)), n(A.A_IK * s.n_K), p(A.r_OS_I + A.A_IK * s.p_K) {}
  };
  /// Gap of two shapes [m] and its rate [m/s].
  struct Approach {
    double gap = 0.0, rate = 0.0;
  };
  bool rests(int shape) const { return rests_[static_cast<std::size_t>(shape)] != 0; }
  void findResting(const Kinematics& k);
  void placeResting();
  void lookAhead(const Kinematics& k, const ContactRequest& request);
  bool meets(const Flat& flat, std::size_t h, std::size_t i, const Kinematics& k, bool all);
  void placeOnPath(const Kinematics& start, const PathReach& reach);
  bool meetsOnPath(const Flat& flat, std::size_t h, std::size_t i, const PathReach& reach) const;
  Vec3 centre(const TouchingShape& s, const Frame& f) const;
  void followTurns(const Kinematics& k, const std::vector<BroadPhase::Pair>& near);
  Approach approach(const Kinematics& k, std::size_t i, std::size_t j) const;

  const ShapeSet* shapes_ = nullptr;
  const PairRules* rules_ = nullptr;
  static constexpr std::uint64_t kUnknown = ~std::uint64_t{0};
  std::uint64_t stamp_ = kUnknown;     ///< of the kinematics for which the next three hold
  std::vector<int> moving_, resting_;  ///< shapes, ascending
  std::vector<char> rests_;            ///< per shape
  std::vector<double> reach_;          ///< per shape: how far beyond its ball it is to be seen [m]
  double tau_ = 0.0;                   ///< time that reach_ looks ahead [s]; 0: all pairs are taken
  std::vector<double> turned_;         ///< per shape: how far it may be thrown off its course [m]
  std::vector<double> gap_, way_;      ///< per near pair: least gap, most approach [m]
  std::vector<BroadPhase::Ball> balls_;
  std::vector<BroadPhase::Box> boxes_;  ///< per shape: where its ball is on a path; empty: nowhere
  BroadPhase broad_;
};

}  // namespace dynamy
