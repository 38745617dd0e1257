/// StepBudget: the work that a step of given length may take, with all its tries, halves and parts
/// (theory 37.7). Work is counted, in evaluations of one velocity of 0.1 to 0.35 µs, and not timed.
///
///   spent > B + saved   and   spent > 3 · (work of the step's first try)     the budget is exhausted
///
/// What steps leave is saved for others, up to 100 B: hits come in bursts. What a step takes beyond
/// the budget, because its first try costs more, is taken from later ones; where a try found no
/// solution, up to 20 budgets, and as long as more than one is owed, the first try is to cost
/// little, too: what fails from step to step has no better answer for more work.
#pragma once
#include <algorithm>
#include <dynamy/core/archive.hpp>
#include <dynamy/core/error.hpp>

namespace dynamy {

class StepBudget {
 public:
  static constexpr double kWork = 100000.0;  ///< B
  /// Work of the equal parts of a step that is too long for the motion, if nothing else is done.
  static constexpr double kEqual = 40000.0;
  explicit StepBudget(int nu) : unit_(std::max(kWork, kOfVelocity * nu)) {}
  /// Begins a step.
  void begin() {
    saved_ = std::clamp(saved_ + kWork - spent_, failed_ ? -kMostOwed * unit_ : -kWork, kMostSaved);
    spent_ = first_ = 0.0;
    owes_ = saved_ < -unit_, failed_ = false;
  }
  /// A try has taken this work; `solved`: it found a solution.
  void spend(double work, bool solved = true) {
    if (!(first_ > 0.0)) first_ = work;
    spent_ += work, failed_ = failed_ || !solved;
  }
  /// True: the rest of the step is to cost little.
  bool exhausted() const {
    return owes_ || spent_ > std::max(kWork + saved_, kFewestTries * first_);
  }
  /// Throws ModelError on numbers that no run produces.
  void archive(Archive& a) {
    a(saved_), a(spent_), a(failed_);
    if (!(saved_ >= -kMostOwed * unit_ && saved_ <= kMostSaved) || !(spent_ >= 0.0))
      throw ModelError("the checkpoint leaves no step its work");
  }

 private:
  static constexpr double kFewestTries = 3.0;  // a dear try can be halved once
  static constexpr double kMostSaved = 100.0 * kWork, kSavedAtFirst = 60.0 * kWork;
  static constexpr double kMostOwed = 20.0, kOfVelocity = 280.0;
  double unit_;  // B, more in large models
  double saved_ = kSavedAtFirst;
  bool failed_ = false, owes_ = false;  // a try of this step found no solution; see the header
  double spent_ = 0.0, first_ = 0.0;
};

}  // namespace dynamy
