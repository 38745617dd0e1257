/// SwitchEvent: what happens at the instant of a switch (theory 50.4).
///
///   1  project with the old status
///   2  impact of all contacts that are closed or touch (EventImpact)
///   3  decide the new status by one inclusion that looks ahead (StatusDecision)
///   4  project with the new status, accelerations
///   5  contacts that leave and return within the tolerance stay closed (RestingContacts): again
///      from 2 with these contacts
#pragma once
#include <dynamy/located/phase/smooth_step.hpp>
#include <dynamy/located/switching/event_contacts.hpp>
#include <dynamy/located/switching/resting_contacts.hpp>
#include <dynamy/located/switching/status_decision.hpp>

namespace dynamy {

class SwitchEvent {
 public:
  void prepare(const ErrorNorm& norm) { norm_ = &norm; }
  /// Plain: decides by the inclusion on the level of accelerations at the instant itself; contacts
  /// that leave are open however soon they return.
  void plain(bool wanted) { plain_ = wanted; }
  /// In plain decisions from now on contact `key`, whose friction has reached its bound, slips in
  /// its one tangent with the sign of `direction`; 0: no contact is released.
  void release(ContactKey key, double direction) { released_ = {key, direction}; }
  /// Excludes contact `key` from the next event, since its features leave one another.
  void leave(ContactKey key) { left_ = key; }
  /// The next event: this contact closes at once, although it may separate at the instant.
  void close(ContactKey key) { closes_ = key; }
  /// The next event is the first of a run.
  void start() { starts_ = true; }
  /// Processes the event at p.x: changes p.x, `phase` and p (accelerations under the new status).
  /// `lookAhead`: h_s; `stopped`: parts whose slip ends here whatever speed is left. Slot 0 is left
  /// evaluated at p.x with all contacts that took part.
  EventResult process(MechanicalSystem& s, InclusionSolver& solver, ContactProbe& probe,
                      FrozenPhase& phase, PhasePoint& p, const SmoothStep& smooth, double lookAhead,
                      const std::vector<HeldKey>& stopped);
  /// The impact of the last process().
  const EventImpact& impact() const { return impact_; }
  /// Velocities before it.
  const Eigen::VectorXd& uBefore() const { return uBefore_; }

 private:
  bool begin(OngoingEvent& at, ContactProbe& probe, const std::vector<Held>& held);
  void projectHeld(OngoingEvent& at, const std::vector<Held>& held);
  bool settle(OngoingEvent& at, const std::vector<Held>& old, double lookAhead,
              const std::vector<HeldKey>& stopped);
  bool accelerateAlone(OngoingEvent& at);
  const ErrorNorm* norm_ = nullptr;
  bool plain_ = false;
  StatusDecision::Release released_;
  ContactKey left_ = kNoContact, closes_ = kNoContact;
  bool starts_ = false;
  EventContacts contacts_;
  EventProjection projection_;
  EventImpact impact_;
  RestingContacts resting_;
  StatusDecision decision_;
  std::vector<ContactKey> keys_;
  Eigen::VectorXd uEvaluated_;  // velocities with which slot 0 was evaluated
  Eigen::VectorXd uBefore_, aBefore_;
  FrozenPhase next_;
};

}  // namespace dynamy
