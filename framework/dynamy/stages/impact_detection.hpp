/// Distinguishes an impact from the action of forces: a contact has an impact if it closes faster
/// than the forces of four steps explain, −γ⁻ > 4 |M⁻¹(h + f)Δt| in its row.
#pragma once

namespace dynamy {

inline constexpr double kImpactSteps = 4.0;

}  // namespace dynamy
