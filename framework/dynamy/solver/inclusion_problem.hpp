/// InclusionProblem:  ξ = G Λ + c,   −ξ_i ∈ N_{C_i}(Λ_i),  i = 1 … n.     (theory 4.1)
///
/// Solvers see operators and laws, never elements.
#pragma once
#include <dynamy/solver/delassus.hpp>

namespace dynamy {

struct InclusionProblem {
  Delassus* G = nullptr;
  const ContactSet* contacts = nullptr;
  double dt = 0.0;                ///< [s]; 0: pure impact
  std::vector<double> c;          ///< c = (1 + ε)… as the impact law poses it [m/s]
  std::vector<double> gammaFree;  ///< Wᵀ u_free + χ: relative velocity without any percussion
  std::vector<double> gammaA;     ///< Wᵀ u^A + χ
  double uRef = 1.0;  ///< velocity scale of E_u: max(|γ^A|, |γ_free|, Δt|Wᵀ M⁻¹h|)  [m/s]
  double lambdaFloor =
      0.0;  ///< 1e-12 × sum of free impulses: a scene without forces terminates [N s]

  int size() const { return contacts->size(); }
  int rows() const { return contacts->rows(); }
  int row0(int i) const { return contacts->row0[static_cast<std::size_t>(i)]; }
  int dim(int i) const { return contacts->dim(i); }
  const SetValuedForceLaw& law(int i) const { return *contacts->law[static_cast<std::size_t>(i)]; }
  LawInput input(int i) const { return {dim(i), dt, gammaA.data() + row0(i), nullptr}; }
};

}  // namespace dynamy
