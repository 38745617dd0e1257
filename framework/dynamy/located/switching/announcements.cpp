#include <dynamy/located/switching/announcements.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <limits>

namespace dynamy {

void Announcements::read(const SystemParts& parts) {
  instants_.clear(), switchers_.clear(), seen_ = nullptr;
  const auto ask = [&](const Element& e, const SystemHandle& system, int contact) {
    Description d;
    e.describe(d);
    for (const Signal& s : d.signals)
      if (s.name == kNextInstant)
        instants_.push_back({s.value, system});
      else if (s.name == kSwitching && (contact >= 0 || system.nq > 0))
        switchers_.push_back({s.value, contact, system});
  };
  const Topology& topology = *parts.topology;
  for (std::size_t i = 0; i < topology.systems().size(); ++i)
    ask(*topology.systems()[i], topology.system(static_cast<int>(i)), -1);
  for (const ExternalForce* e : parts.forces) ask(*e, {}, -1);
  for (std::size_t i = 0; i < parts.contacts.size(); ++i)
    ask(*parts.contacts[i], {}, static_cast<int>(i));
}

double Announcements::nextInstant(double t) const {
  double first = std::numeric_limits<double>::infinity();
  for (const Instant& i : instants_) {
    const bool known = seen_ != nullptr && i.system.nq > 0;
    const SignalView view{.t = t,
                          .q = known ? seen_->q(i.system) : ConstVec(nullptr, 0),
                          .u = known ? seen_->u(i.system) : ConstVec(nullptr, 0)};
    first = std::min(first, i.value(view));
  }
  return first;
}

void Announcements::switching(const Kinematics& k, std::vector<double>& out) {
  seen_ = &k;
  out.clear();
  for (const Switcher& s : switchers_) {
    const bool system = s.element < 0;
    out.push_back(s.value({.t = k.t(),
                           .q = system ? k.q(s.system) : ConstVec(nullptr, 0),
                           .u = system ? k.u(s.system) : ConstVec(nullptr, 0),
                           .kinematics = &k}));
  }
}

}  // namespace dynamy
