/// Bilateral rows without a position.
#pragma once
#include <dynamy/law/standard_laws.hpp>

namespace dynamy {

/// C = ℝ^dim in rows whose γ is not the rate of a position: rolling, steering edges, gears that may
/// slip into place. Schemes that enforce joints on the level of positions treat these rows on the
/// level of velocities.
class BilateralRate final : public SetValuedForceLaw {
 public:
  int dim(int geometric) const override { return geometric; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::rate; }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override {
    law_.prox(in, r, xi, Lambda);
  }
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override {
    return law_.proxDerivative(in, rho, xi, Lambda, A, B);
  }
  SimpleSet simpleSet(const LawInput& in) const override { return law_.simpleSet(in); }
  Status status(const LawInput&, const double*) const override { return Status::locked; }

 private:
  Bilateral law_;
};

}  // namespace dynamy
