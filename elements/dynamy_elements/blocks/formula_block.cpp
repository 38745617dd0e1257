#include <dynamy_elements/blocks/formula_block.hpp>

namespace dynamy {

void FormulaBlock::declare(Attributes& a) {
  a.about(
      "A formula with a name: gain, sum, difference, limit, for several formulas that need the "
      "same "
      "number. Signal: out.");
  a.add(AttributeType::expression, "of", std::nullopt, "formula of t and signals");
  a.example("<Formula name=\"error\" of=\"0.5 - cart.x\"/>");
}

void FormulaBlock::describe(Description& d) const {
  d.signal("out", Unit::any, "value of the formula",
           [this](const SignalView& v) { return of_.value(*v.kinematics); });
  SignalFormulas::announce(d, {&of_});
}

}  // namespace dynamy
