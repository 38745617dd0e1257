/// GovernedMotion: a LocatedMotion whose work is watched. Where steps in time are cheaper, or it
/// stalls, it chooses the systems that are to be stepped in time (theory 50.7).
#pragma once
#include <dynamy/located/governed/charged_work.hpp>
#include <dynamy/located/governed/governed_state.hpp>

namespace dynamy {

class GovernedMotion {
 public:
  explicit GovernedMotion(const LocatedSettings& settings) : motion_(settings) {}
  LocatedMotion& motion() { return motion_; }
  const LocatedMotion& motion() const { return motion_; }
  SwitchGovernor& governor() { return state_.governor; }
  /// The state of x, or after a step that of its end.
  GovernedState& state() { return state_; }
  const GovernedState& state() const { return state_; }

  /// Reads the state of a step that begins at x. False: x.scheme is not of such a run.
  bool load(const MechanicalSystem& s, const State& x);
  /// Takes a located step of at most dt from x, after load(). After a refusal that is passable, and
  /// after a step where turned(), the systems to be stepped in time are in state().stepped.
  Refusal locate(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt,
                 StepReport& report);
  /// What the next step may cost; default: anything.
  void allow(const WorkAllowance& allowed) { allowed_ = allowed; }
  /// Work of the last step, in evaluations of one velocity.
  double spent() const { return spent_; }
  /// True: the governor has turned to steps in time.
  bool turned() const { return state_.governor.mode() == SwitchGovernor::Mode::step; }
  /// Writes the state into x.
  void store(State& x);
  /// Leaves the motion to clocks of islands, with no system stepped in time yet.
  void leave(const MechanicalSystem& s);

  /// State data with which a motion begins that decides everything anew, in the scales of this one.
  Eigen::VectorXd decidedAnew() const;
  /// Work of `evaluations` evaluations of a located step, or of a step in time with `newton` solves,
  /// in floating-point operations; contacts as in slot 0.
  double locatedWork(const MechanicalSystem& s, double evaluations) const;
  double steppedWork(const MechanicalSystem& s, double evaluations, double newton) const;

 private:
  void begin(const MechanicalSystem& s);
  void govern(const MechanicalSystem& s, long evaluations, const StepReport& report);
  LocatedMotion motion_;
  GovernedState state_;
  ChargedWork work_;
  WorkAllowance allowed_;
  double spent_ = 0.0;
  NumberArchive numbers_;
  Eigen::VectorXd stored_;  // x.scheme as written last: state_ is that of its state
  bool fresh_ = true;       // x.scheme is empty
};

}  // namespace dynamy
