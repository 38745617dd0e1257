/// What the stages of a located step share: LocatedParts lasts as long as the run, LocatedStep as
/// long as one step.
#pragma once
#include <dynamy/located/step/held_state.hpp>
#include <dynamy/located/step/located_settings.hpp>
#include <dynamy/located/step/missing_bias.hpp>
#include <dynamy/located/step/refusal.hpp>
#include <dynamy/located/step/step_record.hpp>
#include <dynamy/located/switching/switch_event.hpp>
#include <dynamy/located/switching/switch_search.hpp>

namespace dynamy {

struct LocatedParts {
  LocatedSettings settings;
  ErrorNorm norm;
  PhaseMotion motion;
  ContactProbe probe;
  SwitchSearch search;
  SwitchEvent event;
  MissingBias bias;
  Pace pace;
  /// True: the motion decided where the last step ended: at a switch, at an announced instant, or at
  /// a part of the time that a slip lasts; else a bound on the length or on the error did.
  bool endedByMotion = false;
  /// Evaluations by which the last step restored what a run that goes on knows.
  long repeated = 0;

  /// Time that instants are compared with [s]: the next trial, at most T, since steps at rest grow
  /// beyond T.
  double span() const { return std::min(pace.next, norm.time()); }
  /// Overlaps up to this are left as they are [m].
  double leftOverlap() const;
  /// Overlaps inside a step that end before it does are left up to this [m].
  double passingOverlap() const;
  /// A circle whose lowest point is less than this below its middle lies flat [m].
  double flatHeight() const;
  /// Work of the present step of s so far, with `evaluations` of them, in evaluations of one velocity;
  /// as fitted to the times of random scenes (theory 50.7).
  double work(const MechanicalSystem& s, long evaluations) const;
  void forgetWork() { probe.looks = {}, motion.phase.cubes = 0.0; }
};

/// The step that is taken at present. Moves from `from` to `to`.
struct LocatedStep {
  MechanicalSystem& s;
  InclusionSolver& solver;
  StepReport& report;
  LocatedParts& parts;
  PhasePoint &from, &to;
  StepRecord& record;
  std::vector<Held>& startHeld;  ///< held contacts at `from`
  ContactKey lastSwitched;       ///< the contact of the last switch
  bool otherSet = false;         ///< a trial met a law whose set became another one
  long booked = s.evaluations();

  /// Books the evaluations since the last call.
  void book(long StepEffort::*what);
  /// Evaluates the forces at p: p gets its derivatives. `alone`: as PhaseMotion::evaluate.
  Refusal evaluate(PhasePoint& p, bool alone = false);
  /// The refusal for a fault of the phase, of contacts or of an event.
  Refusal fault();
  Refusal fault(std::string_view why, ContactKey at);
  /// The refusal because contacts appear or disappear that cannot be followed.
  Refusal unfollowed() { return lose(parts.probe.unfollowed()); }
  /// The refusal because contact `at` comes or goes in a way that cannot be followed.
  Refusal lose(ContactKey at);
  /// The refusal because steps have become too short.
  Refusal stall() const;
};

}  // namespace dynamy
