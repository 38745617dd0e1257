/// Aitken–Neville's table for results of a rule with n_j sub-steps whose error has all powers of
/// the sub-step (theory (51.3)):
///
///   T_{j,k+1} = T_{j,k} + (T_{j,k} − T_{j−1,k}) / (n_j/n_{j−k} − 1),   n_j = j
///
/// The harmonic sequence takes the fewest sub-steps for an order, N(N+1)/2.
#pragma once
#include <dynamy/core/types.hpp>
#include <vector>

namespace dynamy {

class Extrapolation {
 public:
  void begin() { row_ = 0; }
  /// Adds row j = 1, 2, … of the table by its first entry T_{j,1}.
  void add(const Eigen::VectorXd& first) {
    ++row_;
    while (static_cast<int>(T_.size()) < row_) T_.emplace_back();
    next_ = first;
    for (int k = 1; k < row_; ++k) {
      Eigen::VectorXd& last = T_[static_cast<std::size_t>(k - 1)];  // T_{j−1,k}, becomes T_{j,k}
      change_ = (next_ - last) / (static_cast<double>(row_) / (row_ - k) - 1.0);
      last = next_;
      next_ += change_;
    }
    T_[static_cast<std::size_t>(row_ - 1)] = next_;
  }
  /// T_{j,j}, the diagonal entry of the last row.
  const Eigen::VectorXd& result() const { return next_; }

 private:
  int row_ = 0;
  std::vector<Eigen::VectorXd> T_;  // T_{j,1} … T_{j,j}
  Eigen::VectorXd next_, change_;
};

}  // namespace dynamy
