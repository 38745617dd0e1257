/// EventContacts: the contacts that take part in an event: two-sided ones, those that touch without
/// separating, and those that are held. Of features at one place only one counts, and contacts that
/// joints bear take no part.
#pragma once
#include <dynamy/located/phase/held.hpp>
#include <dynamy/located/switching/contact_probe.hpp>
#include <dynamy/located/switching/ongoing_event.hpp>

namespace dynamy {

class EventContacts {
 public:
  /// Contacts of the same two bodies that are nearer than this part of L count as one.
  static constexpr double kSame = 4e-6;
  /// Features that lie over one another by less than this part of L leave.
  static constexpr double kGone = 1e-12;
  /// Finds the contacts of an event that ends the statuses `held`. `left`: a contact whose features
  /// leave one another, which takes no part. False: contacts have come or gone that cannot be
  /// followed.
  bool find(ContactProbe& probe, const std::vector<Held>& held, ContactKey left,
            const OngoingEvent& at);
  /// Drops contacts that joints bear, evaluated in slot 0 at the event; evaluates the rest there.
  void leaveToJoints(OngoingEvent& at);
  /// True: some of them overlap by more than rounding.
  bool overlap() const { return overlap_; }
  /// Their keys, ascending.
  const std::vector<ContactKey>& keys() const { return keys_; }

 private:
  bool leaves(const ContactGaps& gaps, int i, double length) const;
  bool touches(const ContactGaps& gaps, int i, const OngoingEvent& at) const;
  void leaveOneOfEach(const ContactGaps& gaps, const std::vector<Held>& held, double length);
  bool overlap_ = false;
  ContactKey left_;
  std::vector<ContactKey> keys_, held_, borne_;
  std::vector<int> taking_, alike_;  // contacts of the probe; one of each place
};

}  // namespace dynamy
