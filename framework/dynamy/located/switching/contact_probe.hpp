/// ContactProbe: evaluates gaps and relative velocities of all contacts, also of open ones, at any
/// state and without masses and forces. The search of switches uses it.
///
/// Contacts that come and go with the features of bodies are gathered anew before every step and
/// every event. Contacts that the bodies may meet with along the path of a step are added to them.
#pragma once
#include <dynamy/located/switching/announcements.hpp>
#include <dynamy/located/switching/noted_contacts.hpp>
#include <dynamy/located/switching/single_contact.hpp>

namespace dynamy {

class ContactProbe {
 public:
  /// The fault where look() failed: unfollowed() names the contact.
  static constexpr std::string_view kUnfollowed = "contacts appear and disappear";

  /// Notes all contacts that are reported at x. A contact that appears later is a fault.
  void prepare(const MechanicalSystem& s, const State& x);
  /// From now on, circles whose lowest point is less than `height` below their middle lie flat [m].
  void flat(double height) { flat_ = height; }
  /// Notes all contacts anew, after an element switched, or bodies were removed or added.
  void list(const State& x);
  /// Evaluates all contacts at x; false: they are not those noted before.
  bool look(const State& x);
  /// Evaluates gap, presence and γ of contact i of the last look() at θ of the path; all others
  /// stay. Of x, only what the contact depends on is set, if its element can tell.
  bool lookAt(const QuinticPath& path, double theta, State& x, int i);
  /// Numbers of looks at all contacts that are followed and of gaps evaluated, and the work of those
  /// that took a search, in evaluations of one velocity; the caller resets them.
  struct Looks {
    long whole = 0, gaps = 0;
    double searched = 0.0;
  };
  Looks looks;
  /// All contacts, as of the last look().
  const ContactGaps& gaps() const { return gaps_; }
  /// True: contacts have to be gathered before each step.
  bool gathers() const { return gathers_ && (near_ == nullptr || near_->some() || othersGather_); }
  /// True: there are contacts, near or not.
  bool any() const { return gathers_ || !fixed_.empty(); }
  /// From the next gather() on, only the contacts `near` are followed (borrowed); null: all.
  void narrow(const NearContacts* near);
  const NearContacts* near() const { return near_; }
  /// Of the contacts that come and go, follows those that may touch at x and those that are `held`;
  /// evaluates all contacts at x.
  bool gather(const State& x, std::span<const ContactKey> held);
  /// Adds, from the next settle() on, the contacts that may touch within `ahead` [s] of x.
  void widen(const State& x, double ahead);
  bool settle(const State& x);
  /// Contacts that may touch soon, as of the last gather() or widen().
  const NotedContacts& noted() const { return noted_; }
  /// The contact that came or went where look() failed. If only their order changed: the first
  /// contact, or kNoContact without any.
  ContactKey unfollowed() const;
  /// Evaluates all contacts at x nearer than `within` [m], followed or not. Returns the contact
  /// that `key` stands for, kNoContact: there is none.
  ContactKey lookAround(const State& x, double within, ContactKey key);
  const Announcements& announcements() const { return announcements_; }
  /// Numbers that are positive where an element would switch.
  const std::vector<double>& switching() const { return switching_; }

 private:
  void evaluate(const State& x, const ContactRequest& request);
  void finish(const State& x);
  const SystemParts* parts_ = nullptr;
  Kinematics kinematics_;
  ContactGaps gaps_;
  SingleContact one_;
  std::vector<ContactKey> fixed_;  // contacts that do not come and go
  const NearContacts* near_ = nullptr;
  std::vector<ContactKey> all_, order_, wide_;
  NotedContacts noted_;
  bool ordered_ = false;       // order_ is that of contacts as they are followed now
  bool gathers_ = false;       // some contacts come and go, or are noted before they touch
  bool othersGather_ = false;  // so do some of elements that cannot tell which contacts are near
  double flat_ = 0.0;
  Announcements announcements_;
  std::vector<double> switching_;
};

}  // namespace dynamy
