/// Elements that offer a law its normal row alone refuse friction that could never act.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

/// Whether the law, offered a tangent, answers slip with a force there: Λ_T ≠ 0 from Λ = 0 and
/// ξ = (−1, −1). A law with μ = 0 does not.
bool hasFriction(const SetValuedForceLaw& law);

}  // namespace dynamy
