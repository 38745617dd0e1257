#include <algorithm>
#include <dynamy/core/suggestion.hpp>
#include <dynamy_elements/coordinates/formula_inertia.hpp>

namespace dynamy {

void FormulaInertia::compile(const Parameters& x, const FormulaNames& names,
                             const Eigen::VectorXd& q0, const Eigen::VectorXd& u0,
                             Diagnostics& faults) {
  n_ = names.n(), q_ = names.qSlots(), u_ = names.uSlots();
  unit_.assign(static_cast<std::size_t>(names.inputs()), 0.0);
  const bool byEnergy = !x["kineticEnergy"].text.empty();
  const bool byM = !x["M"].text.empty();
  if (byEnergy == byM) {
    faults.add({.place = x.place,
                .element = x.name.empty() ? x.type : x.type + " name=\"" + x.name + '"',
                .text = byM ? "M and kineticEnergy are both given" : "the inertia is missing",
                .hint = "give either M or kineticEnergy"});
    return;
  }
  const FormulaText text(x, byM ? "M" : "kineticEnergy");
  const int full = n_ * n_, upper = n_ * (n_ + 1) / 2;
  kind_ = byEnergy ? Kind::energy : text.size() == full ? Kind::full : Kind::upper;
  if (byEnergy ? text.size() != 1 : text.size() != full && text.size() != upper) {
    faults.add(text.fault(-1, byEnergy
                                  ? "expects one formula"
                                  : "M has " + std::to_string(text.size()) + " entries, expects " +
                                        std::to_string(full) + " (rows) or " +
                                        std::to_string(upper) + " (rows of the upper triangle)"));
    return;
  }
  const std::size_t before = faults.size();
  ExpressionCompiler compiler(names.symbols());
  text.compileAll(compiler, faults);
  if (faults.size() > before) return;
  tape_ = std::make_unique<Tape>(compiler.finish(), names);

  std::vector<int> configuration = q_;
  configuration.push_back(FormulaNames::kTime);
  constant_ = !tape_->dependsOn(configuration);
  if (byM)
    for (int k = 0; k < text.size(); ++k)
      for (const int s : u_)
        if (tape_->set().dependsOn(k, s)) {
          faults.add(text.fault(k, "M depends on t and positions only"));
          return;
        }
  check(text, names, q0, u0);
}

/// Checks in two states that M is symmetric and T quadratic in u;
/// formulas themselves do not show it.
void FormulaInertia::check(const FormulaText& text, const FormulaNames& names,
                           const Eigen::VectorXd& q0, const Eigen::VectorXd& u0) const {
  constexpr double kRounding = 1e-9;  // relative; far above rounding, far below a wrong formula
  Eigen::VectorXd x(names.inputs());
  for (const double shift : {0.0, 0.3}) {
    x << shift, q0.array() + shift, u0;
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < i; ++j) {
        if (kind_ != Kind::full) break;
        const double* m = tape_->eval(x.data());
        const double a = m[i * n_ + j], b = m[j * n_ + i];
        const double size = std::abs(m[i * n_ + i]) + std::abs(m[j * n_ + j]);
        if (std::abs(a - b) > kRounding * size)
          throw ModelError(
              text.fault(i * n_ + j, "M is not symmetric: entry (" + std::to_string(i + 1) + ", " +
                                         std::to_string(j + 1) + ") is " + numberText(a) +
                                         ", its partner " + numberText(b)));
      }
      if (kind_ != Kind::energy) continue;
      const int slot = names.uSlot(i);
      const double a = tape_->secondPartial(x.data(), slot, slot)[0];
      x.tail(n_).array() += 1.0;
      const double b = tape_->secondPartial(x.data(), slot, slot)[0];
      x.tail(n_) = u0;
      if (std::abs(a - b) > kRounding * (std::abs(a) + std::abs(b)))
        throw ModelError(text.fault(
            0, "the kinetic energy is not quadratic in " + names.u[static_cast<std::size_t>(i)]));
    }
  }
}

/// Entry (i, j), i ≤ j, of a matrix that is given like M.
double FormulaInertia::entry(const double* m, int i, int j) const {
  return kind_ == Kind::full ? m[i * n_ + j] : m[i * n_ - i * (i - 1) / 2 + j - i];
}

void FormulaInertia::mass(const double* x, Block M) const {
  if (kind_ != Kind::energy) {
    const double* m = tape_->eval(x);
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) M(i, j) = entry(m, std::min(i, j), std::max(i, j));
    return;
  }
  for (int i = 0; i < n_; ++i)
    for (int j = i; j < n_; ++j)
      M(i, j) = M(j, i) = tape_->secondPartial(x, u_[static_cast<std::size_t>(i)],
                                               u_[static_cast<std::size_t>(j)])[0];
}

void FormulaInertia::addGyroscopic(double factor, const double* x, const double* w, Vec h) const {
  byEnergy() ? addGyroscopicOfT(factor, x, w, h) : addGyroscopicOfM(factor, x, w, h);
}

void FormulaInertia::addGyroscopicOfT(double factor, const double* x, const double* w,
                                      Vec h) const {
  const double* gradient = tape_->gradient(x, q_);
  for (int i = 0; i < n_; ++i) h[i] += factor * gradient[i];
  for (int i = 0; i < n_; ++i) {
    const auto slot = static_cast<std::size_t>(u_[static_cast<std::size_t>(i)]);
    unit_[slot] = 1.0;
    h[i] -= factor * tape_->second(x, unit_.data(), w)[0];
    unit_[slot] = 0.0;
  }
}

void FormulaInertia::addGyroscopicOfM(double factor, const double* x, const double* w,
                                      Vec h) const {
  const double* u = x + 1 + n_;
  const double* rate = tape_->derivative(x, w);
  for (int i = 0; i < n_; ++i)
    for (int j = 0; j < n_; ++j)
      h[i] -= factor * entry(rate, std::min(i, j), std::max(i, j)) * u[j];
  for (int i = 0; i < n_; ++i) {
    const double* slope = tape_->partial(x, q_[static_cast<std::size_t>(i)]);
    double sum = 0.0;
    for (int j = 0; j < n_; ++j)
      for (int k = 0; k < n_; ++k)
        sum += entry(slope, std::min(j, k), std::max(j, k)) * u[j] * u[k];
    h[i] += 0.5 * factor * sum;
  }
}

}  // namespace dynamy
