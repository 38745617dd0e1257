/// ConsistentStart: brings the state that a model begins with onto its joints, in the metric of the
/// mass, whatever the scheme (theory 34.3):
///
///   positions    min ½ δᵀMδ  with  g + Wᵀδ = 0,  q ← q ⊕ δ,  with W at the new place until g = 0
///   velocities   min ½ δᵀMδ  with  Wᵀ(u + δ) + χ = 0:   M δ = WΛ
///
/// g, W of rows that hold γ = 0 whatever it takes (`holds`), those of moving joints and drives
/// (χ ≠ 0) included. Rows that depend on each other share; what contradicts is left and reported,
/// positions that cannot be met as the model gives them. The velocities are the ones that an impact
/// of the joints alone would lead to; nothing else follows from a model that says both.
///
/// Rejected: to leave it to the first step. A scheme on velocity level meets γ^E = 0 and books the
/// loss as its own error, one that meets γ^A + γ^E = 0 swings for ever, one with a tolerance
/// projects in silence. To refuse the model: numbers of a file are rounded.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/run_report.hpp>

namespace dynamy {

/// Does it to `x`, at which slot 0 of `s` is evaluated, and is so again afterwards. Leaves `x` as
/// it is where nothing is off by more than rounding, and where masses or gaps are no numbers, which
/// the run reports.
StartReport makeConsistent(const Model& model, MechanicalSystem& s, State& x);

/// What it says about the start: kinds "start velocities", "start positions", "contradiction".
std::vector<Warning> startWarnings(const StartReport& start, double sceneLength);

}  // namespace dynamy
