#include <dynamy/integrator/announcements.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <limits>

namespace dynamy {

void Announcements::read(const SystemParts& parts) {
  instants_.clear(), switchers_.clear();
  const auto ask = [&](const Element& e, int contact) {
    Description d;
    e.describe(d);
    for (const Signal& s : d.signals)
      if (s.name == kNextInstant)
        instants_.push_back(s.value);
      else if (s.name == kSwitching && contact >= 0)
        switchers_.push_back({s.value, contact});
  };
  for (const PartialMechanicalSystem* e : parts.topology->systems()) ask(*e, -1);
  for (const ExternalForce* e : parts.forces) ask(*e, -1);
  for (std::size_t i = 0; i < parts.contacts.size(); ++i)
    ask(*parts.contacts[i], static_cast<int>(i));
}

double Announcements::nextInstant(double t) const {
  double first = std::numeric_limits<double>::infinity();
  SignalView view;
  view.t = t;
  for (const SignalFunction& f : instants_) first = std::min(first, f(view));
  return first;
}

void Announcements::switching(const Kinematics& k, std::vector<double>& out) const {
  out.clear();
  SignalView view;
  view.t = k.t(), view.kinematics = &k;
  for (const Switcher& s : switchers_) out.push_back(s.value(view));
}

}  // namespace dynamy
