/// Starts of slip in space (theory 20.6). A slip in several rows that has just begun has no
/// direction of γ_T yet; it has that of γ̇_T, which turns until γ_T is clear.
///
///   turned     ∫ |γ_T| dθ ≤ 10 tol U over the directions t while the slip starts
///   clear      |γ_T| > |γ̇_T| h, and its part across t is at most 10 tol U
///   stopped    γ_T·t ≤ 0: the slip that started has ended. Its friction, along t whatever γ_T is, hides
///              that from the errors of a step
#pragma once
#include <dynamy/located/step/located_parts.hpp>

namespace dynamy {

/// How far the directions of starting slips have turned since `before`, over the allowed turn; adds
/// their turns to the held contacts of the phase.
double turnOfStarts(LocatedParts& parts, const std::vector<Held>& before);
/// True: at the end of a trial a slip that started has passed its end.
bool startsPassTheirEnd(const LocatedParts& parts);
/// Ends the starting phase of slips that have a clear direction at step.from, for a step of length
/// h, which a trial of this length has turned too far.
Refusal endClearStarts(LocatedStep& step, double h);
/// Ends the starting phase of slips at the end of an accepted step. True: some.
bool endStarts(LocatedParts& parts);

}  // namespace dynamy
