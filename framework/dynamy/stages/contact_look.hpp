/// ContactLook: contacts alone at a state, without masses and forces.
#pragma once
#include <dynamy/stages/evaluation.hpp>

namespace dynamy {

class MechanicalSystem;

class ContactLook {
 public:
  /// Contacts at x as an evaluation would report them, without their bias. This is no evaluation of
  /// the system, and what it returns is valid until the next look.
  const ContactSet& at(const MechanicalSystem& s, const State& x,
                       const std::optional<HeldContacts>& held = {});

 private:
  Kinematics kinematics_;
  ContactSet contacts_;
};

}  // namespace dynamy
