/// The Fischer–Burmeister function of one contact. (theory 9.2)
///
///   φ(x, y) = x + y − (x² + y²)^½ = 0   ⇔   x ∈ L, y ∈ L, x·y = 0,   L = { x₀ ≥ |x̄| }
///   x = (μΛ_N, Λ_T),   y = ρ (ξ_N + μ|ξ_T|, μ ξ_T)                 law of Coulomb, De Saxcé's form
///
/// Squares and root are those of the Jordan algebra of the second-order cone L
/// [fukushima_luo_tseng2001]. For one row (a contact without friction) φ is the scalar function;
/// for two rows the algebra splits into two scalar ones. coneOf() finds out whether a law has such
/// a cone. Rejected: a function of its own in every law, which few would need.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

/// The cone of a law, if its set is one.
struct LawCone {
  enum class Kind { other, line, halfLine, cone };
  Kind kind = Kind::other;
  double mu = 0.0;  ///< opening of the cone
};

/// Any other set (intervals, ellipses, bodies with a spin) is `other`.
LawCone coneOf(const SetValuedForceLaw& law, const LawInput& in);

/// F = φ at (Λ, ξ) and, if A is not null, A = ∂F/∂Λ, B = ∂F/∂ξ (dim × dim, row after row): an
/// element of the generalised Jacobian, at the kinks the limit from inside. \pre cone.kind != other
void fischerBurmeister(const LawCone& cone, int dim, double rho, const double* xi,
                       const double* Lambda, double* F, double* A, double* B);

}  // namespace dynamy
