/// IslandClock: one island whose switches are located, with steps of its own (theory 50.12).
///
/// Its present step may reach beyond the time of the run, and is interpolated there.
#pragma once
#include <dynamy/located/governed/governed_motion.hpp>
#include <dynamy/located/islands/island_division.hpp>
#include <limits>
#include <memory>

namespace dynamy {

/// The present step of a clock.
struct IslandStep {
  State from, to;
  double end = 0.0;  ///< time up to which it might have gone [s]
  double energy = std::numeric_limits<double>::quiet_NaN();  ///< T + V at `from` [J]; NaN: unknown
  StepReport report;  ///< its length is 0 where the clock was just set
  bool turned =
      false;  ///< systems have to be stepped in time from `from` on: IslandClock::toStep()
  bool justSet = true;  ///< the clock has taken no step since it was set
  /// Statuses of the island's contacts where the step began, and at its end.
  std::vector<HeldStatus> before, after;
  const std::vector<HeldStatus>& statuses(double t) const { return t < to.t ? before : after; }
  /// Length of the step that the clock will try next [s].
  double next() const { return to.scheme.size() > 0 ? to.scheme[0] : 0.0; }
};

class IslandClock {
 public:
  /// A clock of an island of s, which begins in state x. The step of a clock that was kept is to be
  /// taken again().
  IslandClock(const MechanicalSystem& s, const LocatedSettings& settings, const ClockState& x);
  /// Puts contacts of two islands that became this one into the order in which they are reported.
  void orderContacts();
  /// Takes the next step, at most to `end`. After a refusal, and if it turned, the clock stands
  /// where this step began.
  Refusal step(MechanicalSystem& s, InclusionSolver& solver, double end);
  /// Takes the present step again, at most to `end`.
  Refusal again(MechanicalSystem& s, InclusionSolver& solver, double end);
  const IslandStep& now() const { return now_; }
  /// Systems that have to be stepped in time from the start of a step on that turned.
  std::vector<int> toStep() const;

  const std::vector<int>& systems() const { return systems_; }
  GovernedMotion& motion() { return motion_; }
  MechanicalSystem& system() const { return *view_; }
  /// Contacts that are held at the end of its step, or where it began.
  std::vector<IslandDivision::Joined> joined(bool atEnd);
  /// State at the end of its step, or where it began.
  ClockState state(bool atEnd) const;
  /// What a checkpoint holds of it.
  void keep(ClockState& out) const;

  // Between the numbers of its systems and those of the whole model:
  /// Writes the state of its systems at t, within the present step, into `out`. `closed`: with held
  /// contacts and joints closed, at the cost of an evaluation.
  void place(MechanicalSystem& s, double t, State& out, bool closed = false);
  /// What T + V gains from the start of its step up to t, within it [J].
  double gained(MechanicalSystem& s, double t);
  /// Writes velocities of its systems into those of the whole model.
  void giveVelocities(const Eigen::VectorXd& own, Eigen::VectorXd& out) const;
  /// As OneStep::contactsAt, of its contacts alone.
  bool contactsAt(const State& at, bool after, ContactInstant& out);
  /// Where the shapes of its systems are during the step, as of findPath().
  const PathBoxes& path() const { return path_; }
  void findPath(MechanicalSystem& s, std::span<const MovingShape> shapes);

  // Works of the step that have been booked, and whether it has been counted as ended.
  StepWorks booked{};
  bool counted = true;

 private:
  Refusal advance(MechanicalSystem& s, InclusionSolver& solver);
  void within(double t, bool closed);
  std::vector<int> systems_;
  SystemSubset subset_{SystemSubset::Outside::omitted};
  const Topology& whole_;
  std::unique_ptr<Topology> topology_;      // of subset_
  std::unique_ptr<MechanicalSystem> view_;  // on subset_
  GovernedMotion motion_;
  IslandStep now_;
  State at_, asked_;
  Kinematics kinematics_;
  std::vector<MovingShape> shapes_;
  PathBoxes path_;
};

}  // namespace dynamy
