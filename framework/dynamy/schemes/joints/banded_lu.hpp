/// BandedLu: LU of a band matrix with row pivoting; it allocates memory only for a larger matrix.
///
///   A = P L U,   a_ij = 0 for j < i − b or j > i + b;   row pivoting widens U to 2b
///
/// Bodies and joints in the order of a walk along the mechanism give a small band. Pivoting is
/// needed, since the rows of joints have zeros on the diagonal. A sparse LU with a fixed order of
/// pivots was rejected for that reason. A may consist of uncoupled parts, a_ij = 0 for i and j in
/// different parts: each part is factorised and solved on its own.
#pragma once
#include <span>
#include <vector>

namespace dynamy {

class BandedLu {
 public:
  /// Starts an n × n matrix of zeros with half band width b. ends: end of each part, ascending, the
  /// last one n.
  void reset(int n, int b, std::span<const int> ends);
  double& at(int i, int j) {
    return a_[static_cast<std::size_t>(i) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(j - i + b_)];
  }
  /// False: singular.
  bool factor();
  /// x ← A⁻¹ x.
  void solve(double* x) const { solve(x, 0, n_, 1); }
  /// X ← A⁻¹ X in rows first ≤ i < last, which are whole parts; X: n × columns, stored row by row.
  void solve(double* X, int first, int last, int columns) const;
  int size() const { return n_; }
  /// Multiplications of all calls of factor() and solve().
  double multiplications() const { return multiplications_; }

 private:
  template <int N>
  void solveColumns(double* X, int first, int last, int columns) const;
  int n_ = 0, b_ = 0, width_ = 0;
  std::vector<double> a_;  // row i: columns i − b … i + 2b; holds U
  std::vector<double> l_;  // column k of L below its diagonal, b numbers each
  std::vector<int> end_;   // per row: end of its part
  std::vector<int> pivot_;
  std::vector<int> last_;   // per row: column of its last entry that may differ from zero
  std::vector<int> below_;  // per column of L: number of entries up to the last nonzero one
  mutable double multiplications_ = 0.0;
};

}  // namespace dynamy
