/// LeastSquares: the minimum of a sum of squares, by the method of Levenberg and Marquardt:
///
///   min ½ |r(x)|²,   lower ≤ x ≤ upper
///
/// Ceres does it, in a library of its own (framework/optimiser), which is loaded when it is first
/// needed: neither plug-ins nor programs that fit nothing have to do with it. Rejected: linking it,
/// with which every start of the program took 4 ms longer, a third.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace dynamy {

struct LeastSquares {
  /// Some residuals, and the unknowns on which they depend.
  struct Block {
    std::vector<int> of;  ///< unknowns
    int residuals = 0;
    /// x: values of the unknowns `of`; J: derivatives, one row per residual, or null. False: there
    /// are no residuals at x.
    std::function<bool(const double* x, double* r, double* J)> evaluate;
  };
  std::vector<Block> blocks;
  Eigen::VectorXd lower, upper;  ///< −∞, ∞: no bound
  std::vector<char> fixed;       ///< unknowns that keep their values; empty: none
  int iterations = 100;          ///< at most
  double sum = 1e-10;            ///< relative change of the sum below which the search ends
};

struct LeastSquaresEnd {
  bool converged = false;
  int iterations = 0;
  std::string why;  ///< it has ended
};

/// Moves x to a minimum. Throws ModelError if this build is without Ceres.
LeastSquaresEnd minimise(const LeastSquares& problem, Eigen::VectorXd& x);

/// What the library of the optimiser offers under the name `dynamyMinimise`.
using Minimiser = void(const LeastSquares& problem, Eigen::VectorXd& x, LeastSquaresEnd& end);

}  // namespace dynamy
