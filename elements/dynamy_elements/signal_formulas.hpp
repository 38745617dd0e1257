/// Formulas of the time, of an element's own numbers and of signals of the model, e.g.
/// force="-40*cart.x - 5*cart.vx; 0; 0".
///
///   f(t, own, s₁(t, q, u), s₂(t, q, u), …)
///
/// A name with a dot, or in braces, is a signal; {left/arm[2].phi} has a path. Formulas of which an
/// element needs rates, as a prescribed motion, are TimeFormulas.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/system/kinematics.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace dynamy {

class SignalFormulas {
 public:
  SignalFormulas() = default;
  /// Compiles the formulas of an attribute, separated by ';'. `own`: names of the element's own
  /// numbers. Throws ModelError with the place in the text, or if their number is not `count`. An
  /// attribute that is not given has no formulas.
  SignalFormulas(const Parameters& x, std::string_view attribute, int count,
                 const std::vector<std::string>& own = {});
  /// Requests the signals. To be called once, in the element's connect().
  void connect(Topology& topology, const Element& owner);

  bool empty() const { return formulas_.empty(); }
  bool readsSignals() const { return !reads_.empty(); }
  /// Writes all values at k; `own`: the element's own numbers.
  void eval(const Kinematics& k, double* f, const double* own = nullptr) const;
  /// The value of the only formula; 0 if there is none.
  double value(const Kinematics& k, const double* own = nullptr) const;
  /// ∂f/∂own_i of the only formula, with the numbers of the last evaluation.
  double partial(int i) const;
  /// First instant after t at which any formula jumps or has a kink by the time alone.
  double nextInstant(double t) const;
  /// (a, b) if the only formula is a + b t; nothing: it is not.
  std::optional<std::pair<double, double>> lineInTime() const;
  /// Announces these instants (announced_signals.hpp).
  static void announce(Description& d, std::vector<const SignalFormulas*> all);

 private:
  struct Read {
    std::string name;
    Place place;
    SignalHandle handle;
  };
  void gather(const Kinematics& k, const double* own) const;
  int own_ = 0;
  std::vector<Read> reads_;
  /// Registers of the tapes and their inputs (t, own, signals): scratch, not state.
  mutable std::vector<Expression> formulas_;
  mutable std::vector<double> x_, direction_;
};

}  // namespace dynamy
