/// The scale of velocities and the rounding of an inclusion problem, by which solvers know when it is
/// solved.
#pragma once
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

/// What the scales of a problem are taken from.
struct VelocityScales {
  const Eigen::VectorXd &uA, &uFree;  ///< nu numbers each
  double gTol;                        ///< closed: g ≤ gTol [m]
  double gapNoise;                    ///< rounding of the rates that aim at gaps [m/s]
};

/// Sets cNoise and uRef of `p`; `work` gets nu numbers. True: no contact requires a velocity beyond
/// rounding, and Λ = 0 solves the problem.
bool setScales(const VelocityScales& from, InclusionProblem& p, Eigen::VectorXd& work);

}  // namespace dynamy
