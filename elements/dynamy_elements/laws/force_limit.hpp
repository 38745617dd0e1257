/// ForceLimit: a constraint whose force cannot leave an interval.                   (theory 9.4)
///
///   C = [lower Δt, upper Δt] in every row:  γ = 0 while the force lies between its limits, and the
///   row moves against the limit that it reaches. Overload clutches, drives of limited force,
///   one-sided brakes (one limit 0).
///
/// With limits of both signs the law only dissipates energy (Λ·ξ ≤ 0). With an
/// interval without 0 it supplies at most its nearer limit times γ. In a pure impact
/// (Δt = 0) finite limits transmit nothing.
#pragma once
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

class ForceLimit : public SetValuedForceLaw {
 public:
  /// lower ≤ upper [N or N m], ±∞ allowed.
  ForceLimit(double lower, double upper) : limit_{lower, upper} {}
  explicit ForceLimit(const Parameters& x);
  static void declare(Attributes& a);
  int dim(int geometric) const override { return geometric; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  bool scales() const override { return true; }
  SimpleSet simpleSet(const LawInput& in) const override;
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  /// Status of the first row that is at a limit.
  Status status(const LawInput& in, const double* argument) const override;

 protected:
  ForceLimit(const Parameters& x, convex::Interval limit) : SetValuedForceLaw(x), limit_(limit) {}

 private:
  convex::Interval interval(const LawInput& in) const;
  convex::Interval limit_;
};

/// Sprag clutch, ratchet, free wheel: C = ℝ₀⁺ (free in the positive direction) or ℝ₀⁻ (negative),
/// cut off at ±limit Δt if a limit is given. No gap: the law always acts.      (theory 42.1)
class OneWayClutch final : public ForceLimit {
 public:
  explicit OneWayClutch(const Parameters& x);
  static void declare(Attributes& a);
};

}  // namespace dynamy
