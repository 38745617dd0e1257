/// What tells an impact from a force: a contact that closes faster, −γ⁻ > 4 |M⁻¹(h + f)Δt| in its row,
/// than the forces of that many steps explain, has an impact.
#pragma once

namespace dynamy {

inline constexpr double kImpactSteps = 4.0;

}  // namespace dynamy
