/// UnilateralDrilling: sliding and spinning friction of a contact patch, which weaken each other.
///                                                                            (theory 9.4, 22)
///   rows N, T1, T2, τ;   B = { (λ_T, τ) }: every friction state of a patch of radius a at Λ_N = 1
///   contensou   S_B(y) = μ (v F(d) + w T(d)),   v = |y_T|, w = a|y_τ|, d = v/w
///   ellipsoid   S_B(y) = μ √(v² + (T(0) w)²)    same extent, other shape
///
/// Uniform pressure: F and T are made of the elliptic integrals K(k), E(k), k = d or 1/d, from one
/// arithmetic-geometric mean each (22.2)–(22.4); T(0) = 2/3. Hertz pressure, of two balls that
/// press each other flat: F and T are elementary (22.8), (22.9); T(0) = 3π/16. Two separate laws
/// for sliding and spinning were rejected: a spinning disc then keeps its full resistance against
/// sliding, and no tippe top turns over.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

/// Friction force F and moment T of the patch relative to their largest values, and the slope of F,
/// at the ratio d = v/w ≥ 0; F(∞) = 1, T(∞) = 0.
struct ContensouCurve {
  double F = 0.0, T = 2.0 / 3.0;
  double FOverD = 1.0;       ///< F/d, also at d = 0; only for d ≤ 1
  double slope = 1.0;        ///< F′ = dF/dd for d ≤ 1
  double slopeCubed = 0.25;  ///< d³ F′ for d ≥ 1
};
/// The curve at d = v/w for uniform pressure; v, w ≥ 0, not both 0, and no quotient is needed.
ContensouCurve contensouCurve(double v, double w);
/// The curve at d = v/w for Hertz pressure, p ~ √(1 − (r/a)²).
ContensouCurve hertzCurve(double v, double w);

class UnilateralDrilling final : public NormalTimesReservoir {
 public:
  enum class Set { contensou, ellipsoid };
  enum class Pressure { uniform, hertz };
  /// mu ≥ 0 [–], radius > 0 [m].
  UnilateralDrilling(double mu, double radius, Set set = Set::contensou, double epsilonN = 0.0,
                     Pressure pressure = Pressure::uniform)
      : mu_(mu), radius_(radius), epsilonN_(epsilonN), set_(set), pressure_(pressure) {}
  explicit UnilateralDrilling(const Parameters& x);
  static void declare(Attributes& a);
  int dim(int) const override { return 4; }
  int groupEnd(int row, int) const override { return row == 0 ? 1 : (row < 3 ? 3 : 4); }
  void epsilon(int dim, double* epsilon) const override;
  double support(const LawInput& in, int k, const double* y, double* gradient = nullptr,
                 double* hessian = nullptr) const override;

 private:
  double mu_, radius_, epsilonN_;
  Set set_;
  Pressure pressure_;
};

}  // namespace dynamy
