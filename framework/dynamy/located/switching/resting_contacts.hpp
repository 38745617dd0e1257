/// RestingContacts: contacts that an event leaves at rest, although they would leave for a moment
/// (theory 50.4):
///
///   contacts that leave with v and are drawn back with a > 0 rise by v²/(2a) ≤ z tol L. They stay
///   closed: by an impact without rebound if they were hit, else by a projection of velocities.
///   A contact that approaches so slowly that it is no impact, with no force that closes it, comes to
///   rest in the same way: else it would close at once, and this event would be repeated.
///   A preloaded spring that forces drive back from both sides comes to rest in its middle.
///
/// The event is repeated with these contacts.
#pragma once
#include <dynamy/located/switching/event_impact.hpp>
#include <dynamy/located/switching/event_projection.hpp>

namespace dynamy {

class RestingContacts {
 public:
  void clear() { plastic_.clear(), shut_.clear(); }
  /// Contacts whose impact is repeated without rebound.
  const std::vector<ContactKey>& plastic() const { return plastic_; }
  /// True: velocities of some contacts are projected.
  bool shuts() const { return !shut_.empty(); }
  /// Projects velocities so that these contacts come to rest, after `impact` of slot 0.
  void shut(OngoingEvent& at, const EventImpact& impact, EventProjection& projection);
  /// Finds contacts that leave but stay closed, with the new statuses `held`. True: there are some
  /// that were not found before.
  bool findClosed(OngoingEvent& at, const EventImpact& impact, const std::vector<Held>& held);
  /// After findClosed: the contact at.closes, if it does not separate, comes to rest with all that
  /// touches. True: it was not found before.
  bool close(const OngoingEvent& at, const EventImpact& impact);
  /// Finds preloaded springs that come to rest; aBefore: u̇ under the statuses `old`. True: there
  /// are some that were not found before.
  bool findInNotch(OngoingEvent& at, const Eigen::VectorXd& aBefore, const std::vector<Held>& old,
                   const std::vector<Held>& held);

 private:
  void evaluate(const OngoingEvent& at);
  std::vector<ContactKey> plastic_, shut_;
  Eigen::VectorXd gamma_;
  std::vector<Held> resting_;
  std::vector<std::array<int, 2>> parts_;
};

}  // namespace dynamy
