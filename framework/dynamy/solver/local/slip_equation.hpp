/// SlipEquation: the slip parameter a of one contact with a disc of friction.        (theory 4.12)
///
///   Λ_T(a) = −(D̂ + aI)⁻¹ b̂ = p(a)/d(a),   size(a) = s q(a)/d(a)
///   d(a) = det(D̂ + aI),  p(a) = −(adj D̂ + aI) b̂,        |Λ_T(a)| = size(a) ≥ 0,  a > 0
///
/// p, q and d are polynomials, so that |p|² = s² q² is a quartic equation. It is solved in the form
/// F(a) = s q/|p| − 1 = 0. F is nearly linear (exactly so for isotropic, uncoupled D), so that two
/// to four Newton steps suffice. The closed form of a quartic was rejected: it loses half of the
/// digits where roots are close together.
#pragma once

namespace dynamy {

struct SlipEquation {
  static constexpr int kMaxRoots = 4;
  double p0[2], p1[2];  ///< p = p0 + p1 a
  double q0, q1, q2;    ///< q = q0 + q1 a + q2 a²
  double d0, d1;        ///< d = d0 + d1 a + a²
  double s;             ///< μ, or the radius of a disc of given size (q = d)

  /// The root, if exactly one exists and F(0) < 0; by Newton's method in a bracket.
  double onlyRoot() const;
  /// All roots a > 0 with size(a) ≥ 0, ascending: isolated by sign changes of the quartic's
  /// Bernstein coefficients, refined on F. Roots that coincide may be found once or, by rounding,
  /// not at all.
  int roots(double* a) const;
  double d(double a) const { return d0 + (d1 + a) * a; }
  /// F and its slope; `sign` multiplies q.
  double F(double a, double sign, double& slope) const;

 private:
  /// The root in [low, high], iterated from a; negative: there is none.
  double refine(double low, double high, double a) const;
};

}  // namespace dynamy
