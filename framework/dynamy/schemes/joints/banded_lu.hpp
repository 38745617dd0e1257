/// BandedLu: LU of a band matrix with row pivoting; takes memory only when it grows.
///
///   A = P L U,   a_ij = 0 for j < i − b or j > i + b;   row pivoting widens U to 2b
///
/// Bodies and joints in the order of a walk along the mechanism give a small band. Pivoting is
/// needed: the rows of joints have zeros on the diagonal. A sparse LU with a fixed order of pivots
/// was rejected for that reason. A may fall into parts that do not meet, a_ij = 0 for i and j in
/// different parts: each is factorised and solved on its own.
#pragma once
#include <span>
#include <vector>

namespace dynamy {

class BandedLu {
 public:
  /// n × n zeros with half band width b; ends: where each part ends, ascending, the last one at n.
  void reset(int n, int b, std::span<const int> ends);
  double& at(int i, int j) {
    return a_[static_cast<std::size_t>(i) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(j - i + b_)];
  }
  /// False: singular.
  bool factor();
  /// x ← A⁻¹ x.
  void solve(double* x) const { solve(x, 0, n_, 1); }
  /// X ← A⁻¹ X in rows first ≤ i < last of whole parts; X: n × columns, row after row.
  void solve(double* X, int first, int last, int columns) const;
  int size() const { return n_; }

 private:
  template <int N>
  void solveColumns(double* X, int first, int last, int columns) const;
  int n_ = 0, b_ = 0, width_ = 0;
  std::vector<double> a_;  // row i: columns i − b … i + 2b; holds U
  std::vector<double> l_;  // column k of L below its diagonal, b numbers each
  std::vector<int> end_;   // of the part that a row is in
  std::vector<int> pivot_;
  std::vector<int> last_;   // column of the last entry of a row that may differ from zero
  std::vector<int> below_;  // entries of a column of L until the last that differs from zero
};

}  // namespace dynamy
