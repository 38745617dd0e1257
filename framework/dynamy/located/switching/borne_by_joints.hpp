/// Contacts at places that joints hold, such as a corner on a hinge (theory 34.4).
///
///   wᵀ K⁻¹ w ≤ 1e-8 wᵀ M⁻¹ w,   K⁻¹ = M⁻¹ − M⁻¹W_J (W_Jᵀ M⁻¹ W_J)⁻¹ W_Jᵀ M⁻¹
///
/// No motion that the joints W_J allow changes such a gap, and a force along w does nothing that
/// they could not do. Held with the joints, the contact would share their forces, and the sign of
/// its share would be no switch of any motion.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>
#include <vector>

namespace dynamy {

/// The keys of these contacts, in the order of the evaluation.
void borneByJoints(const Evaluation& at, std::vector<ContactKey>& out);

}  // namespace dynamy
