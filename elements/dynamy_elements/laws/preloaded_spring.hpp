/// PreloadedSpring: a spring of stiffness c with the preload a, at rest in x = 0 up to this force.
///                                                                              (theory 42.3)
///   both sides   λ ∈ −c x − a Sign(x)
///   one side     λ ∈ c max(−x, 0) + a [0, 1]_{x}     1 for x < 0, [0, 1] at x = 0, 0 for x > 0
///
/// The set-valued law is one of displacements. With x at the midpoint of a step, c x is evaluated
/// there; the set-valued part is evaluated at the next midpoint, x + Δt γ:
///
///   −(γ + x/Δt) ∈ N_C(Λ),    C = Δt [−c x − a, −c x + a]   or   Δt (c max(−x, 0) + [0, a])
///
/// so that a spring at rest in the notch x = 0 is back in it after one step. Rejected: x + Δt γ/2,
/// the end of the step, about which a body oscillates for ever. The spring stores the energy
/// V = c x²/2 + a |x|: its work in the energy ledger is not dissipation. In a pure impact it
/// transmits nothing.
#pragma once
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

class PreloadedSpring final : public SetValuedForceLaw {
 public:
  /// c [N/m], a [N].
  PreloadedSpring(double stiffness, double preload, bool oneSided)
      : stiffness_(stiffness), preload_(preload), oneSided_(oneSided) {}
  explicit PreloadedSpring(const Parameters& x);
  static void declare(Attributes& a);
  int dim(int) const override { return 1; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  bool scales() const override { return true; }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  bool notched(const LawInput& in, NotchedForce& out) const override;
  /// Returns `locked` in the notch x = 0, `lower` for x > 0, `upper` for x < 0.
  Status status(const LawInput& in, const double* argument) const override;

 private:
  double x(const LawInput& in) const { return in.position[0]; }
  convex::Interval interval(const LawInput& in) const;
  /// Λ − r (ξ + x/Δt).
  double argument(const LawInput& in, double r, double xi, double Lambda) const;
  double stiffness_, preload_;
  bool oneSided_;
};

}  // namespace dynamy
