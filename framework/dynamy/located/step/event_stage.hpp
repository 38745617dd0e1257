/// EventStage: the end of a phase: the event at a switch, at an announced instant or where a slip
/// ends, and the next phase (theory 50.3, 50.4).
///
/// Empty events that follow each other at once, which change nothing, lengthen the look ahead of
/// decisions; after five of them the statuses that hold are kept for a while.
#pragma once
#include <dynamy/located/step/located_parts.hpp>

namespace dynamy {

class EventStage {
 public:
  explicit EventStage(LocatedParts& parts) : parts_(parts) {}
  /// Processes an event at p: impact, new statuses, their accelerations. `stopped`: parts whose
  /// slip ends here whatever speed is left.
  Refusal event(LocatedStep& step, PhasePoint& p, const std::vector<HeldKey>& stopped = {});
  /// Decides the statuses after switch w at p.
  Refusal decide(LocatedStep& step, PhasePoint& p, const Switch& w);
  /// Decides the statuses at p anew, with no switch.
  Refusal decideAnew(LocatedStep& step, PhasePoint& p);
  /// The same at the start of a run.
  Refusal start(LocatedStep& step, PhasePoint& p);

  /// Time from step.from until right before the next instant at which an element jumps as a
  /// function of time [s]; that instant is instant().
  double untilInstant(const LocatedStep& step);
  double instant() const { return instant_; }
  /// Moves p from right before the announced instant to right after it, at most to `end`, and
  /// decides the statuses there.
  Refusal passInstant(LocatedStep& step, PhasePoint& p, double end);
  /// Follows the contacts that are reported at x from now on. True: a held contact is gone, or a
  /// contact that always acts is not held.
  bool relist(const State& x);

 private:
  void release(const Switch& w);
  void noteEmpty(const EventResult& r, double t);
  Refusal throwLatch(LocatedStep& step, PhasePoint& p);
  LocatedParts& parts_;
  double instant_ = -1e300, instantAfter_ = 1e300;  // the first instant after a time [s]
  Eigen::VectorXd velocity_;
};

}  // namespace dynamy
