/// Dry friction that weakens with the slip speed v = |γ|, after Stribeck.            (theory 42.6)
///
///   a(v) = a_k + (a_s − a_k) f((v/v_s)^p) + d v,     f(x) = e^{−x}  or  1/(1 + x)
///   −γ ∈ N_C(Λ),  C = disc of radius a(v) Δt (given force) or a(v) Λ_N (with a contact)
///
/// v is taken at the beginning of the step: the set does not depend on the solution, which exists
/// and is unique as for constant friction. The error is of first order in Δt like that of the
/// scheme. Rejected: v at the end of the step, which has one solution only while Δt |a'| < 1/G.
#pragma once
#include <dynamy/law/standard_laws.hpp>

namespace dynamy {

/// a(v), in the unit of a_s: force [N] or coefficient [–].
struct StribeckCurve {
  double atRest = 0.0, far = 0.0;  ///< a_s, a_k
  double speed = 1.0;              ///< v_s [m/s or rad/s]
  double exponent = 1.0;           ///< p
  bool rational = false;           ///< f(x) = 1/(1 + x)
  double viscous = 0.0;            ///< d [unit of a_s per m/s]
  double operator()(double v) const;
  /// a(v) at the speed of the rows first … first + k − 1 of γ^A; at rest if γ^A is not known.
  double at(const LawInput& in, int first, int k) const;
};

/// Friction of given size, weakening with speed: belts, bowed strings, brakes.
class StribeckFriction final : public SetValuedForceLaw {
 public:
  explicit StribeckFriction(const StribeckCurve& curve) : curve_(curve) {}
  explicit StribeckFriction(const Parameters& x);
  static void declare(Attributes& a);
  int dim(int geometric) const override { return geometric; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  int groupEnd(int, int dim) const override { return dim; }
  bool scales() const override { return true; }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  SimpleSet simpleSet(const LawInput& in) const override;
  Status status(const LawInput& in, const double* argument) const override;

 private:
  GivenFriction now(const LawInput& in) const;
  StribeckCurve curve_;
};

/// Unilateral contact whose coefficient of friction weakens with the slip speed.
class UnilateralStribeck final : public NormalTimesReservoir {
 public:
  UnilateralStribeck(double epsilonN, const StribeckCurve& mu) : epsilonN_(epsilonN), mu_(mu) {}
  explicit UnilateralStribeck(const Parameters& x);
  static void declare(Attributes& a);
  bool isMirrored(const MirrorPlane&) const override { return true; }
  int dim(int geometric) const override { return geometric < 3 ? geometric : 3; }
  void epsilon(int dim, double* epsilon) const override;
  void project(const LawInput& in, double N, const double* r, int k, double* x) const override;
  double support(const LawInput& in, int k, const double* y, double* gradient = nullptr,
                 double* hessian = nullptr) const override;
  void naturalMap(const LawInput& in, double rho, const double* xi, const double* Lambda,
                  double* e) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  SimpleSet simpleSet(const LawInput& in) const override;

 private:
  UnilateralCoulomb now(const LawInput& in) const;
  double epsilonN_;
  StribeckCurve mu_;
};

}  // namespace dynamy
