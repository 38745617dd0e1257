/// BandedLu: LU of a band matrix with row pivoting; takes memory only when it grows.
///
///   A = P L U,   a_ij = 0 for j < i − b or j > i + b;   row pivoting widens U to 2b
///
/// Bodies and joints in the order of a walk along the mechanism give a small band. Pivoting is
/// needed: the rows of joints have zeros on the diagonal. A sparse LU with a fixed order of pivots
/// was rejected for that reason.
#pragma once
#include <vector>

namespace dynamy {

class BandedLu {
 public:
  /// n × n zeros with half band width b.
  void reset(int n, int b);
  double& at(int i, int j) {
    return a_[static_cast<std::size_t>(i) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(j - i + b_)];
  }
  /// False: singular.
  bool factor();
  /// x ← A⁻¹ x.
  void solve(double* x) const;
  int size() const { return n_; }

 private:
  int n_ = 0, b_ = 0, width_ = 0;
  std::vector<double> a_;  // row i: columns i − b … i + 2b
  std::vector<int> pivot_;
  std::vector<int> last_;  // column of the last entry of a row that may differ from zero
};

}  // namespace dynamy
