#include <algorithm>
#include <dynamy_elements/coordinates/reservoir_switch.hpp>
#include <limits>

namespace dynamy {

void ReservoirSwitch::declare(Attributes& a, const std::string& variables) {
  a.add(AttributeType::expression, "scale", "",
        "factor on the force reservoir of the law, a formula of " + variables +
            "; below 0 it counts as 0");
  a.add(AttributeType::expression, "engage", "",
        "the law acts once this formula of " + variables +
            " is positive at the end of a step; default: always");
  a.add(AttributeType::expression, "release", "",
        "it stops acting once this formula is positive; default: never, a latch");
}

ReservoirSwitch::ReservoirSwitch(const Parameters& x)
    : scaleText_(x, "scale"), engageText_(x, "engage"), releaseText_(x, "release") {
  for (const FormulaText* text : {&scaleText_, &engageText_, &releaseText_})
    if (text->size() > 1) throw ModelError(text->fault(-1, "expects one formula"));
  if (engageText_.empty() && !releaseText_.empty())
    throw ModelError(releaseText_.fault(-1, "release is given, engage is not",
                                        "what always acts has nothing to be released from"));
}

void ReservoirSwitch::connect(Topology& topology, const Element& owner,
                              const SetValuedForceLaw& law, const FormulaNames& own) {
  if (!given()) return;
  FormulaNames names = own;
  for (const FormulaText* text : {&scaleText_, &engageText_, &releaseText_})
    for (int i = 0; i < text->size(); ++i)
      for (const auto& [name, place] : text->signals(i)) {
        if (names.symbols().find(name) != nullptr) continue;
        names.signals.push_back(name);
        signals_.push_back(topology.signal(name, place, owner));
      }
  inputs_.assign(static_cast<std::size_t>(names.inputs()), 0.0);
  Diagnostics faults;
  ExpressionCompiler scale(names.symbols()), engage(names.symbols());
  scaleText_.compileAll(scale, faults);
  engageText_.compileAll(engage, faults);
  releaseText_.compileAll(engage, faults);
  if (!scaleText_.empty() && !law.scales())
    faults.add(
        scaleText_.fault(-1, "the law has no size of its own that could be scaled",
                         "GivenFriction, ForceLimit, StribeckFriction, PreloadedSpring have"));
  faults.throwIfAny();
  if (!scaleText_.empty()) scale_ = std::make_unique<Tape>(scale.finish(), names);
  if (engageText_.empty()) return;
  engage_ = std::make_unique<Tape>(engage.finish(), names);
  memory_ = topology.memory(owner, {0.0});
}

bool ReservoirSwitch::engaged(const Kinematics& k) const {
  return !engage_ || k.memory(memory_)[0] > 0.0;
}

const double* ReservoirSwitch::withSignals(const Kinematics& k, const double* x) const {
  if (signals_.empty()) return x;
  auto next = std::copy_n(x, inputs_.size() - signals_.size(), inputs_.begin());
  for (const SignalHandle h : signals_) *next++ = k.signal(h);
  return inputs_.data();
}

double ReservoirSwitch::scale(const Kinematics& k, const double* x) const {
  if (!scale_) return 1.0;
  const double s = scale_->eval(withSignals(k, x))[0];
  return s < 0.0 ? 0.0 : s;  // NaN is returned as NaN
}

void ReservoirSwitch::remember(const Kinematics& k, const double* x, Vec memory) const {
  if (!engage_) return;
  const double* value = engage_->eval(withSignals(k, x));
  const bool let = !releaseText_.empty() && value[1] > 0.0;
  if (let)
    memory[0] = 0.0;
  else if (value[0] > 0.0)
    memory[0] = 1.0;
}

double ReservoirSwitch::switching(const Kinematics& k, const double* x) const {
  const double* value = engage_->eval(withSignals(k, x));
  const bool lets = !releaseText_.empty();
  if (engaged(k)) return lets ? value[1] : -1.0;
  return lets ? std::min(value[0], -value[1]) : value[0];
}

double ReservoirSwitch::nextInstant(double t) const {
  double next = std::numeric_limits<double>::infinity();
  for (const Tape* tape : {scale_.get(), engage_.get()})
    if (tape) next = std::min(next, tape->nextInstant(t));
  return next;
}

void ReservoirSwitch::describe(Description& d) const {
  if (!engage_) return;
  d.signal("engaged", Unit::none, "1 while the law acts, else 0",
           [](const SignalView& v) { return v.memory[0]; });
  d.signals.back().ofState = true;
}

}  // namespace dynamy
