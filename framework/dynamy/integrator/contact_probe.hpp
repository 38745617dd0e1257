/// ContactProbe: gaps and relative velocities of all contacts, open ones too, at any state, without
/// masses and forces: what switches are searched with.
#pragma once
#include <dynamy/integrator/mechanical_system.hpp>

namespace dynamy {

class ContactProbe {
 public:
  /// Why a run is refused where look() fails.
  static constexpr const char* kUnfollowed =
      "contacts appear and disappear (two boxes, rims on edges): their gaps cannot be followed";

  /// Notes all contacts that are reported at x. Those that appear later are a fault.
  void prepare(const MechanicalSystem& s, const State& x);
  /// All contacts at x; false: they are not those noted before.
  bool look(const State& x);

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
  std::vector<ContactKey> all_, order_;
  Eigen::VectorXd gamma_;
};

}  // namespace dynamy
