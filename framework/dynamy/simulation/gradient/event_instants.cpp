#include <cmath>
#include <dynamy/simulation/gradient/event_instants.hpp>
#include <dynamy/simulation/gradient/followed_run.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <limits>

namespace dynamy {
namespace {

using Happening = WantedInstant::What;
constexpr int kPassParts = 32;       ///< of a step, in which a signal passes a value once
constexpr int kPassBisections = 60;  ///< of such a part

bool isOfSignal(const WantedInstant& w) {
  return w.what == Happening::rise || w.what == Happening::fall;
}

std::vector<const NamedSignal*> passingSignals(const Model& model,
                                               const std::vector<WantedInstant>& wanted) {
  std::vector<const NamedSignal*> out;
  for (const WantedInstant& w : wanted)
    if (isOfSignal(w)) out.push_back(signalNamed(model, w.of));
  return out;
}

}  // namespace

EventInstants::EventInstants(const Model& model, const std::vector<WantedInstant>& wanted)
    : wanted_(wanted),
      sampler_(model, passingSignals(model, wanted)),
      instants_(wanted.size(), std::numeric_limits<double>::quiet_NaN()),
      counts_(wanted.size(), 0) {
  std::size_t next = 0;
  for (const WantedInstant& w : wanted) signal_.push_back(isOfSignal(w) ? next++ : 0);
}

void EventInstants::found(std::size_t i, double t) {
  if (++counts_[i] == wanted_[i].count) instants_[i] = t;
}

bool EventInstants::isNamed(const Model& model, ContactKey key, std::size_t i) const {
  const std::string name = contactName(model, key);
  return name == wanted_[i].of || name.rfind(wanted_[i].of + "/", 0) == 0;
}

void EventInstants::impacts(const StepView& view, std::size_t i) {
  for (const LocatedImpact& impact : view.report.impacts)
    if (isNamed(view.model, impact.key, i)) return found(i, impact.t);
}

void EventInstants::statuses(const StepView& view, std::size_t i) {
  for (const HeldStatus& now : view.report.statuses) {
    const auto before = status_.find(now.key.value);
    const Status was = before == status_.end() ? Status::open : before->second;
    if (now.status == wanted_[i].status && was != now.status && isNamed(view.model, now.key, i))
      return found(i, view.after.t);
  }
  if (wanted_[i].status != Status::open) return;
  // A contact without a status is open.
  for (const auto& [key, was] : status_) {
    bool held = was == Status::open;
    for (const HeldStatus& now : view.report.statuses) held = held || now.key.value == key;
    if (!held && isNamed(view.model, ContactKey{key}, i)) return found(i, view.after.t);
  }
}

double EventInstants::side(const StepView& view, double theta, std::size_t i) {
  const double sign = wanted_[i].what == Happening::fall ? -1.0 : 1.0;
  return sign * (sampler_.sampleOne(view, theta, signal_[i]) - wanted_[i].value);
}

void EventInstants::passes(const StepView& view, std::size_t i) {
  const double sign = wanted_[i].what == Happening::fall ? -1.0 : 1.0;
  const double tA = view.before.t, dt = view.after.t - tA;
  const bool jumps = view.report.uBeforeImpact != nullptr;
  double before = side(view, 0.0, i);
  for (int k = 1; k <= kPassParts; ++k) {
    const bool last = k == kPassParts && jumps;
    const double after =
        last ? sign * (sampler_.sampleBeforeImpact(view, signal_[i]) - wanted_[i].value)
             : side(view, static_cast<double>(k) / kPassParts, i);
    if (before < 0.0 && after >= 0.0) {
      double a = static_cast<double>(k - 1) / kPassParts, b = static_cast<double>(k) / kPassParts;
      for (int n = 0; n < kPassBisections; ++n)
        (side(view, 0.5 * (a + b), i) < 0.0 ? a : b) = 0.5 * (a + b);
      found(i, tA + b * dt);
    }
    before = after;
  }
  // An impact takes the signal across.
  if (jumps && before < 0.0 && side(view, 1.0, i) >= 0.0) found(i, view.after.t);
}

void EventInstants::step(const StepView& view) {
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (isOfSignal(wanted_[i]))
      passes(view, i);
    else if (wanted_[i].what == Happening::impact)
      impacts(view, i);
    else if (known_)
      statuses(view, i);
  }
  status_.clear();
  for (const HeldStatus& s : view.report.statuses) status_[s.key.value] = s.status;
  known_ = true;
}

}  // namespace dynamy
