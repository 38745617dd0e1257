/// SearchPauses: which steps of a run may search for long. What no search has found in a step is
/// seldom found in the next one: after a search in vain 1, 3, 7, … 63 attempts do with what finds
/// nearly all solutions (Effort::retried). Where three of ten steps, at random, have no solution, one
/// attempt of twenty searches; where one of a hundred has none, 99 of a hundred do.
#pragma once
#include <algorithm>
#include <dynamy/core/archive.hpp>
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

class SearchPauses {
 public:
  /// What the next attempt may spend.
  Effort next() const { return left_ > 0 ? Effort::retried : Effort::full; }
  /// The attempt is over; `found`: what it has searched for long, it has found.
  void done(bool found) {
    if (left_ > 0) {
      --left_;
    } else if (found) {
      pause_ = std::max(0, pause_ - 1);
    } else {
      left_ = pause_ = std::min(2 * pause_ + 1, kLongest);
    }
  }
  /// Throws ModelError on numbers that no run can have left.
  void archive(Archive& a) {
    a(pause_), a(left_);
    if (pause_ < 0 || pause_ > kLongest || left_ < 0 || left_ > pause_)
      throw ModelError("the checkpoint counts pauses that no run makes");
  }

 private:
  static constexpr int kLongest = 63;
  int pause_ = 0, left_ = 0;
};

}  // namespace dynamy
