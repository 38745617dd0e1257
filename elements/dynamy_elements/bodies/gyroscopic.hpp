/// The gyroscopic term of a free body at the mean velocity of a step.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

/// J(Ω_free − Ω^A) = Δt (M_K − Ω̄ × JΩ̄), Ω̄ = ½(Ω^A + Ω_free): energy and |JΩ| of a free body stay.
/// `h`: its three moments M_K − Ω^A × JΩ^A, replaced by J(Ω_free − Ω^A)/Δt. Steps of more than a
/// radian are taken in parts.
void gyroscopicAtMean(const Mat3& J, const Vec3& OmegaA, double dt, double* h);

}  // namespace dynamy
