/// UnilateralAdhesion: a contact that also pulls, up to a given force.               (theory 42.7)
///
///   C_N = [−a Δt, ∞),   |Λ_T| ≤ μ (Λ_N + a Δt)
///
/// With Λ' = Λ + (a Δt, 0) the law is Coulomb friction, which computes everything. The contact
/// holds while its gap is closed. Once it is pulled off, it does not pull again until it touches
/// again. Pulling off costs no energy: a Δt γ → 0 with Δt. In an impact (Δt = 0) the law is that of
/// an ordinary contact.
#pragma once
#include <dynamy/law/standard_laws.hpp>

namespace dynamy {

class UnilateralAdhesion final : public SetValuedForceLaw {
 public:
  /// force: largest pull a [N].
  UnilateralAdhesion(double force, double mu, double epsilonN)
      : force_(force), mu_(mu), contact_(epsilonN, 0.0, mu) {}
  explicit UnilateralAdhesion(const Parameters& x);
  static void declare(Attributes& a);
  int dim(int geometric) const override;
  bool unilateral() const override { return true; }
  RowKind rowKind(int row) const override { return contact_.rowKind(row); }
  int groupEnd(int row, int dim) const override { return contact_.groupEnd(row, dim); }
  bool scales() const override { return true; }
  void epsilon(int dim, double* epsilon) const override { contact_.epsilon(dim, epsilon); }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  SimpleSet simpleSet(const LawInput& in) const override;
  /// Returns `lower` in the step in which the contact is pulled off.
  Status status(const LawInput& in, const double* argument) const override;

 private:
  double pull(const LawInput& in) const { return force_ * in.scale * in.dt; }
  double force_, mu_;
  UnilateralCoulomb contact_;
};

}  // namespace dynamy
