/// Unilateral contact with Coulomb friction and rolling resistance, the law of FCLIB's rolling
/// problems [acary_bremond_huber2018]. Rows: normal, two tangents, two moments.
///
///   K = { |Λ_T| ≤ μ Λ_N, |Λ_M| ≤ μ_r Λ_N },   S_B(y) = μ |y_T| + μ_r |y_M|
///   law  ⇔  K* ∋ (ξ_N + μ|ξ_T| + μ_r|ξ_M|, ξ_T, ξ_M) ⊥ Λ ∈ K
#pragma once
#include <dynamy/contact/set_valued_force_law.hpp>

namespace dynamy {

class UnilateralRolling final : public NormalTimesReservoir {
 public:
  /// mu [–], muRolling [m], both ≥ 0.
  UnilateralRolling(double mu, double muRolling) : mu_{mu, muRolling} {}
  int dim(int) const override { return 5; }
  int groupEnd(int row, int) const override { return row == 0 ? 1 : (row < 3 ? 3 : 5); }
  void project(const LawInput& in, double N, const double* r, int k, double* x) const override;
  double support(const LawInput& in, int k, const double* y, double* gradient = nullptr,
                 double* hessian = nullptr) const override;
  /// One projection onto K, with the shift of De Saxcé.
  void naturalMap(const LawInput& in, double rho, const double* xi, const double* Lambda,
                  double* e) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;

 private:
  double mu_[2];
};

}  // namespace dynamy
