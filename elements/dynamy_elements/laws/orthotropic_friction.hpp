/// UnilateralOrthotropic: contact on a surface with a grain.                        (theory 9.4)
///
///   B = { x: (x₁'/μ₁)² + (x₂'/μ₂)² ≤ 1 }     x' = x in axes turned by `angle` from the first tangent
///   S_B(y) = √(μ₁² y₁'² + μ₂² y₂'²)
///   slip:  Λ_T = −Λ_N (μ₁² γ₁', μ₂² γ₂') / √(μ₁² γ₁'² + μ₂² γ₂'²)
///
/// The force is not opposite to the slip: the slip is normal to the ellipse, so that dissipation is
/// maximal. A force along −γ whose size depends on its direction was rejected: its set is not
/// convex, and it has no potential. A planar contact has B = [−a, a] with a = S_B of its tangent.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

class UnilateralOrthotropic final : public NormalTimesReservoir {
 public:
  /// mu1, mu2 ≥ 0 [–], angle [rad].
  UnilateralOrthotropic(double epsilonN, double epsilonT, double mu1, double mu2,
                        double angle = 0.0);
  explicit UnilateralOrthotropic(const Parameters& x);
  static void declare(Attributes& a);
  int dim(int geometric) const override { return geometric < 3 ? geometric : 3; }
  void epsilon(int dim, double* epsilon) const override;
  SimpleSet simpleSet(const LawInput& in) const override;
  void project(const LawInput& in, double N, const double* r, int k, double* x) const override;
  double support(const LawInput& in, int k, const double* y, double* gradient = nullptr,
                 double* hessian = nullptr) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;

 private:
  double epsilonN_, epsilonT_;
  double mu_[2], cos_, sin_;
};

}  // namespace dynamy
