/// ContactProbe: gaps and relative velocities of all contacts, open ones too, at any state, without
/// masses and forces: what switches are searched with.
///
/// Contacts that come and go with the features of bodies are gathered anew before every step and
/// every event, and widened by those that the bodies may meet with along the path of a step. Those
/// of bodies that no gap follows while they touch are noted as well, but not reported by their
/// names: where they are met what is followed ends.
#pragma once
#include <dynamy/located/switching/announcements.hpp>

namespace dynamy {

class ContactProbe {
 public:
  /// The fault where look() failed: unfollowed() says why.
  static constexpr std::string_view kUnfollowed = "contacts appear and disappear";

  /// Notes all contacts that are reported at x. Those that appear later are a fault.
  void prepare(const MechanicalSystem& s, const State& x);
  /// Notes them anew: after something was switched, or bodies were taken away or brought.
  void list(const State& x);
  /// All contacts at x; false: they are not those noted before.
  bool look(const State& x);
  /// Gap, presence and γ of contact i of the last look() at x; those of all others stay.
  bool lookAt(const State& x, int i);
  /// True: some contacts come and go.
  bool comesAndGoes() const { return contacts_.comesAndGoes; }
  /// True: contacts have to be gathered before each step.
  bool gathers() const { return comesAndGoes() || notes_; }
  /// Of those that come and go from now on the ones that may touch at x and the `held`; all at x.
  bool gather(const State& x, std::span<const ContactKey> held);
  /// From the next settle() on also those that may touch within `ahead` [s] of x.
  void widen(const State& x, double ahead);
  bool settle(const State& x);
  /// True: where it was gathered or widened last, bodies may meet that cannot be followed.
  bool meets() const { return meets_ != kNone; }
  ContactKey met() const { return meets_; }
  /// True: widened last by some that are not among those looked at.
  bool notesFresh() const { return notesFresh_; }
  /// How deep bodies with such contacts overlap where it was gathered or widened last [m].
  double overlap() const { return overlap_; }
  /// Positive while the features of contact i lie over one another [m].
  double presence(int i) const { return contacts_.presence[static_cast<std::size_t>(i)]; }
  bool comesAndGoes(int i) const { return presence(i) < ContactSet::kAlways; }
  /// True: contacts i and j, which come and go, are at one place with one normal.
  bool coincide(int i, int j, double distance) const;
  static constexpr ContactKey kNone{~std::uint64_t{0}};
  /// The contact that came or went where look() failed; kNone: they came in another order.
  ContactKey unfollowed() const;
  /// All contacts at x nearer than `within` [m], followed or not. The one that `key` stands for,
  /// kNone: there is none.
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
  std::vector<ContactKey> fixed_;  // those that do not come and go
  void learn(const State& x);
  std::vector<ContactKey> all_, order_, wide_;
  std::vector<ContactKey> noted_, fresh_;             // noted last; of these not known before
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
