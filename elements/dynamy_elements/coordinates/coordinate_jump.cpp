#include <algorithm>
#include <dynamy_elements/coordinates/coordinate_jump.hpp>
#include <limits>

namespace dynamy {

void CoordinateJump::declare(Attributes& a) {
  a.about(
      "Jump of a system of Coordinates, as in hybrid models: where a guard passes zero, "
      "coordinates and velocities take new values.");
  a.add(AttributeType::expression, "guard", std::nullopt, "formula s of t and q");
  a.choice("direction", {"rising", "falling"}, "rising", "in which s passes zero");
  a.add(AttributeType::expression, "when", "",
        "formula of t, q and q_dot: the guard counts only where it is positive");
  a.add(AttributeType::expressions, "q", "",
        "new coordinates, formulas of t, q and q_dot before the jump; default: unchanged");
  a.add(AttributeType::expressions, "u", "", "new velocities; default: unchanged");
  a.example(
      "<Coordinates name=\"ball\" q=\"y\" units=\"m\" q0=\"1\" M=\"1\" h=\"-9.81\">"
      "<Jump guard=\"y\" direction=\"falling\" u=\"-0.5*y_dot\"/></Coordinates>");
}

CoordinateJump::CoordinateJump(const Parameters& x)
    : CoordinatePart(x),
      guardText_(x, "guard"),
      whenText_(x, "when"),
      q_(x, "q"),
      u_(x, "u"),
      sign_(x["direction"].text == "falling" ? -1.0 : 1.0),
      conditional_(!whenText_.empty()) {
  if (guardText_.size() != 1) throw ModelError(guardText_.fault(-1, "expects one formula"));
  if (whenText_.size() > 1) throw ModelError(whenText_.fault(-1, "expects one formula"));
  if (q_.empty() && u_.empty())
    throw ModelError(guardText_.fault(-1, "the jump changes nothing",
                                      "give new coordinates, q, or new velocities, u"));
}

void CoordinateJump::compile(const FormulaNames& names, Diagnostics& faults) {
  const std::size_t before = faults.size();
  const auto compiled = [&](std::initializer_list<const FormulaText*> texts) {
    ExpressionCompiler compiler(names.symbols());
    for (const FormulaText* text : texts) text->compileAll(compiler, faults);
    return faults.size() > before ? nullptr : std::make_unique<Tape>(compiler.finish(), names);
  };
  for (const FormulaText* text : {&q_, &u_})
    if (!text->empty() && text->size() != names.n())
      faults.add(text->fault(-1, "expects one formula for each of the " +
                                     std::to_string(names.n()) + " coordinates, has " +
                                     std::to_string(text->size())));
  guard_ = compiled({&guardText_}), when_ = compiled({&whenText_}), map_ = compiled({&q_, &u_});
  nq_ = q_.size(), nu_ = u_.size();
  if (guard_ && guard_->dependsOn(names.uSlots()))
    faults.add(guardText_.fault(0, "a guard depends on t and positions only",
                                "a condition on velocities goes into when"));
  guardText_ = {}, whenText_ = {}, q_ = {}, u_ = {};
}

double CoordinateJump::monitor(const double* x) const {
  const double s = sign_ * guard_->eval(x)[0];
  return conditional_ ? std::min(s, when_->eval(x)[0]) : s;
}

bool CoordinateJump::isDue(const double* x, const double* w) const {
  return monitor(x) > 0.0 && sign_ * guard_->derivative(x, w)[0] > 0.0;
}

void CoordinateJump::apply(const double* x, Vec q, Vec u) const {
  const double* value = map_->eval(x);
  std::copy_n(value, nq_, q.data());
  std::copy_n(value + nq_, nu_, u.data());
}

void CoordinateJumps::compile(const FormulaNames& names, Diagnostics& faults) {
  for (auto& jump : jumps_) jump->compile(names, faults);
  x_.assign(static_cast<std::size_t>(names.inputs()), 0.0);
  w_ = x_;
  w_[FormulaNames::kTime] = 1.0;
}

double CoordinateJumps::monitor(const double* x) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& jump : jumps_) most = std::max(most, jump->monitor(x));
  return most;
}

double CoordinateJumps::nextInstant(double t) const {
  double next = std::numeric_limits<double>::infinity();
  for (const auto& jump : jumps_) next = std::min(next, jump->nextInstant(t));
  return next;
}

bool CoordinateJumps::renew(double, double tE, Vec q, Vec u) const {
  x_[FormulaNames::kTime] = tE;
  std::copy_n(q.data(), q.size(), x_.begin() + 1);
  std::copy_n(u.data(), u.size(), x_.begin() + 1 + q.size());
  std::copy_n(u.data(), u.size(), w_.begin() + 1);
  for (const auto& jump : jumps_)
    if (jump->isDue(x_.data(), w_.data())) {
      jump->apply(x_.data(), q, u);
      return true;
    }
  return false;
}

}  // namespace dynamy
