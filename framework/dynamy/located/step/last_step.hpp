/// LastStep: the smooth part of the last step, for output between its ends: states by the dense
/// output, and forces of contacts with the statuses of the step or of the phase after it.
#pragma once
#include <dynamy/located/phase/held_projection.hpp>
#include <dynamy/located/phase/phase_motion.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class LastStep {
 public:
  /// Forgets the step before: a step begins at positions q.
  void begin(const Eigen::VectorXd& q) { enteredAt_ = q; }
  /// Keeps the step that motion.step has taken from `from`; end() is its end.
  void keep(const PhasePoint& from, const PhaseMotion& motion);
  PhasePoint& end() { return end_; }

  /// State at fraction theta of the step from a to b. False: `a` is not the start of this step.
  bool interpolate(MechanicalSystem& s, PhaseMotion& motion, const State& a, const State& b,
                   double theta, State& out);
  /// The same of a step of length h [s] with constant accelerations, whose velocities become u.
  static void towards(const MechanicalSystem& s, const State& a, const Eigen::VectorXd& u, double h,
                      double theta, State& out);
  /// Closes the contacts and joints that are held during the step at x, which is within it: the dense
  /// output leaves them open by its error.
  void close(MechanicalSystem& s, State& x);
  /// Forces and relative velocities of contacts at `at`; `after`: with the statuses of the present
  /// phase. False: the phase has a fault there.
  bool contactsAt(MechanicalSystem& s, const PhaseMotion& motion, const State& at, bool after,
                  ContactInstant& out);

 private:
  PhasePoint from_, end_;
  FrozenPhase phase_;          // of the step
  FrozenPhase asked_;          // as it is asked for: what is asked changes nothing
  Eigen::VectorXd enteredAt_;  // q at the start of the step, which a decision there may correct
  Eigen::VectorXd a_;
  HeldProjection projection_;
  Eigen::VectorXd delta_;
};

}  // namespace dynamy
