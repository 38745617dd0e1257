#include <algorithm>
#include <dynamy/located/islands/island_contacts.hpp>

namespace dynamy {

std::span<const HeldStatus> IslandContacts::statuses(const IslandClocks& clocks, double t) {
  statuses_.clear();
  for (const auto& c : clocks) {
    const std::vector<HeldStatus>& own = c->now().statuses(t);
    statuses_.insert(statuses_.end(), own.begin(), own.end());
  }
  std::sort(statuses_.begin(), statuses_.end(),
            [](const HeldStatus& a, const HeldStatus& b) { return a.key < b.key; });
  return statuses_;
}

/// The contacts that may close in the steps of the clocks; null: all.
const NearContacts* IslandContacts::near(const IslandClocks& clocks) {
  near_.clear();
  for (const auto& c : clocks) {
    const NearContacts* own = c->motion().motion().parts().probe.near();
    if (own == nullptr) return nullptr;
    near_.add(*own);
  }
  near_.order();
  return &near_;
}

void IslandContacts::report(MechanicalSystem& s, const IslandClocks& clocks, const State& x,
                            std::span<const Percussion> percussions, StepReport& report) {
  report.statuses = statuses(clocks, x.t), report.ownStatuses = true;
  keys_.clear();
  for (const HeldStatus& status : statuses_) keys_.push_back(status.key);
  for (const Percussion& q : percussions) keys_.push_back(q.key);
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  report.uBeforeImpact = nullptr;
  for (const auto& c : clocks) {
    const IslandStep& step = c->now();
    if (step.to.t != x.t || step.report.uBeforeImpact == nullptr) continue;
    if (report.uBeforeImpact == nullptr) uBefore_ = x.u, report.uBeforeImpact = &uBefore_;
    c->giveVelocities(*step.report.uBeforeImpact, uBefore_);
  }
  s.evaluate(
      x, {.slot = 0, .held = HeldContacts{.keys = keys_, .follow = true, .near = near(clocks)}});
  write(s, percussions, x, report.dt);
  report.contacts = s.slot(0).contacts.size();
}

/// Writes percussions into the problem of slot 0, those of one contact added up.
void IslandContacts::write(MechanicalSystem& s, std::span<const Percussion> percussions,
                           const State& x, double dt) {
  ImpactProblem& p = s.impactProblem(x, dt);
  clearPercussions(p, x);
  const ContactSet& c = *p.contacts;
  index_.build(c.key);
  for (const Percussion& q : percussions) {
    const int k = index_.find(q.key);
    if (k < 0) continue;
    const int row = c.row0[static_cast<std::size_t>(k)];
    for (int r = 0; r < std::min(c.dim(k), q.dim); ++r) {
      const auto at = static_cast<std::size_t>(r);
      p.Lambda()[row + r] += q.Lambda[at];
      p.gammaA[static_cast<std::size_t>(row + r)] = q.gammaMinus[at];
    }
  }
  p.gammaFree = p.gammaA;
}

bool IslandContacts::at(MechanicalSystem& s, const IslandClocks& clocks, const State& at,
                        bool after, ContactInstant& out) {
  keys_.clear();
  for (const auto& c : clocks)
    for (const double t : {c->now().from.t, c->now().to.t})
      for (const HeldStatus& status : c->now().statuses(t)) keys_.push_back(status.key);
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  const ContactSet& c =
      s.evaluate(at, {.slot = 1,
                      .held = HeldContacts{.keys = keys_, .follow = true, .near = near(clocks)}})
          .contacts;
  out.contacts = &c;
  out.lambda.setZero(c.rows()), out.gamma.resize(c.rows());
  c.gamma(view(at.u), view(out.gamma));
  index_.build(c.key);
  ContactInstant own;
  for (const auto& clock : clocks) {
    const long evaluations = clock->system().evaluations();
    const bool known = clock->contactsAt(at, after && clock->now().to.t == at.t, own);
    s.count(clock->system().evaluations() - evaluations);
    if (!known) return false;
    for (int i = 0; i < own.contacts->size(); ++i) {
      const int k = index_.find(own.contacts->key[static_cast<std::size_t>(i)]);
      if (k < 0) continue;
      const int rows = std::min(c.dim(k), own.contacts->dim(i));
      out.lambda.segment(c.row0[static_cast<std::size_t>(k)], rows) =
          own.lambda.segment(own.contacts->row0[static_cast<std::size_t>(i)], rows);
    }
  }
  return true;
}

}  // namespace dynamy
