#include <dynamy/stages/contact_look.hpp>
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

const ContactSet& ContactLook::at(const MechanicalSystem& s, const State& x,
                                  const std::optional<HeldContacts>& held) {
  kinematics_.evaluate(*s.parts().topology, x.t, view(x.q), view(x.u), view(x.memory),
                       s.parts().subset);
  contacts_.clear();
  ContactSink sink(contacts_, contactRequest({.held = held}, s.gTol()), s.parts().subset);
  reportContacts(s.parts(), kinematics_, sink);
  return contacts_;
}

}  // namespace dynamy
