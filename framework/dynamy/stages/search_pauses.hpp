/// SearchPauses: decides which attempts of a run may search for a solution for long. If a search
/// fails in one step, it seldom succeeds in the next one. After a failed search the next 1, 3, 7, …
/// 63 attempts therefore use the shorter search that finds nearly all solutions (Effort::retried);
/// where pauses are long, since nearly all long ones fail, three of four hardly search at all.
/// If three of ten steps, at random, have no solution, one attempt of twenty searches for long; if
/// one of a hundred has none, 99 of a hundred do.
#pragma once
#include <algorithm>
#include <dynamy/core/archive.hpp>
#include <dynamy/core/number_archive.hpp>
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

class SearchPauses {
 public:
  /// What the next attempt may spend.
  Effort next() const {
    if (left_ == 0) return Effort::full;
    return pause_ >= kHopeless && left_ % kTried != 0 ? Effort::little : Effort::retried;
  }
  /// Ends the attempt; `found`: no long search of the attempt has failed.
  void done(bool found) {
    if (left_ > 0) {
      --left_;
    } else if (found) {
      pause_ = std::max(0, pause_ - 1);
    } else {
      left_ = pause_ = std::min(2 * pause_ + 1, kLongest);
    }
  }
  /// Throws ModelError on numbers that no run produces.
  void archive(Archive& a) {
    a(pause_), a(left_);
    if (!possible()) throw ModelError("the checkpoint counts pauses that no run makes");
  }
  void archive(NumberArchive& a) { a(pause_), a(left_); }
  /// False: numbers that were read are of no run.
  bool possible() const {
    return pause_ >= 0 && pause_ <= kLongest && left_ >= 0 && left_ <= pause_;
  }

 private:
  static constexpr int kLongest = 63;
  static constexpr int kHopeless = 15, kTried = 4;
  int pause_ = 0, left_ = 0;
};

}  // namespace dynamy
