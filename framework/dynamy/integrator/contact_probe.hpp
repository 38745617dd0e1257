/// ContactProbe: gaps and relative velocities of all contacts, open ones too, at any state, without
/// masses and forces: what switches are searched with.
#pragma once
#include <dynamy/integrator/announcements.hpp>

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
  /// Why a run is refused where look() failed: the contact that came or went, and the cause.
  std::string unfollowed() const;
  /// The same of a contact that is held and gone.
  std::string lost(ContactKey key) const;
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
  ContactSet contacts_;
  std::string why(ContactKey key, const std::string& what) const;
  std::vector<ContactKey> all_, order_;
  Announcements announcements_;
  std::vector<double> switching_;
  Eigen::VectorXd gamma_;
};

}  // namespace dynamy
