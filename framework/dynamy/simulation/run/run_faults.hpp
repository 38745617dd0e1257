/// Why a run cannot go on from a step: states that are not finite, masses that are not positive
/// definite, inclusions that missed their tolerance, laws that throw. Texts name the element.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/run_report.hpp>

namespace dynamy {

/// True if the attempted state x holds no NaN and no infinity, no gap of the last evaluation is NaN,
/// no mass was indefinite and the scheme has not refused the scene.
bool isSound(const MechanicalSystem& system, const State& x, const StepReport& step);

/// Why x is not sound, with its time; empty: it is.
std::string faultOf(const Model& model, const MechanicalSystem& system, const State& x,
                    const StepReport& step);

/// The first force of the model that is not finite at time t [s] in the state x; null: none.
const ExternalForce* forceWithoutNumber(const Model& model, const State& x, double t);

/// Message of a run that ends at time t [s], because an inclusion missed its tolerance.
std::string missedTolerance(const Model& model, const MechanicalSystem& system, double t,
                            const SolveReport& solved);

/// Message of a run that ends in x because it has diverged (RunTrust::diverged); names the fastest
/// system and a remedy.
std::string divergence(const Model& model, const State& x, const RunTrust& trust);

/// Message of the first law of the last problem that throws, to explain an exception from a solver;
/// empty: none throws.
std::string lawThatThrows(const MechanicalSystem& system);

}  // namespace dynamy
