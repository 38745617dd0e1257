/// One contact of any law, −(DΛ + b) ∈ N_C(Λ), for laws that have no closed form:
///
///   F(Λ) = Λ − prox_C(Λ − ρ(DΛ + b)) = 0:   (A + B D) ΔΛ = −F,   A = ∂F/∂Λ, B = ∂F/∂ξ
///
/// Newton steps with halving are made if the law has a derivative and they reduce |F|, otherwise
/// prox steps.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

/// Λ: start in, better Λ out. D: in.dim × in.dim, row after row; r: prox parameters of the rows
/// [kg]. True: |F| reached rounding.
bool iterateContact(const SetValuedForceLaw& law, const LawInput& in, const double* D,
                    const double* b, const double* r, double* Lambda);

}  // namespace dynamy
