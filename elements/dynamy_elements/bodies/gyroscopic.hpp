/// The gyroscopic term of a free body at the mean velocity of a step.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

/// J(Ω_free − Ω^A) = Δt (M_K − Ω̄ × JΩ̄), Ω̄ = ½(Ω^A + Ω_free): this conserves the energy and |JΩ|
/// of a free body. `h`: its three moments M_K − Ω^A × JΩ^A; they are replaced by
/// J(Ω_free − Ω^A)/Δt. Steps that turn by more than a radian are divided into parts.
void gyroscopicAtMean(const Mat3& J, const Vec3& OmegaA, double dt, double* h);

}  // namespace dynamy
