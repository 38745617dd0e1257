/// LocatedBeside: islands whose switches are located while others are stepped in time (theory 50.7).
///
/// Their steps reach beyond the end of the step in time. They are interpolated there, and join the
/// time-stepped islands when they touch one of them.
#pragma once
#include <dynamy/located/governed/governed_motion.hpp>
#include <memory>

namespace dynamy {

class LocatedBeside {
 public:
  /// True: some systems with velocities are not stepped in time.
  static bool any(const Topology& topology, const SteppedState& stepped);
  /// Number of systems with velocities that are stepped in time.
  static int steppedSystems(const Topology& topology, const SteppedState& stepped);
  /// Settings and state data with which the motion of located islands begins: those of the motion
  /// of all islands.
  struct Beginning {
    const LocatedSettings& settings;
    const GovernedMotion& whole;
  };
  /// Integrates the located islands beyond x, the start of the step in time, at most to `end`.
  /// Returns the time up to which their motion is known. Islands that cannot be located any more
  /// are added to the time-stepped ones.
  double follow(MechanicalSystem& s, InclusionSolver& solver, const Beginning& beginning,
                const State& x, double end, SteppedState& stepped, StepCounts& counts);
  /// Computes the state of the located islands at t, a time that follow() has returned or less.
  void place(MechanicalSystem& s, double t, const SteppedState& stepped);
  /// Copies the located islands into x, the end of the step in time with contacts in slot 0. Those
  /// that touched a time-stepped island in it are stepped in time from now on.
  void join(MechanicalSystem& s, State& x, SteppedState& stepped, StepReport& report);
  /// Length that a step in time from t tries, if it tries h without located islands; `first`: where
  /// nothing is known of them.
  double nextStep(double t, double h, double first) const;
  /// Writes the located islands at t into `out`.
  void show(const MechanicalSystem& s, double t, const SteppedState& stepped, State& out);

 private:
  /// The view on the located islands.
  MechanicalSystem& viewOf(const MechanicalSystem& s, const SteppedState& stepped);
  void start(const MechanicalSystem& s, const Beginning& beginning, const State& x, double end,
             const SteppedState& stepped);
  bool step(MechanicalSystem& s, InclusionSolver& solver, bool again, SteppedState& stepped,
            StepCounts& counts);
  /// The state of the view at t, within the present step. A step that ends with a slip has no
  /// interpolation of its own: its accelerations are constant.
  void within(double t, State& out);
  SystemSubset subset_;
  std::unique_ptr<MechanicalSystem> view_;  // on subset_
  std::unique_ptr<GovernedMotion> motion_;
  State from_, to_;   // the present step
  State at_, shown_;  // within it: at the end of the step in time; for output
  double end_ = 0.0;  // time up to which the step might have gone [s]
  BesideState kept_;  // `from` and `end`, as kept with the state of the run
  StepWorks works_;
  std::vector<char> apart_;  // not 0: switches of the system are located
  bool known_ = false;
};

}  // namespace dynamy
