#include <algorithm>
#include <cmath>
#include <dynamy/schemes/augmented/closed_contacts.hpp>
#include <dynamy/stages/displacement_level.hpp>

namespace dynamy {
namespace {

/// A contact slower than this multiple of the change by forces in a step has the rest of a rebound.
constexpr double kSettles = 4.0;

}  // namespace

void ClosedContacts::begin(const State& x) {
  lastDt_ = x.impulses.dt;
  pressed_.clear();
  addPressed(x.impulses, pressed_);
}

const ContactSet& ClosedContacts::at(const MechanicalSystem& s, const State& x,
                                     const ContactRequest& request) {
  const Topology& topology = *s.parts().topology;
  if (!ready_) kinematics_.resize(topology), ready_ = true;
  kinematics_.evaluate(topology, x.t, view(x.q), view(x.u), view(x.memory));
  contacts_.clear();
  ContactSink sink(contacts_, request);
  for (std::size_t i = 0; i < s.parts().contacts.size(); ++i) {
    sink.element(static_cast<int>(i));
    s.parts().contacts[i]->contacts(kinematics_, sink);
  }
  return contacts_;
}

void ClosedContacts::find(const MechanicalSystem& s, const State& x) {
  ContactRequest request;
  request.gTol = s.gTol();
  closed_ = pressed_;
  addKeys(at(s, x, request), closed_);
}

bool ClosedContacts::othersAreOpen(const MechanicalSystem& s, const State& x) {
  ContactRequest gapsAlone;
  gapsAlone.refresh = true;
  return !anyPassed(at(s, x, gapsAlone), 0.0);
}

bool ClosedContacts::anyPassed(const ContactSet& c, double least) const {
  for (std::size_t i = 0; i < c.g.size(); ++i)
    if (c.g[i] <= least && !std::binary_search(closed_.begin(), closed_.end(), c.candidateKey[i]))
      return true;
  return false;
}

void ClosedContacts::settle(const DiscreteState& sigma, double h, InclusionProblem& p) const {
  const double longer = std::max(1.0, lastDt_ / h);
  const auto isIn = [](const std::vector<ContactKey>& keys, ContactKey key) {
    return std::binary_search(keys.begin(), keys.end(), key);
  };
  for (int i = 0; i < p.size(); ++i) {
    if (!p.law(i).unilateral()) continue;
    const ContactKey key = p.contacts->key[static_cast<std::size_t>(i)];
    const auto row = static_cast<std::size_t>(p.row0(i));
    // Right after a switch: the contact is no faster than forces made it in the step before.
    const double byForces = std::abs(p.gammaFree[row] - p.gammaA[row]) * longer;
    const bool settles = isIn(pressed_, key) && std::abs(p.gammaA[row]) <= kSettles * byForces;
    if (sigma.known() ? isIn(sigma.carrying(), key) : settles) p.gammaA[row] = 0.0;
  }
}

}  // namespace dynamy
