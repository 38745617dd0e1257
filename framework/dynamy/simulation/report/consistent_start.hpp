/// ConsistentStart: projects the initial state of a model onto its joints in the metric of the
/// mass, for every scheme (theory 34.3):
///
///   positions    min ½ δᵀMδ  with  g + Wᵀδ = 0,  q ← q ⊕ δ,  with W at the new place until g = 0
///   velocities   min ½ δᵀMδ  with  Wᵀ(u + δ) + χ = 0:   M δ = WΛ
///
/// g and W belong to the rows that hold γ = 0 with any force it takes (`holds`), including moving
/// joints and drives (χ ≠ 0). Redundant rows share the correction. Rows that contradict each other
/// keep an error, which is reported; positions that cannot be met stay as the model gives them. The
/// velocities are those after an impact of the joints alone; a model that gives velocities and
/// joints implies nothing else.
///
/// Velocities that the model keeps (`keep` of `<simulation>`) have δ = 0: the metric is that of the
/// others, P M⁻¹ P in place of M⁻¹ with the projection P that removes the kept ones. A machine is
/// thereby assembled from the place and the speed of its crank.
///
/// Rejected: to leave the correction to the first step. A scheme on velocity level meets γ^E = 0
/// and books the loss as its own error; a scheme that meets γ^A + γ^E = 0 oscillates for ever; a
/// scheme with a tolerance projects without a report. Also rejected: to refuse the model, because
/// the numbers of a file are rounded.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/run_report.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Makes `x` consistent. Slot 0 of `s` is evaluated at `x` before the call and after it. Leaves `x`
/// unchanged if no joint is off by more than rounding, or if masses or gaps are not numbers, which
/// the run reports.
StartReport makeConsistent(const Model& model, MechanicalSystem& s, State& x);

/// Velocities of a system, or the one velocity or coordinate, of this name; empty: there is none.
std::vector<int> velocitiesNamed(const Model& model, std::string_view name);
/// All names that velocitiesNamed() knows.
std::vector<std::string> keptNames(const Model& model);

/// The warnings about the start, of the kinds "start velocities", "start positions",
/// "contradiction".
std::vector<Warning> startWarnings(const StartReport& start, double sceneLength);

}  // namespace dynamy
