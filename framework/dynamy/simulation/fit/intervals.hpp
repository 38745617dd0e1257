/// Intervals of the unknowns at a minimum: where χ² with all others at their best exceeds its
/// minimum by the square of the quantile (theory 56.3).
#pragma once
#include <dynamy/simulation/fit/information.hpp>
#include <optional>

namespace dynamy {

/// The quantile of 97.5 %: of Student's distribution with `freedom` degrees of freedom where
/// standard deviations are estimated, else of the normal distribution.
double quantile(bool estimated, int freedom);

class Intervals {
 public:
  /// `x`: the minimum, with the residuals r there. \pre the problem was evaluated last at x.
  Intervals(FitProblem& problem, const Information& information, const Eigen::VectorXd& x,
            double quantile);
  /// Fills in low, high and kind. False: χ² became smaller than at x, see better().
  bool find(int unknown, FittedParameter& out);
  const Eigen::VectorXd& better() const { return better_; }
  bool otherOrder(std::size_t run) const { return otherOrder_[run]; }

 private:
  enum class Side { low, high };
  /// χ² − minimum at x, if the others moved to their best by a linear step; ∞: no motion there.
  double rise(const Eigen::VectorXd& x, int unknown);
  bool quadratic(int unknown, double half);
  /// Root of the rise of the best χ² with this unknown held, minus the square of the quantile.
  std::optional<double> end(int unknown, double half, Side side);
  double profile(int unknown, Eigen::VectorXd& x);
  Eigen::VectorXd moved(int unknown, double by) const;
  bool inside(const Eigen::VectorXd& x) const;
  void lookAtOrder();

  FitProblem& problem_;
  const Information& information_;
  Eigen::VectorXd x_, better_;
  LeastSquares search_;
  double quantile_, least_;
  std::vector<bool> otherOrder_;
};

}  // namespace dynamy
