/// Formulas of time in attributes, e.g. motion="0.1*sin(2*pi*t); 0; 0".
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <string_view>
#include <vector>

namespace dynamy {

/// Formulas of t with exact first and second time derivatives.
class TimeFormulas {
 public:
  TimeFormulas() = default;
  /// Compiles the formulas of an attribute, separated by ';'; they may use t and the parameters of
  /// the model. Throws ModelError with the place in the text, or if their number is not `count`. An
  /// attribute that is not given has no formulas.
  TimeFormulas(const Parameters& x, std::string_view attribute, int count);

  bool empty() const { return formulas_.empty(); }
  /// Writes `count` values f(t), and as many first and second derivatives
  /// where pointers are not null.
  void eval(double t, double* f, double* df = nullptr, double* ddf = nullptr) const;
  /// First instant after t at which any formula jumps or has a kink (ExpressionSet::nextInstant).
  double nextInstant(double t) const;
  /// Announces the instants at which formulas jump or have a kink (announced_signals.hpp).
  static void announce(Description& d, std::vector<const TimeFormulas*> all);

 private:
  /// Registers of the tape: scratch, not state.
  mutable std::vector<Expression> formulas_;
};

}  // namespace dynamy
