/// CoordinateJump: the jump of a hybrid system, written as formulas:
///
///   where  s(t, q) passes zero upwards and c(t, q, u) > 0:    q⁺ = Q(t, q, u),  u⁺ = U(t, q, u)
///
/// Its monitor is min(s, c). Runs to a tolerance locate its root; schemes of fixed steps jump at
/// the end of the step in which it became positive. No memory is needed: a jump that ends on s = 0
/// again has to leave there downwards, or with c ≤ 0.
#pragma once
#include <dynamy/system/renewable.hpp>
#include <dynamy_elements/coordinates/coordinate_part.hpp>
#include <dynamy_elements/coordinates/formula_text.hpp>
#include <memory>

namespace dynamy {

class CoordinateJump final : public CoordinatePart {
 public:
  static void declare(Attributes& a);
  explicit CoordinateJump(const Parameters& x);
  CoordinateJump* jump() override { return this; }

  /// Compiles the formulas for a system with these names; faults go to `faults`.
  void compile(const FormulaNames& names, Diagnostics& faults);
  /// min(s, c) at x = (t, q, u).
  double monitor(const double* x) const;
  /// True: the jump takes place at x; w = (1, u, 0) is the direction of the motion.
  bool isDue(const double* x, const double* w) const;
  void apply(const double* x, Vec q, Vec u) const;
  /// First instant after t at which a formula of the monitor jumps or has a kink [s].
  double nextInstant(double t) const { return guard_->nextInstant(t); }

 private:
  FormulaText guardText_, whenText_, q_, u_;
  double sign_;
  bool conditional_;
  std::unique_ptr<Tape> guard_, when_, map_;  // the map: q, then u
  int nq_ = 0, nu_ = 0;                       // formulas of the map
};

/// The jumps of one system.
class CoordinateJumps final : public Renewable {
 public:
  void add(std::unique_ptr<CoordinateJump> jump) { jumps_.push_back(std::move(jump)); }
  bool empty() const { return jumps_.empty(); }
  void compile(const FormulaNames& names, Diagnostics& faults);
  /// Positive where one of them takes place.
  double monitor(const double* x) const;
  double nextInstant(double t) const;
  /// Applies the first jump that is due; another one then takes place at the end of the next step.
  bool renew(double tA, double tE, Vec q, Vec u) const override;
  bool jumps() const override { return true; }

 private:
  std::vector<std::unique_ptr<CoordinateJump>> jumps_;
  mutable std::vector<double> x_, w_;  // (t, q, u), the direction (1, u, 0)
};

}  // namespace dynamy
