/// ContactProbe: gaps and relative velocities of all contacts, also of open ones, at any state and
/// without masses and forces. The search of switches uses it.
///
/// Contacts that come and go with the features of bodies are gathered anew before every step and
/// every event. Contacts that the bodies may meet with along the path of a step are added to them.
/// Where no gap describes the contact of two touching bodies, the contact is noted as well, but
/// elements do not report it by its key: locating ends where two such bodies meet.
#pragma once
#include <dynamy/located/switching/announcements.hpp>

namespace dynamy {

class ContactProbe {
 public:
  /// The fault where look() failed: unfollowed() names the contact.
  static constexpr std::string_view kUnfollowed = "contacts appear and disappear";

  /// Notes all contacts that are reported at x. A contact that appears later is a fault.
  void prepare(const MechanicalSystem& s, const State& x);
  /// Notes all contacts anew, after an element switched, or bodies were removed or added.
  void list(const State& x);
  /// Evaluates all contacts at x; false: they are not those noted before.
  bool look(const State& x);
  /// Evaluates gap, presence and γ of contact i of the last look() at x; all others stay.
  bool lookAt(const State& x, int i);
  /// True: some contacts come and go.
  bool comesAndGoes() const { return contacts_.comesAndGoes; }
  /// True: contacts have to be gathered before each step.
  bool gathers() const { return comesAndGoes() || notes_; }
  /// Of the contacts that come and go, follows those that may touch at x and those that are `held`;
  /// evaluates all contacts at x.
  bool gather(const State& x, std::span<const ContactKey> held);
  /// Adds, from the next settle() on, the contacts that may touch within `ahead` [s] of x.
  void widen(const State& x, double ahead);
  bool settle(const State& x);
  /// True: at the last gather() or widen(), bodies may meet whose contact cannot be followed.
  bool meets() const { return meets_ != kNone; }
  ContactKey met() const { return meets_; }
  /// True: the last widen() noted contacts that look() does not evaluate yet.
  bool notesFresh() const { return notesFresh_; }
  /// How deep bodies whose contacts come and go overlap at the last gather() or widen() [m].
  double overlap() const { return overlap_; }
  /// Positive while the features of contact i lie over one another [m].
  double presence(int i) const { return contacts_.presence[static_cast<std::size_t>(i)]; }
  bool comesAndGoes(int i) const { return presence(i) < ContactSet::kAlways; }
  /// True: contacts i and j, which come and go, are at one place with one normal.
  bool coincide(int i, int j, double distance) const;
  static constexpr ContactKey kNone{~std::uint64_t{0}};
  /// The contact that came or went where look() failed. If only their order changed: the first
  /// contact, or kNone without any.
  ContactKey unfollowed() const;
  /// Evaluates all contacts at x nearer than `within` [m], followed or not. Returns the contact
  /// that `key` stands for, kNone: there is none.
  ContactKey lookAround(const State& x, double within, ContactKey key);
  /// Why a contact that comes, or goes while it is held, cannot be followed.
  std::string why(ContactKey key) const;
  const Announcements& announcements() const { return announcements_; }
  /// Numbers that are positive where an element would switch.
  const std::vector<double>& switching() const { return switching_; }

  int size() const { return contacts_.size(); }
  const ContactSet& contacts() const { return contacts_; }
  ContactKey key(int i) const { return contacts_.key[static_cast<std::size_t>(i)]; }
  int find(ContactKey key) const;
  const SetValuedForceLaw& law(int i) const { return *contacts_.law[static_cast<std::size_t>(i)]; }
  int row0(int i) const { return contacts_.row0[static_cast<std::size_t>(i)]; }
  /// Gap of a unilateral contact [m].
  double gap(int i) const { return contacts_.position[static_cast<std::size_t>(row0(i))]; }
  /// γ of row r of contact i.
  double gamma(int i, int r = 0) const { return gamma_[row0(i) + r]; }

 private:
  void evaluate(const State& x, const ContactRequest& request);
  const SystemParts* parts_ = nullptr;
  Kinematics kinematics_;
  ContactSet contacts_, one_;
  std::vector<ContactKey> fixed_;  // contacts that do not come and go
  void learn(const State& x);
  std::vector<ContactKey> all_, order_, wide_;
  std::vector<ContactKey> noted_, fresh_;             // noted last; among them not known before
  std::vector<ContactKey> followed_, neverFollowed_;  // noted before, ascending
  ContactKey meets_ = kNone;
  bool notesFresh_ = false;
  bool notes_ = false;  // some pairs of bodies are noted before they touch
  double overlap_ = 0.0;
  Announcements announcements_;
  std::vector<double> switching_;
  Eigen::VectorXd gamma_, gammaOne_;
};

}  // namespace dynamy
