#include <dynamy/stages/closing_contacts.hpp>
#include <dynamy/stages/contact_subset.hpp>

namespace dynamy {
namespace {

/// Part of g/Δt that counts as rounding.
constexpr double kRounding = 1e-14;

}  // namespace

bool ClosingContacts::reduce(ContactSet& c, ConstVec uFree, double dt, double gTol,
                             const RememberedImpulses& pressed) {
  if (aside_ > 0 || !worthLeavingOut(c.size(), c.size()) || !c.bias.empty()) return false;
  asks_.assign(static_cast<std::size_t>(c.size()), 1);
  bool known = false;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double g = c.position[static_cast<std::size_t>(c.row0[at])];
    if (!c.law[at]->unilateral() || !(g > gTol) || !staysOpen(c, i, uFree, dt)) continue;
    if (!known) old_.build(pressed.key), known = true;
    const int found = old_.find(c.key[at]);
    const bool pressing =
        found >= 0 &&
        pressed.first[static_cast<std::size_t>(found) + 1] >
            pressed.first[static_cast<std::size_t>(found)] &&
        pressed.Lambda[static_cast<std::size_t>(pressed.first[static_cast<std::size_t>(found)])] >
            0.0;
    if (!pressing) asks_[at] = 0, ++aside_;
  }
  if (!worthLeavingOut(aside_, c.size())) {
    aside_ = 0;
    return false;
  }
  std::swap(all_, c);
  write(c);
  return true;
}

bool ClosingContacts::bringIn(ContactSet& c, const Eigen::VectorXd& uE, double dt) {
  if (aside_ == 0) return false;
  bool closes = false;
  for (int i = 0; i < all_.size() && !closes; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double open = all_.position[static_cast<std::size_t>(all_.row0[at])] / dt;
    closes = asks_[at] == 0 && open + gapRate(all_, i, view(uE)).gamma < -kRounding * open;
  }
  if (!closes) return false;
  // Contacts near closing are added, too: a chain of contacts must not take one solution per link.
  for (int i = 0; i < all_.size(); ++i)
    if (char& asks = asks_[static_cast<std::size_t>(i)];
        asks == 0 && !staysOpen(all_, i, view(uE), dt))
      asks = 1, --aside_;
  write(c);
  return true;
}

/// c ← the contacts of all_ that the step has to solve for; all candidates stay.
void ClosingContacts::write(ContactSet& c) const {
  c.clear();
  c.candidateKey = all_.candidateKey, c.g = all_.g, c.candidateElement = all_.candidateElement;
  c.closedIndex.assign(all_.closedIndex.size(), -1);
  c.features.noted = all_.features.noted, c.features.comeAndGo = all_.features.comeAndGo;
  c.features.overlap = all_.features.overlap, c.features.deepest = all_.features.deepest;
  for (int i = 0; i < all_.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (asks_[at] == 0) continue;
    c.closedIndex[static_cast<std::size_t>(all_.candidate[at])] = c.size();
    append(all_, i, all_.dim(i), *all_.law[at], c);
    c.places.add(all_.places, at);
    if (!all_.features.presence.empty()) {
      c.features.presence.push_back(all_.features.presence[at]);
      c.features.circle.push_back(all_.features.circle[at]);
    }
  }
}

}  // namespace dynamy
