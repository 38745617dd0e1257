#include <algorithm>
#include <dynamy/core/declared/formula_fault.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy_elements/time_formulas.hpp>
#include <limits>

namespace dynamy {

TimeFormulas::TimeFormulas(const Parameters& x, std::string_view attribute, int count) {
  const ParameterValue& value = x[attribute];
  if (!value.given) return;
  const std::vector<ValuePart> parts = formulasOf(value, count);
  SymbolTable symbols;
  for (const auto& [name, number] : x.symbols) symbols.constant(name, number);
  symbols.variable("t");
  for (const ValuePart& part : parts) {
    try {
      formulas_.push_back(Expression::compile(part.text, symbols));
    } catch (const ExpressionError& error) {
      for (const NameInFormula& signal : signalNames(part.text))
        if (signal.offset == error.offset())
          throw value.fault("the signal \"" + signal.name + "\" cannot be read here",
                            "this formula is of the time alone, since its rates are needed",
                            part.offset + error.offset(), error.length());
      throw formulaFault(value, part, error);
    }
  }
}

void TimeFormulas::eval(double t, double* f, double* df, double* ddf) const {
  const double one = 1.0;
  for (std::size_t i = 0; i < formulas_.size(); ++i) {
    f[i] = formulas_[i].value(&t);
    if (df) df[i] = formulas_[i].derivative(&t, &one);
    if (ddf) ddf[i] = formulas_[i].secondDerivative(&t, &one, &one);
  }
}

double TimeFormulas::nextInstant(double t) const {
  double next = std::numeric_limits<double>::infinity();
  for (const Expression& formula : formulas_)
    next = std::min(next, formula.set().nextInstant(t, 0));
  return next;
}

void TimeFormulas::announce(Description& d, std::vector<const TimeFormulas*> all) {
  announceInstants(d, [all = std::move(all)](double t) {
    double next = std::numeric_limits<double>::infinity();
    for (const TimeFormulas* formulas : all) next = std::min(next, formulas->nextInstant(t));
    return next;
  });
}

}  // namespace dynamy
