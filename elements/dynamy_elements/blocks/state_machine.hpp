/// StateMachine: states with names, of which one is active, and transitions with guards.
///
///   active i, transition i → j with guard s(t, time, value, signals) > 0 and time ≥ after:
///     i ← j,  value ← set(t, time, value, signals),  time ← 0
///   out = o_i(t, time, value, signals)                       time: since i became active [s]
///
/// Its monitor is the largest guard of the active state's transitions. Runs to a tolerance locate
/// its root; schemes of fixed steps switch at the end of the step in which it became positive. Of
/// several transitions that are due the first one in the file is taken; the new state may be left
/// at once, at most as often as there are states. Active state, instant and value are memory.
///
/// It is an element without contacts, since only those of contacts and systems are asked for
/// switches. Rejected: comparisons as guards, whose roots cannot be located.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy_elements/signal_formulas.hpp>
#include <memory>

namespace dynamy {

class Transition final : public Element {
 public:
  static constexpr Kind kKind = Kind::part;
  static void declare(Attributes& a);
  explicit Transition(const Parameters& x);
  /// Turns names of states into numbers. Throws ModelError.
  void bind(const std::vector<std::string>& states);
  void connect(Topology& topology, const Element& owner);

  int from() const { return from_; }
  int to() const { return to_; }
  /// Positive where the transition is due; own: time and value.
  double guard(const Kinematics& k, const double* own) const;
  double newValue(const Kinematics& k, const double* own) const;
  double nextInstant(double t) const { return when_.nextInstant(t); }

 private:
  struct Named {
    std::string name;
    Place place;
  };
  int number(const Named& state, const std::vector<std::string>& states) const;
  Named fromName_, toName_;
  int from_ = 0, to_ = 0;
  SignalFormulas when_, set_;
  double after_;
};

class StateMachine final : public NonSmoothElement {
 public:
  static void declare(Attributes& a);
  explicit StateMachine(const Parameters& x);
  void connect(Topology& topology) override;
  void contacts(const Kinematics&, ContactSink&) const override {}
  void remember(const Kinematics& k, Vec memory) const override;
  std::string memoryFault(ConstVec memory) const override;
  void describe(Description& d) const override;

 private:
  enum Held { kActive, kSince, kValue, kCount };
  /// Largest guard of the transitions that leave the active state; `first`: number of the first one
  /// that is due, or −1.
  double monitor(const Kinematics& k, const double* held, int* first) const;
  double out(const Kinematics& k, const double* held) const;
  std::vector<std::string> states_;
  std::vector<std::unique_ptr<Transition>> transitions_;
  SignalFormulas out_;
  int start_ = 0;
  double value_;
  MemoryHandle memory_;
  mutable std::vector<double> outs_;  // scratch
};

}  // namespace dynamy
