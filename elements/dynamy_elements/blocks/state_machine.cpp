#include <algorithm>
#include <cmath>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy_elements/blocks/state_machine.hpp>
#include <limits>

namespace dynamy {
namespace {

const std::vector<std::string> kOwnNames{"time", "value"};

[[noreturn]] void refuse(const Place& place, const char* element, std::string text,
                         std::string hint) {
  Diagnostic d;
  d.place = place, d.element = element, d.text = std::move(text), d.hint = std::move(hint);
  throw ModelError(std::move(d));
}

}  // namespace

// ---- Transition --------------------------------------------------------------------------------

void Transition::declare(Attributes& a) {
  a.about("Transition of a StateMachine from one state to another.");
  a.add(AttributeType::text, "from", std::nullopt, "state that it leaves");
  a.add(AttributeType::text, "to", std::nullopt, "state that becomes active");
  a.add(AttributeType::expression, "when", std::nullopt,
        "guard: it takes place where this formula of t, signals, time (since the state became "
        "active) and value becomes positive, e.g. cart.x - 1; default: always")
      .mayBeAbsent();
  Attribute& after = a.add(AttributeType::number, "after", std::nullopt,
                           "least time in the state before it [s]; default: 0");
  after.unit = Unit::time;
  after.mayBeAbsent().nonNegative();
  a.add(
       AttributeType::expression, "set", std::nullopt,
       "action: new value of the machine, a formula of t, signals, time and value, e.g. value + 1; "
       "default: unchanged")
      .mayBeAbsent();
  a.example("<Transition from=\"closed\" to=\"open\" when=\"cart.x - 1\" set=\"value + 1\"/>");
}

Transition::Transition(const Parameters& x)
    : Element(x),
      fromName_{x["from"].text, x["from"].place},
      toName_{x["to"].text, x["to"].place},
      when_(x, "when", 1, kOwnNames),
      set_(x, "set", 1, kOwnNames),
      after_(x.has("after") ? double(x["after"]) : -1.0) {
  const std::string& text = x["when"].text;
  if (when_.empty() && after_ < 0.0)
    throw ModelError("the transition has neither when nor after",
                     "when=\"cart.x - 1\" is a guard, after=\"2s\" a time");
  if (const auto at = text.find_first_of("<>="); at != std::string::npos)
    throw x["when"].fault("a guard is a formula that becomes positive, no comparison",
                          "cart.x - 1 in place of cart.x > 1; min(a, b) for both, max(a, b) for "
                          "either",
                          at, 1);
}

int Transition::number(const Named& state, const std::vector<std::string>& states) const {
  const auto at = std::find(states.begin(), states.end(), state.name);
  if (at == states.end())
    refuse(state.place, "Transition", "the machine has no state \"" + state.name + "\"",
           unknownNameHint(state.name, states));
  return static_cast<int>(at - states.begin());
}

void Transition::bind(const std::vector<std::string>& states) {
  from_ = number(fromName_, states), to_ = number(toName_, states);
}

void Transition::connect(Topology& topology, const Element& owner) {
  when_.connect(topology, owner), set_.connect(topology, owner);
}

double Transition::guard(const Kinematics& k, const double* own) const {
  const double waited = own[0] - after_;
  if (when_.empty()) return waited;
  const double s = when_.value(k, own);
  return after_ < 0.0 ? s : std::min(s, waited);
}

double Transition::newValue(const Kinematics& k, const double* own) const {
  return set_.empty() ? own[1] : set_.value(k, own);
}

// ---- StateMachine ------------------------------------------------------------------------------

void StateMachine::declare(Attributes& a) {
  a.about(
      "States with names, of which one is active, and transitions with guards, which runs to a "
      "tolerance locate. Signals: out, state (number of the active one, from 0), time since it "
      "became active, value.");
  a.add(AttributeType::names, "states", std::nullopt, "names of the states");
  a.add(AttributeType::text, "start", std::nullopt, "active state at the start; default: the first")
      .mayBeAbsent();
  a.add(AttributeType::expressions, "out", "",
        "output in each state, formulas of t, signals, time and value, separated by ';'; default: "
        "the number of the state");
  a.optional("value", Unit::any, 0.0, "a number that transitions set, at the start");
  a.child(Kind::part, 1, 1000, "transitions between the states", "Transition");
  a.example(
      "<StateMachine name=\"gate\" states=\"closed open\" out=\"0; 5\">"
      "<Transition from=\"closed\" to=\"open\" when=\"cart.x - 1\"/>"
      "<Transition from=\"open\" to=\"closed\" after=\"2s\"/></StateMachine>");
}

StateMachine::StateMachine(const Parameters& x)
    : NonSmoothElement(x),
      states_(x["states"].words()),
      transitions_(x.take<Transition>()),
      value_(x["value"]) {
  for (auto at = states_.begin(); at != states_.end(); ++at)
    if (std::find(states_.begin(), at, *at) != at)
      throw x["states"].fault("state \"" + *at + "\" is named twice", "", 0,
                              x["states"].text.size());
  if (!x["out"].text.empty()) out_ = {x, "out", static_cast<int>(states_.size()), kOwnNames};
  if (x.has("start")) {
    const auto at = std::find(states_.begin(), states_.end(), x["start"].text);
    if (at == states_.end())
      throw x["start"].fault("the machine has no state \"" + x["start"].text + "\"",
                             unknownNameHint(x["start"].text, states_), 0, x["start"].text.size());
    start_ = static_cast<int>(at - states_.begin());
  }
  for (const auto& t : transitions_) t->bind(states_);
  outs_.resize(states_.size());
}

void StateMachine::connect(Topology& topology) {
  memory_ = topology.memory(*this, {static_cast<double>(start_), 0.0, value_});
  out_.connect(topology, *this);
  for (const auto& t : transitions_) t->connect(topology, *this);
}

double StateMachine::monitor(const Kinematics& k, const double* held, int* first) const {
  const double own[2] = {k.t() - held[kSince], held[kValue]};
  const int active = static_cast<int>(held[kActive]);
  double most = -std::numeric_limits<double>::infinity();
  *first = -1;
  for (std::size_t i = 0; i < transitions_.size(); ++i) {
    if (transitions_[i]->from() != active) continue;
    const double s = transitions_[i]->guard(k, own);
    if (s > 0.0 && *first < 0) *first = static_cast<int>(i);
    most = std::max(most, s);
  }
  // A state that nothing leaves has no root to look for.
  return std::isfinite(most) ? most : -1.0;
}

void StateMachine::remember(const Kinematics& k, Vec memory) const {
  for (std::size_t count = 0; count < states_.size(); ++count) {
    int due = -1;
    monitor(k, memory.data(), &due);
    if (due < 0) return;
    const Transition& t = *transitions_[static_cast<std::size_t>(due)];
    const double own[2] = {k.t() - memory[kSince], memory[kValue]};
    memory[kValue] = t.newValue(k, own);
    memory[kActive] = t.to(), memory[kSince] = k.t();
  }
}

std::string StateMachine::memoryFault(ConstVec memory) const {
  const double active = memory[kActive];
  const auto states = static_cast<double>(states_.size());
  if (active >= 0.0 && active < states && active == std::floor(active)) return {};
  return "it has no state with this number";
}

double StateMachine::out(const Kinematics& k, const double* held) const {
  if (out_.empty()) return held[kActive];
  const double own[2] = {k.t() - held[kSince], held[kValue]};
  out_.eval(k, outs_.data(), own);
  return outs_[static_cast<std::size_t>(held[kActive])];
}

void StateMachine::describe(Description& d) const {
  d.signal("out", Unit::any, "output of the active state",
           [this](const SignalView& v) { return out(*v.kinematics, v.memory.data()); });
  d.signal("state", Unit::none, "number of the active state, from 0",
           [](const SignalView& v) { return v.memory[kActive]; });
  d.signal("time", Unit::time, "time since it became active",
           [](const SignalView& v) { return v.t - v.memory[kSince]; });
  d.signal("value", Unit::any, "the number that transitions set",
           [](const SignalView& v) { return v.memory[kValue]; });
  for (Signal& s : d.signals) s.ofState = true;
  d.signal(kSwitching, Unit::none, "positive where a transition takes place",
           [this](const SignalView& v) {
             int due = -1;
             return monitor(*v.kinematics, v.kinematics->memory(memory_).data(), &due);
           });
  announceInstants(d, [this](double t) {
    double next = out_.nextInstant(t);
    for (const auto& each : transitions_) next = std::min(next, each->nextInstant(t));
    return next;
  });
}

}  // namespace dynamy
