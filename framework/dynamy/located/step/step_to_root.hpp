/// StepToRoot: the step to a switch, and the distance left to its root (theory 50.3).
///
///   d        from the end of that step to the root, by Newton's method on the true monitor
///   |d/h|³ ≤ 0.01 tol   u + d u̇ + ½ d² ü, with ü of the cubic through u and u̇ of both ends
///   |d/h|  ≤ 0.1        dense output of the step: its value and slope at the end are those of the
///                       motion, so that its error there is 16 (d/h)² of the largest
///   else                a step of its own, with all of its stages
#pragma once
#include <dynamy/located/step/located_parts.hpp>

namespace dynamy {

class StepToRoot {
 public:
  explicit StepToRoot(LocatedParts& parts) : parts_(parts) {}
  /// Repeats a trial of length h up to the switch w, and moves step.to to its root. `end`: the end
  /// of the repeated step, before the distance left. Impulses and works are added to the record.
  Refusal take(LocatedStep& step, double h, const Switch& w, PhasePoint& end);
  /// The error of the repeated step is above the tolerance, although the trial's was not: a force
  /// has jumped at one of its stages.
  bool strays() const { return strays_; }

 private:
  Refusal polish(LocatedStep& step, double h, const Switch& w);
  /// Moves step.to by the time d; `known`: the forces there are evaluated already.
  Refusal move(LocatedStep& step, double h, double d, bool& known);
  void moveByTaylor(LocatedStep& step, double d);
  Refusal moveByDense(LocatedStep& step, double t);
  Refusal moveByStep(LocatedStep& step, double d);
  /// Evaluates the forces at step.to and adds their impulse from known_ to there.
  Refusal settle(LocatedStep& step);
  LocatedParts& parts_;
  bool strays_ = false;
  const PhasePoint* end_ = nullptr;    // end of the repeated step
  PhasePoint known_;                   // last point on the way to the root with evaluated forces
  PhasePoint start_;                   // of a step of its own
  Eigen::VectorXd velocity_, second_;  // mean velocity of a move; ü
};

}  // namespace dynamy
