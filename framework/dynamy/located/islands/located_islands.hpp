/// LocatedIslands: islands whose switches are located, each with a clock of its own (theory 50.12).
///
///   advance   the island whose step ends first takes the next one; its step is not cut
///   meet      boxes of two paths meet at t*: the step ends there, or both become one island
///   divide    at the end of its step an island falls apart where no contact that is held, no
///             element and no shape that may come near soon joins its systems
///
/// A step of the run ends where the first of the islands' steps ends. Others are interpolated there.
/// Beside time-stepped islands they join these when they touch one of them.
#pragma once
#include <dynamy/located/islands/island_contacts.hpp>
#include <dynamy/located/islands/island_division.hpp>
#include <dynamy/located/islands/island_record.hpp>

namespace dynamy {

class LocatedIslands {
 public:
  /// Divides the motion of all systems, which has just ended a step at x, into islands with clocks.
  /// False: there is one island.
  bool divide(MechanicalSystem& s, const GovernedMotion& whole, const State& x,
              const StepReport& report);
  /// Puts the clocks to x, the end of the last step, as they were kept. Otherwise all systems that
  /// are not stepped in time have one clock, and everything is decided anew.
  void stand(MechanicalSystem& s, InclusionSolver& solver, const GovernedMotion& whole,
             const State& x, const SteppedState& stepped);
  /// Takes steps until all islands are known beyond x.t; none goes beyond `end`. Systems that have
  /// to be stepped in time from x on are noted in `stepped`.
  Refusal follow(MechanicalSystem& s, InclusionSolver& solver, const State& x, double end,
                 SteppedState& stepped, RunPatience& patience);
  /// The governor of the island that was last added to those stepped in time.
  const SwitchGovernor& turnedBy() const { return turned_; }

  /// Computes the states at t, up to which all of them are known.
  void place(MechanicalSystem& s, double t);
  /// Copies them into x, the end of a step.
  void join(const MechanicalSystem& s, State& x) const;
  /// After a step in time with contacts in slot 0 which ended at t: islands that touch time-stepped
  /// ones join them, and if these are held up, those whose steps end at t.
  void touch(MechanicalSystem& s, double t, SteppedState& stepped);
  /// Fills the report of a step that ended at x, in which some systems were stepped in time, or
  /// none: then with all contacts. Keeps the clocks in `stepped`.
  void report(MechanicalSystem& s, const State& x, SteppedState& stepped, StepReport& report);

  /// Keeps the clocks in `stepped`.
  void keep(SteppedState& stepped);

  /// Writes the located islands at t into `out`.
  void show(MechanicalSystem& s, double t, State& out);
  /// As OneStep::contactsAt.
  bool contactsAt(MechanicalSystem& s, const State& at, bool after, ContactInstant& out);
  bool endedByMotion() const { return record_.endedByMotion(); }

  const IslandClocks& clocks() const { return clocks_; }

 private:
  void learn(const MechanicalSystem& s, const GovernedMotion& whole);
  IslandClock& add(const MechanicalSystem& s, const ClockState& x);
  Refusal proceed(MechanicalSystem& s, InclusionSolver& solver, double end, std::size_t clock,
                  SteppedState& stepped);
  Refusal meet(MechanicalSystem& s, InclusionSolver& solver, std::size_t clock);
  Refusal merge(MechanicalSystem& s, InclusionSolver& solver, std::size_t a, std::size_t b);
  /// Adds clocks for the islands among these systems of an island in state x.
  void addParts(const MechanicalSystem& s, const IslandDivision::Groups& groups,
                const std::vector<IslandDivision::Joined>& joined, const ClockState& x);
  bool fallApart(MechanicalSystem& s, std::size_t clock);
  IslandDivision division_;
  IslandRecord record_;
  LocatedSettings settings_;
  IslandContacts contacts_;
  IslandClocks clocks_;
  std::vector<ClockState> kept_;
  SwitchGovernor turned_;
  RunPatience* patience_ = nullptr;  // of the run, while follow() is called
  State at_;                         // of all systems, at the time that place() was given
  State ends_;                       // of the systems of a clock
  std::vector<char> apart_;
  Eigen::VectorXd decidedAnew_;
};

}  // namespace dynamy
