/// Information: what the derivatives of the residuals tell about the unknowns near a minimum.
///
///   C = (JᵀJ)⁻¹ on the unknowns that are identifiable
///
/// An unknown whose column is rounding is not seen. Of the others, with columns of length 1, the
/// null space of J holds combinations that leave every residual as it is; unknowns with a part in
/// them cannot be told apart.
#pragma once
#include <dynamy/simulation/fit/fit_problem.hpp>

namespace dynamy {

struct Information {
  Eigen::MatrixXd J, covariance;         ///< zero: of unknowns that are not identifiable
  Eigen::MatrixXd inverse;               ///< of JᵀJ, generalised: without its null space
  std::vector<char> seen, identifiable;  ///< by unknown
  std::vector<std::string> open;         ///< what is not determined, a sentence each
  int rank = 0;
};

/// Unknowns on which the residuals depend, by the derivatives J at x, where the problem was evaluated
/// last.
std::vector<char> seenUnknowns(FitProblem& problem, const Eigen::VectorXd& x,
                               const Eigen::MatrixXd& J);

/// At x, where the problem was evaluated last.
Information informationAt(FitProblem& problem, const Eigen::VectorXd& x);

/// "mu", or "v0[throw 2]" for a value of a run.
std::string unknownName(const FitProblem& problem, int unknown);

}  // namespace dynamy
