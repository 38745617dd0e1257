#include <algorithm>
#include <dynamy/core/declared/formula_fault.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy_elements/signal_formulas.hpp>
#include <limits>

namespace dynamy {

SignalFormulas::SignalFormulas(const Parameters& x, std::string_view attribute, int count,
                               const std::vector<std::string>& own)
    : own_(static_cast<int>(own.size())) {
  const ParameterValue& value = x[attribute];
  if (!value.given && value.text.empty()) return;
  const std::vector<ValuePart> parts = formulasOf(value, count);
  SymbolTable symbols;
  for (const auto& [name, number] : x.symbols) symbols.constant(name, number);
  symbols.variable("t");
  for (const std::string& name : own) symbols.variable(name);
  for (const ValuePart& part : parts)
    for (const NameInFormula& signal : signalNames(part.text)) {
      if (symbols.find(signal.name) != nullptr) continue;
      symbols.variable(signal.name);
      const Place place =
          value.locate ? value.locate(part.offset + signal.offset, signal.length) : value.place;
      reads_.push_back({signal.name, place, {}});
    }
  for (const ValuePart& part : parts) {
    try {
      formulas_.push_back(Expression::compile(part.text, symbols));
    } catch (const ExpressionError& error) {
      throw formulaFault(value, part, error);
    }
  }
  x_.assign(1 + own.size() + reads_.size(), 0.0);
  direction_ = x_;
}

void SignalFormulas::connect(Topology& topology, const Element& owner) {
  for (Read& r : reads_) r.handle = topology.signal(r.name, r.place, owner);
}

void SignalFormulas::gather(const Kinematics& k, const double* own) const {
  // A signal may evaluate other formulas, not these: loops are refused when the model is built.
  x_[0] = k.t();
  std::copy_n(own, own_, x_.begin() + 1);
  auto next = x_.begin() + 1 + own_;
  for (const Read& r : reads_) *next++ = k.signal(r.handle);
}

void SignalFormulas::eval(const Kinematics& k, double* f, const double* own) const {
  if (empty()) return;
  gather(k, own);
  for (std::size_t i = 0; i < formulas_.size(); ++i) f[i] = formulas_[i].value(x_.data());
}

double SignalFormulas::value(const Kinematics& k, const double* own) const {
  double f = 0.0;
  eval(k, &f, own);
  return f;
}

double SignalFormulas::partial(int i) const {
  const auto slot = static_cast<std::size_t>(1 + i);
  direction_[slot] = 1.0;
  const double d = formulas_.front().derivative(x_.data(), direction_.data());
  direction_[slot] = 0.0;
  return d;
}

double SignalFormulas::nextInstant(double t) const {
  double next = std::numeric_limits<double>::infinity();
  for (const Expression& formula : formulas_)
    next = std::min(next, formula.set().nextInstant(t, 0));
  return next;
}

std::optional<std::pair<double, double>> SignalFormulas::lineInTime() const {
  if (readsSignals() || formulas_.size() != 1) return std::nullopt;
  const int time = 0;
  if (!formulas_.front().set().isAffine(0, {&time, 1})) return std::nullopt;
  std::vector<double> x(x_.size(), 0.0);
  const double a = formulas_.front().value(x.data());
  x[0] = 1.0;
  return std::pair{a, formulas_.front().value(x.data()) - a};
}

void SignalFormulas::announce(Description& d, std::vector<const SignalFormulas*> all) {
  announceInstants(d, [all = std::move(all)](double t) {
    double next = std::numeric_limits<double>::infinity();
    for (const SignalFormulas* formulas : all) next = std::min(next, formulas->nextInstant(t));
    return next;
  });
}

}  // namespace dynamy
