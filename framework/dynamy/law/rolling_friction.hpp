/// UnilateralRolling: contact with Coulomb friction and resistance to rolling, to spin, and to
/// motion of the point of contact along a body's contour.                           (theory 9.6)
///
///   K = { |Λ_T| ≤ μ Λ_N, |Λ_τ| ≤ μ_s Λ_N, |Λ_M| ≤ μ_r Λ_N, |Λ_C| ≤ μ_c Λ_N }
///   S_B(y) = μ |y_T| + μ_s |y_τ| + μ_r |y_M| + μ_c |y_C|
///   law  ⇔  K* ∋ (ξ_N + S_B(ξ), ξ_T, …) ⊥ Λ ∈ K                    [acary_bremond_huber2018]
///
/// Every contact of shapes in space offers these rows; their number determines their meaning:
///
///   5   N, T1, T2, M1, M2                      M: angular velocities about the tangents
///   6   N, T1, T2, τ, M1, M2                   τ: about the normal
///   8   N, T1, T2, τ, M1, M2, C1, C2           C: velocity of the point of contact over the body
///
/// The parts do not weaken each other; UnilateralDrilling has the coupled set of sliding and spin.
/// One law per part was rejected: all parts depend on the same normal force.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

/// Coefficients, all ≥ 0.
struct RollingCoefficients {
  double mu = 0.0;
  double rolling = 0.0;   ///< [m]
  double drilling = 0.0;  ///< [m]
  double contour = 0.0;   ///< [–]
};

class UnilateralRolling final : public NormalTimesReservoir {
 public:
  /// mu [–], muRolling [m], both ≥ 0: the law of FCLIB's rolling problems.
  UnilateralRolling(double mu, double muRolling) : UnilateralRolling({mu, muRolling, 0.0, 0.0}) {}
  explicit UnilateralRolling(const RollingCoefficients& mu, double epsilonN = 0.0)
      : mu_(mu), epsilonN_(epsilonN) {}
  explicit UnilateralRolling(const Parameters& x);
  static void declare(Attributes& a);
  int dim(int) const override { return mu_.contour > 0.0 ? 8 : (mu_.drilling > 0.0 ? 6 : 5); }
  int groupEnd(int row, int dim) const override;
  void epsilon(int dim, double* epsilon) const override;
  /// Null: a reservoir slips in all of its rows or in none, but here some parts may stick alone.
  const NormalTimesReservoir* reservoir() const override { return nullptr; }
  const NormalTimesReservoir* discs() const override { return this; }
  void project(const LawInput& in, double N, const double* r, int k, double* x) const override;
  double support(const LawInput& in, int k, const double* y, double* gradient = nullptr,
                 double* hessian = nullptr) const override;
  /// One projection onto K, with the shift of De Saxcé.
  void naturalMap(const LawInput& in, double rho, const double* xi, const double* Lambda,
                  double* e) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;

 private:
  struct Parts;
  RollingCoefficients mu_;
  double epsilonN_;
};

}  // namespace dynamy
