/// f′(0) of f: double → VectorXd by central differences with the steps h, h/2, h/4 …, extrapolated
/// to step zero as a polynomial of h² [Neville]. For each entry the value in the table that differs
/// least from its neighbours is taken; `error` grows to the largest of these differences.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dynamy {

template <class F>
Eigen::VectorXd extrapolatedDerivative(const F& f, double h, double& error) {
  constexpr int kLevels = 7;  // number of steps, each half of the one before
  std::vector<Eigen::VectorXd> old, row;
  Eigen::VectorXd best, bound;
  for (int level = 0; level < kLevels; ++level, h *= 0.5) {
    row.assign(1, (f(h) - f(-h)) / (2.0 * h));
    if (level == 0) {
      best = row[0];
      bound = Eigen::VectorXd::Constant(best.size(), std::numeric_limits<double>::infinity());
    }
    double power = 1.0;
    for (std::size_t k = 1; k <= old.size(); ++k) {
      power *= 4.0;
      row.push_back(row[k - 1] + (row[k - 1] - old[k - 1]) / (power - 1.0));
      for (Eigen::Index i = 0; i < best.size(); ++i) {
        const double off =
            std::max(std::abs(row[k][i] - row[k - 1][i]), std::abs(row[k][i] - old[k - 1][i]));
        if (off < bound[i]) bound[i] = off, best[i] = row[k][i];
      }
    }
    old = row;
  }
  if (bound.size() > 0) error = std::max(error, bound.maxCoeff());
  return best;
}

}  // namespace dynamy
