/// NotedContacts: pairs of features that may touch soon, as elements note them, and which of them
/// elements report when they are requested by key. Where no gap describes the contact of two
/// touching bodies, the contact is noted but not reported: locating ends where two such bodies
/// meet.
#pragma once
#include <dynamy/located/switching/contact_gaps.hpp>
#include <span>

namespace dynamy {

class NotedContacts {
 public:
  /// Reads what an evaluation has noted; `followed`: the contacts that are followed at present,
  /// ascending. Returns those of which it is not known yet whether elements report them, ascending.
  std::span<const ContactKey> read(const ContactSet& evaluated,
                                   const std::vector<ContactKey>& followed);
  /// Learns it from an evaluation in which these contacts were requested.
  void learn(const ContactSet& evaluated);
  /// The first noted contact that no element reports; kNoContact: there is none.
  ContactKey unreported() const;
  /// True: some of the contacts read last are not followed yet.
  bool fresh() const { return fresh_; }
  /// True: looks have to follow each other in shorter times, or bodies pass through each other.
  bool unseen() const { return unseen_; }
  /// How deep bodies whose contacts come and go overlap [m].
  double overlap() const { return overlap_; }
  /// A contact of bodies whose contacts jump that overlap by more than `depth` [m]; kNoContact: there
  /// are none.
  ContactKey jumping(double depth) const { return jumpingOverlap_ > depth ? jumping_ : kNoContact; }
  /// The same of any bodies whose contacts come and go.
  ContactKey deepest(double depth) const { return overlap_ > depth ? deepest_ : kNoContact; }

 private:
  std::vector<ContactKey> noted_, unknown_;
  std::vector<ContactKey> reported_, unreported_;  // of all noted so far, ascending
  bool fresh_ = false, unseen_ = false;
  double overlap_ = 0.0, jumpingOverlap_ = 0.0;
  ContactKey jumping_, deepest_;
};

}  // namespace dynamy
