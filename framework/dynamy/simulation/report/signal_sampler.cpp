#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <unordered_map>
#include <utility>

namespace dynamy {
namespace {

/// True for signals that serve only schemes that locate switches. They are no use in tables:
/// nextInstant is infinite if no instant follows.
bool isAnnouncement(std::string_view name) {
  for (const char* announced : {kNextInstant, kNextSample, kSwitching})
    if (name.ends_with("." + std::string(announced))) return true;
  return false;
}

bool matches(std::string_view name, std::string_view pattern) {
  if (!pattern.empty() && pattern.back() == '*')
    return name.starts_with(pattern.substr(0, pattern.size() - 1));
  return name == pattern;
}

/// Is this the name of a signal of a contact, as describeContact() makes them?
bool isOfContact(std::string_view name) {
  for (const char* part : {".lambda_", ".Lambda_", ".gamma_"})
    if (name.find(part) != std::string_view::npos) return true;
  return name.ends_with(".status") || name.ends_with(".g");
}

Diagnostic unknownSignal(const Model& model, const std::string& name, const Place& place) {
  std::vector<std::string> known;
  for (const NamedSignal& s : model.signals()) known.push_back(s.name);
  Diagnostic d;
  d.place = place;
  d.element = "record";
  d.text = "no signal named \"" + name + "\"";
  d.hint = unknownNameHint(name, known);
  if (isOfContact(name) && name.find('-') != std::string::npos)
    d.hint +=
        "; contacts of two shapes have signals A-B.lambda_N, and A-B.FEATURE.lambda_N for each "
        "place, where at most 64 pairs of shapes can touch; the sum on a <Ground> is its Fx, Fy, "
        "Fz";
  return d;
}

}  // namespace

std::vector<const NamedSignal*> chooseSignals(const Model& model,
                                              const std::vector<std::string>& names,
                                              const std::vector<Place>& places) {
  std::vector<const NamedSignal*> out;
  if (names.empty()) {
    for (const NamedSignal& s : model.signals())
      if (s.system >= 0 && !isAnnouncement(s.name)) out.push_back(&s);
    return out;
  }
  const std::vector<NamedSignal>& all = model.signals();
  std::unordered_multimap<std::string_view, std::size_t> byName;
  for (std::size_t k = 0; k < all.size(); ++k) byName.emplace(all[k].name, k);
  std::vector<bool> taken(all.size(), false);
  std::vector<std::size_t> found;
  Diagnostics faults;
  for (std::size_t i = 0; i < names.size(); ++i) {
    found.clear();
    if (names[i].ends_with('*')) {
      for (std::size_t k = 0; k < all.size(); ++k)
        if (matches(all[k].name, names[i])) found.push_back(k);
    } else {
      const auto [begin, end] = byName.equal_range(names[i]);
      for (auto at = begin; at != end; ++at) found.push_back(at->second);
      std::sort(found.begin(), found.end());
    }
    for (const std::size_t k : found) {
      if (!taken[k]) out.push_back(&all[k]);
      taken[k] = true;
    }
    if (found.empty())
      faults.add(unknownSignal(model, names[i], i < places.size() ? places[i] : Place{}));
  }
  faults.throwIfAny();
  return out;
}

SignalSampler::SignalSampler(const Model& model, std::vector<const NamedSignal*> signals)
    : model_(model), signals_(std::move(signals)) {
  kinematics_.resize(model.topology());
  for (const NamedSignal* s : signals_) {
    ofContacts_ = ofContacts_ || s->contact >= 0;
    readsForces_ = readsForces_ || isOfForces(*s);
  }
}

/// Forces of contacts and joints, which are no signals of the state, and their statuses.
bool SignalSampler::isOfForces(const NamedSignal& s) {
  if (s.contact < 0 || s.signal.ofState) return false;
  return s.signal.unit == Unit::force || s.signal.unit == Unit::torque ||
         s.name.ends_with("status");
}

void SignalSampler::sampleForces(const StepView& first, std::span<double> out) {
  if (!readsForces_) return;
  place(first, 0.0, ofContacts_);
  for (std::size_t i = 0; i < signals_.size(); ++i)
    if (isOfForces(*signals_[i])) out[i] = value(first, *signals_[i]);
}

void SignalSampler::look(const StepView& view, bool after, bool ofContacts) {
  known_ = ofContacts && view.report.dt > 0.0 &&
           view.scheme.contactsAt(view.system, at_, after, instant_);
  if (known_) instant_.lambda *= view.report.dt;
}

void SignalSampler::place(const StepView& view, double theta, bool ofContacts) {
  const bool after = theta >= 1.0 || view.report.dt <= 0.0;
  if (after) {
    at_.t = view.after.t, at_.q = view.after.q, at_.u = view.after.u;
    at_.memory = view.after.memory;
  } else {
    view.scheme.interpolate(view.system, view.before, view.after, theta, at_);
    at_.memory = view.before.memory;  // elements change their memory at the ends of steps alone
  }
  kinematics_.evaluate(model_.topology(), at_.t, dynamy::view(std::as_const(at_.q)),
                       dynamy::view(std::as_const(at_.u)), dynamy::view(std::as_const(at_.memory)));
  look(view, after, ofContacts);
}

void SignalSampler::placeBeforeImpact(const StepView& view, bool ofContacts) {
  at_.t = view.after.t, at_.q = view.after.q, at_.memory = view.before.memory;
  at_.u = view.report.uBeforeImpact != nullptr ? *view.report.uBeforeImpact : view.after.u;
  kinematics_.evaluate(model_.topology(), at_.t, dynamy::view(std::as_const(at_.q)),
                       dynamy::view(std::as_const(at_.u)), dynamy::view(std::as_const(at_.memory)));
  look(view, false, ofContacts);
}

double SignalSampler::value(const StepView& view, const NamedSignal& s) const {
  const auto part = [](const Eigen::VectorXd& v, int first, int n) {
    return ConstVec(v.data() + first, n);
  };
  SignalView seen;
  seen.t = at_.t;
  if (s.system >= 0) {
    const SystemHandle& h = model_.topology().system(s.system);
    new (&seen.q) ConstVec(part(at_.q, h.q0, h.nq));
    new (&seen.u) ConstVec(part(at_.u, h.u0, h.nu));
  }
  seen.kinematics = &kinematics_;
  seen.contacts = seen.stepContacts = &view.system.slot(0).contacts;
  new (&seen.Lambda) ConstVec(view.Lambda);
  new (&seen.stepLambda) ConstVec(view.Lambda);
  new (&seen.gammaE) ConstVec(view.gammaE);
  if (known_) {
    seen.contacts = instant_.contacts;
    new (&seen.Lambda) ConstVec(instant_.lambda.data(), instant_.lambda.size());
    new (&seen.gammaE) ConstVec(instant_.gamma.data(), instant_.gamma.size());
  }
  new (&seen.memory) ConstVec(part(at_.memory, s.memory0, s.memory));
  seen.dt = view.report.dt;
  seen.element = s.contact;
  return s.signal.value(seen);
}

void SignalSampler::sample(const StepView& view, double theta, std::span<double> out) {
  if (signals_.empty()) return;
  place(view, theta, ofContacts_);
  for (std::size_t i = 0; i < signals_.size(); ++i) out[i] = value(view, *signals_[i]);
}

double SignalSampler::sampleOne(const StepView& view, double theta, std::size_t i) {
  place(view, theta, signals_[i]->contact >= 0);
  return value(view, *signals_[i]);
}

void SignalSampler::sampleBeforeImpact(const StepView& view, std::span<double> out) {
  if (signals_.empty()) return;
  placeBeforeImpact(view, ofContacts_);
  for (std::size_t i = 0; i < signals_.size(); ++i) out[i] = value(view, *signals_[i]);
}

double SignalSampler::sampleBeforeImpact(const StepView& view, std::size_t i) {
  placeBeforeImpact(view, signals_[i]->contact >= 0);
  return value(view, *signals_[i]);
}

}  // namespace dynamy
