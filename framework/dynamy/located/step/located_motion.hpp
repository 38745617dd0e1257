/// LocatedMotion: the motion of one island, integrated to a tolerance across its switches
/// (theory 50). The island is the MechanicalSystem it is given: a view on some systems, or all.
///
///   trial        a smooth step with the statuses held, and the first switch on its path
///   to the root  the step again up to the switch, and the distance left
///   event        impact, decision, projection: the next phase
///
/// Each instance has a state of its own, HeldState, which a checkpoint holds: two instances may
/// advance two islands of one model.
#pragma once
#include <dynamy/located/step/last_step.hpp>
#include <dynamy/located/step/phase_projection.hpp>
#include <dynamy/located/step/slip_ends.hpp>
#include <dynamy/located/step/step_to_root.hpp>
#include <dynamy/located/step/trial_step.hpp>
#include <limits>

namespace dynamy {

class LocatedMotion {
 public:
  explicit LocatedMotion(const LocatedSettings& settings) { parts_.settings = settings; }
  LocatedMotion(const LocatedMotion&) = delete;
  LocatedMotion& operator=(const LocatedMotion&) = delete;

  const LocatedSettings& settings() const { return parts_.settings; }
  /// Sets the accuracy of the run.
  void aim(const Accuracy& accuracy) { parts_.settings.accuracy = accuracy, system_ = nullptr; }
  /// Continues with the scales T of the scene and of each system [s] of a run that was stored.
  void scales(const MechanicalSystem& s, double time, const Eigen::VectorXd& times);

  /// How a step begins.
  struct Start {
    const HeldState* held = nullptr;  ///< the state at its start; null: all is decided anew
    bool scaled = false;              ///< scales() have been given
    bool goesOn = false;  ///< it begins where the last one ended (endsAt), in the same state
    ContactKey lastSwitched = kNoContact;
    /// Work after which a step that is not done stalls, in evaluations of one velocity.
    double most = std::numeric_limits<double>::infinity();
  };
  /// Advances from x by at most dt, to end(). After a refusal x is the state to continue from, in
  /// another way. Slot 0 has the contacts of the end.
  Refusal advance(MechanicalSystem& s, InclusionSolver& solver, const State& x, const Start& start,
                  double dt, StepReport& report);
  const State& end() const { return to_.x; }
  /// True: the last step in s ended at x.
  bool endsAt(const MechanicalSystem& s, const State& x) const;
  /// The state at the end of the last step.
  void keep(HeldState& out) const;
  /// Fills the report of the step that has ended at x.
  void report(MechanicalSystem& s, State& x, StepReport& report);

  /// State at fraction theta of the last step; `closed`: with held contacts and joints closed there,
  /// at the cost of an evaluation. False: it did not go from `a` to `b`.
  bool interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   State& out, bool closed = false);
  /// As OneStep::contactsAt.
  bool contactsAt(const MechanicalSystem& s, const State& at, bool after, ContactInstant& out);

  const LocatedParts& parts() const { return parts_; }
  /// The contact of the last switch, or at which the last step was refused.
  ContactKey lastSwitched() const { return lastSwitched_; }

 private:
  Refusal enter(LocatedStep& step, const State& x, const Start& start);
  Refusal begin(LocatedStep& step, const State& x, bool scaled);
  Refusal restore(LocatedStep& step, const State& x, const HeldState& held);
  /// Tries one step of at most `most`; `done`: it was taken.
  Refusal proceed(LocatedStep& step, double most, bool& done);
  /// How far a trial may go.
  struct Bound {
    double most;     ///< its largest length [s]
    bool announced;  ///< at its end is an instant at which an element jumps,
    double end;      ///< which the step passes at most up to this time [s]
    bool own;        ///< the state at its start has limited the trial
  };
  /// Ends an accepted trial: at the switch it found, at an announced instant, or where it ended.
  Refusal finish(LocatedStep& step, const Trial& trial, const Bound& bound, bool& done);
  LocatedParts parts_;
  ComingContacts coming_{parts_};
  EventStage events_{parts_};
  SlipEnds slipEnds_{parts_, coming_, events_};
  TrialStep trials_{parts_, coming_};
  StepToRoot toRoot_{parts_};
  PhaseProjection projection_{parts_};
  LastStep last_;
  StepRecord record_;
  PhasePoint from_, to_;
  std::vector<Held> startHeld_;
  MechanicalSystem* system_ = nullptr;  // of the last step; null: nothing is prepared
  ContactKey lastSwitched_ = kNoContact;
};

}  // namespace dynamy
