/// What elements refuse of a law, since it could not act: friction, where they offer its normal row
/// only; laws that need a gap or hold a position, where they offer rates of a joint.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

/// Does the law, when it is offered a tangent, respond to slip with a force: Λ_T ≠ 0 from Λ = 0 and
/// ξ = (−1, −1)? A law with μ = 0 does not.
bool hasFriction(const SetValuedForceLaw& law);

/// Throws ModelError unless the law acts on the rates of a joint, without a gap or a position.
void requireLawOfRates(const SetValuedForceLaw& law);

}  // namespace dynamy
