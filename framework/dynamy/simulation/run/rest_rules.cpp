#include <algorithm>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <dynamy/simulation/run/rest_rules.hpp>
#include <dynamy/system/renewable.hpp>
#include <map>

namespace dynamy {
namespace {

std::string text(const Element& e) {
  return "<" + e.type() + (e.name().empty() ? "" : " name=\"" + e.name() + "\"") + ">";
}

/// A contact signal that is recorded or checked: contacts of bodies that sleep have no values.
std::string contactSignalRead(const Model& model) {
  for (const NamedSignal* s : chooseSignals(model, model.record.signals, model.record.places))
    if (s->contact >= 0) return s->name;
  for (const CheckSettings& c : model.checks)
    if (const NamedSignal* s = model.signal(c.signal); s != nullptr && s->contact >= 0)
      return s->name;
  return {};
}

/// What keeps all systems of a model awake; empty: nothing does.
std::string obstacle(const Model& model, bool planned) {
  if (!(model.simulation.sleep > 0.0)) return "sleep= of <simulation> is not given";
  if (planned) return "the run repeats steps that were chosen before";
  const OneStep& scheme = model.scheme();
  if (scheme.choosesSteps()) return "<" + scheme.type() + "> chooses its steps";
  if (!scheme.stepsSome()) return "<" + scheme.type() + "> steps all systems";
  if (model.simulation.project != Project::none) return "project= brings all systems back";
  for (const auto& s : model.systems())
    if (s->stiff()) return text(*s) + " is stiff";
  for (const auto& f : model.forces())
    if (f->stiff()) return text(*f) + " is stiff";
  for (const auto& o : model.observers())
    if (o->readsContacts()) return text(*o) + " reads contacts";
  if (const std::string read = contactSignalRead(model); !read.empty())
    return "the signal " + read + " of a contact is read";
  return {};
}

}  // namespace

RestRules::RestRules(const Model& model, bool planned)
    : may_(model.systems().size(), 0), still_(may_), reason_(obstacle(model, planned)) {
  const auto n = static_cast<int>(model.systems().size());
  for (int i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool timeless = model.description(i).timeless;
    const bool moves = model.topology().system(i).nu > 0;
    may_[at] = moves && timeless && model.systems()[at]->abilities().renewable == nullptr ? 1 : 0;
    still_[at] = !moves && timeless ? 1 : 0;
    if (moves) ++moving_;
  }
  if (!reason_.empty()) return;
  std::map<const Element*, const Connection*> own;
  for (const Connection& c : model.topology().connections()) own.emplace(c.element, &c);
  auto description = model.descriptions().begin() + n;
  const auto ask = [&](const auto& elements) {
    for (const auto& e : elements) {
      const auto found = own.find(e.get());
      follow(model, *e, (description++)->timeless, found != own.end() ? found->second : nullptr);
    }
  };
  ask(model.contacts()), ask(model.forces());
  if (reason_.empty() && resting() == 0)
    reason_ = "no system, with all that acts on it, follows from positions and velocities alone";
}

int RestRules::resting() const {
  return static_cast<int>(std::count_if(may_.begin(), may_.end(), [](char m) { return m != 0; }));
}

/// Keeps awake what an element acts on, if that may move by itself.
void RestRules::follow(const Model& model, const Element& element, bool timeless,
                       const Connection* own) {
  if (!timeless || model.topology().memories().of(element).size > 0) return keepAwake(own, element);
  if (own == nullptr || own->shapes) return;  // bodies that touch something that moves stay awake
  if (std::any_of(own->systems.begin(), own->systems.end(),
                  [&](int i) { return model.topology().system(i).nu == 0 && !still(i); }))
    keepAwake(own, element);
}

/// Keeps awake what an element requested, or everything.
void RestRules::keepAwake(const Connection* own, const Element& element) {
  if (own != nullptr && !own->shapes && !own->systems.empty()) {
    for (const int i : own->systems) may_[static_cast<std::size_t>(i)] = 0;
    return;
  }
  std::fill(may_.begin(), may_.end(), 0);
  if (reason_.empty()) reason_ = text(element) + " may act on any system at any time";
}

}  // namespace dynamy
