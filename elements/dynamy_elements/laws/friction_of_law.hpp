/// Test for elements that offer a law its normal row only: they refuse
/// friction, which could not act.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

/// Does the law, when it is offered a tangent, respond to slip with a force: Λ_T ≠ 0 from Λ = 0 and
/// ξ = (−1, −1)? A law with μ = 0 does not.
bool hasFriction(const SetValuedForceLaw& law);

}  // namespace dynamy
