/// ComingContacts: contacts that come and go with the features of bodies, and contacts that joints
/// bear (theory 50.9, 34.4).
///
/// A trial must follow all contacts that bodies may meet with on its path. Where a contact on the
/// path cannot be followed, or bodies overlap more than at the start of the trial, a shorter trial
/// ends before that place.
#pragma once
#include <dynamy/located/step/located_parts.hpp>
#include <dynamy/located/switching/path_contacts.hpp>

namespace dynamy {

class ComingContacts {
 public:
  explicit ComingContacts(LocatedParts& parts) : parts_(parts) {}

  /// Gathers the contacts at the start of a trial, and sets up search for them. Contacts that
  /// joints bear are watched as such. `time`: longest trial [s]. False: contacts change in a way
  /// that cannot be followed.
  bool begin(LocatedStep& step, double time);
  /// Adds the contacts that bodies may meet with along the path. False: some cannot be followed,
  /// and clear() is the part of the path before them.
  bool widen(const State& from, const QuinticPath& path);
  /// True: contacts that the trial was not expected to reach are not followed.
  bool narrowed() const { return near_.narrowed(); }
  void prepare(const SystemParts& parts) { near_.prepare(parts); }
  double clear() const { return clear_; }
  /// Part of the path before too deep an overlap inside it; 1: there is none.
  double passing() const { return passing_; }
  /// Forgets what the last trial met.
  void newTrial() { clear_ = passing_ = 1.0; }
  /// True: bodies whose contacts come and go overlap more at x than at the start of the trial.
  bool sinks(const State& x);
  /// Of those bodies, a contact of two that cannot be followed, since steps are as short as `h` [s]:
  /// their contacts jump, they overlap from the start on, or no switch can have been missed.
  /// kNoContact: there are none.
  ContactKey sunk(double h) const;
  /// True: an open contact penetrates at x.
  bool closesOpen(const State& x);

 private:
  bool leaveToJoints(LocatedStep& step);
  bool hasJoint() const;
  void narrow(const NearContacts* near);
  bool widenAlong(const State& from, const QuinticPath& path);
  LocatedParts& parts_;
  PathContacts near_;
  std::vector<ContactKey> borne_, asked_;
  ContactKey inside_ = kNoContact;  // of two bodies that overlap at the start
  double clear_ = 1.0, passing_ = 1.0, startOverlap_ = 0.0;
  State at_;
};

}  // namespace dynamy
