/// BlockLu: sparse LU of a matrix of n × n blocks of size B, without pivoting across blocks.
///
///   K = L U,   D_m = K_mm − Σ_k L_mk U_km,   L_jm = (K_jm − Σ_k L_jk U_km) D_m⁻¹,
///                                            U_mj =  K_mj − Σ_k L_mk U_kj
///
/// The factors are computed column by column (left-looking); blocks are ordered by approximate
/// minimum degree of the symmetrised pattern. The pattern is analysed once and kept while it stays
/// the same. L and Uᵀ have the same pattern and the same updates, which are computed side by side.
/// Pivot blocks are inverted with row pivoting inside the block. Eigen::SparseLU was rejected: its
/// scalar pivoting destroys the block structure, and it allocates at every factorisation.
#pragma once
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <dynamy/solver/newton/block_products.hpp>
#include <utility>
#include <vector>

namespace dynamy {

/// K ← K⁻¹ by Gauss–Jordan elimination with row pivoting, unrolled for its size (a general LU
/// spends most of its time on bookkeeping at 6 × 6); false: singular. Rows may have different
/// units: an entry is judged by K_ik²/K_ii, so that the choice does not depend on them.
inline constexpr double kNoDiagonal = 1e-8;
template <int B>
bool invert(Eigen::Matrix<double, B, B>& K) {
  int pivots[B];
  Eigen::Matrix<double, B, 1> scale = K.diagonal().cwiseAbs();
  for (int k = 0; k < B; ++k)  // a diagonal that is zero or rounding gives no scale
    scale[k] = std::max(scale[k], kNoDiagonal * K.row(k).cwiseAbs().maxCoeff());
  for (int k = 0; k < B; ++k) {
    int pivot = k;
    double largest = -1.0;
    for (int i = k; i < B; ++i) {
      const double value = K(i, k) * K(i, k) / scale[i];
      if (value > largest) largest = value, pivot = i;
    }
    if (!(std::abs(K(pivot, k)) > 0.0)) return false;
    std::swap(scale[pivot], scale[k]);
    pivots[k] = pivot;
    if (pivot != k) K.row(pivot).swap(K.row(k));
    const double inverse = 1.0 / K(k, k);
    const Eigen::Matrix<double, 1, B> row = K.row(k) * inverse;
    const Eigen::Matrix<double, B, 1> column = K.col(k);
    K.noalias() -= column * row;
    K.row(k) = row;
    K.col(k) = -column * inverse;
    K(k, k) = inverse;
  }
  for (int k = B - 1; k >= 0; --k)
    if (pivots[k] != k) K.col(k).swap(K.col(pivots[k]));
  return true;
}

template <int B>
class BlockLu {
 public:
  using Matrix = Eigen::Matrix<double, B, B>;
  using Vector = Eigen::Matrix<double, B, 1>;

  /// Analyses a pattern given by rows: the columns of row i are column[first[i]] …
  /// column[first[i+1]−1]. The last analysis is kept if the pattern is the same. False: L would
  /// have more than `limit` blocks (by default 18 million numbers); nothing can be factored then.
  bool analyse(const std::vector<int>& first, const std::vector<int>& column,
               std::size_t limit = 18'000'000 / (B * B)) {
    if (first == first_ && column == column_) return true;
    first_ = first, column_ = column;
    order();
    if (!eliminate(limit)) {
      first_.clear();
      return false;
    }
    linkRows();
    return true;
  }
  void setZero() {
    for (Matrix& m : D_) m.setZero();
    for (Matrix& m : L_) m.setZero();
    for (Matrix& m : U_) m.setZero();
  }
  /// Block (i, j) of the pattern, numbered as given to analyse(). L_jm and U_mj lie at the same
  /// place.
  Matrix& at(int i, int j) {
    const int a = position_[i], b = position_[j];
    if (a == b) return D_[a];
    const int m = std::min(a, b), other = std::max(a, b);
    const auto begin = below_.begin() + start_[m], end = below_.begin() + start_[m + 1];
    const auto at = std::lower_bound(begin, end, other) - below_.begin();
    return a > b ? L_[static_cast<std::size_t>(at)] : U_[static_cast<std::size_t>(at)];
  }
  /// False: a pivot is singular.
  bool factor();
  /// x ← K⁻¹ x, blocks numbered as given to analyse().
  void solve(std::vector<Vector>& x);
  /// Numbers in L, U and D.
  long entries() const { return static_cast<long>(L_.size() * 2 + D_.size()) * B * B; }
  long analyses() const { return analyses_; }

 private:
  using Lane = Eigen::Array2d;
  int size() const { return static_cast<int>(first_.size()) - 1; }
  /// Stores block e of L beside that of Uᵀ, number by number, so that one product of pairs updates
  /// both.
  void pack(int e);
  void order();
  bool eliminate(std::size_t limit);
  void linkRows();

  std::vector<int> first_, column_;
  std::vector<int> order_, position_;     // k-th pivot is block order_[k]
  std::vector<int> start_, below_;        // rows below pivot m
  std::vector<int> rowStart_, rowEntry_;  // entries (k, m) of row m of L, k ascending
  std::vector<int> rowPivot_;
  std::vector<Matrix> L_, U_, D_;
  std::vector<Lane> pairs_;
  std::vector<int> place_;
  std::vector<Vector> work_;
  SubtractProducts subtract_ = productLevels<B>().back();
  long analyses_ = 0;
};

template <int B>
void BlockLu<B>::order() {
  const int n = size();
  ++analyses_;
  std::vector<Eigen::Triplet<double>> entry;
  for (int i = 0; i < n; ++i) {
    entry.emplace_back(i, i, 1.0);
    for (int e = first_[i]; e < first_[i + 1]; ++e) {
      entry.emplace_back(i, column_[e], 1.0);
      entry.emplace_back(column_[e], i, 1.0);
    }
  }
  Eigen::SparseMatrix<double> pattern(n, n);
  pattern.setFromTriplets(entry.begin(), entry.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> P;
  Eigen::AMDOrdering<int>()(pattern, P);
  order_.resize(n), position_.resize(n);
  for (int k = 0; k < n; ++k) {
    order_[k] = P.indices()[k];
    position_[order_[k]] = k;
  }
}

template <int B>
bool BlockLu<B>::eliminate(std::size_t limit) {
  // Rows below pivot m: those of K, and those of the pivots whose first row is m.
  const int n = size();
  std::vector<std::vector<int>> own(n), children(n);
  for (int i = 0; i < n; ++i)
    for (int e = first_[i]; e < first_[i + 1]; ++e) {
      const int a = position_[i], b = position_[column_[e]];
      if (a != b) own[std::min(a, b)].push_back(std::max(a, b));
    }
  start_.assign(1, 0), below_.clear();
  std::vector<int> seen(n, -1);
  for (int m = 0; m < n; ++m) {
    const auto begin = static_cast<std::ptrdiff_t>(below_.size());
    const auto add = [&](int row) {
      if (row > m && seen[row] != m) seen[row] = m, below_.push_back(row);
    };
    for (const int row : own[m]) add(row);
    for (const int child : children[m])
      for (int e = start_[child]; e < start_[child + 1]; ++e) add(below_[e]);
    std::sort(below_.begin() + begin, below_.end());
    start_.push_back(static_cast<int>(below_.size()));
    if (below_.size() > limit) return false;
    if (begin < static_cast<std::ptrdiff_t>(below_.size()))
      children[below_[static_cast<std::size_t>(begin)]].push_back(m);
  }
  L_.resize(below_.size()), U_.resize(below_.size()), D_.resize(n);
  pairs_.resize(below_.size() * B * B);
  place_.resize(n), work_.resize(n);
  return true;
}

template <int B>
void BlockLu<B>::linkRows() {
  const int n = size();
  rowStart_.assign(static_cast<std::size_t>(n) + 1, 0);
  for (const int row : below_) ++rowStart_[row + 1];
  for (int m = 0; m < n; ++m) rowStart_[m + 1] += rowStart_[m];
  rowEntry_.resize(below_.size()), rowPivot_.resize(below_.size());
  std::vector<int> fill(rowStart_.begin(), rowStart_.end() - 1);
  for (int k = 0; k < n; ++k)
    for (int e = start_[k]; e < start_[k + 1]; ++e) {
      const int at = fill[below_[e]]++;
      rowEntry_[at] = e, rowPivot_[at] = k;
    }
}

template <int B>
void BlockLu<B>::pack(int e) {
  Lane* X = pairs_.data() + static_cast<std::ptrdiff_t>(e) * B * B;
  for (int c = 0; c < B; ++c)
    for (int r = 0; r < B; ++r) X[c * B + r] = Lane(L_[e](r, c), U_[e](c, r));
}

template <int B>
bool BlockLu<B>::factor() {
  const int n = size();
  Lane K[B * B];
  for (int m = 0; m < n; ++m) {
    for (int e = start_[m]; e < start_[m + 1]; ++e) place_[below_[e]] = e, pack(e);
    for (int r = rowStart_[m]; r < rowStart_[m + 1]; ++r) {
      const int e = rowEntry_[r], end = start_[rowPivot_[r] + 1];
      D_[m].noalias() -= L_[e] * U_[e];
      for (int c = 0; c < B; ++c)
        for (int k = 0; k < B; ++k) K[c * B + k] = Lane(U_[e](k, c), L_[e](c, k));
      const Lane* from = pairs_.data() + (static_cast<std::ptrdiff_t>(e) + 1) * B * B;
      subtract_(pairs_.data()->data(), place_.data(), below_.data() + e + 1, end - e - 1,
                from->data(), K->data());
    }
    if (!invert<B>(D_[m]) || !D_[m].allFinite()) return false;
    for (int e = start_[m]; e < start_[m + 1]; ++e) {
      Lane* X = pairs_.data() + static_cast<std::ptrdiff_t>(e) * B * B;
      Matrix L;
      for (int c = 0; c < B; ++c)
        for (int r = 0; r < B; ++r) L(r, c) = X[c * B + r][0], U_[e](c, r) = X[c * B + r][1];
      L_[e].noalias() = L * D_[m];
      for (int c = 0; c < B; ++c)
        for (int r = 0; r < B; ++r) X[c * B + r][0] = L_[e](r, c);
    }
  }
  return true;
}

template <int B>
void BlockLu<B>::solve(std::vector<Vector>& x) {
  const int n = size();
  for (int k = 0; k < n; ++k) work_[k] = x[order_[k]];
  for (int k = 0; k < n; ++k)
    for (int e = start_[k]; e < start_[k + 1]; ++e) work_[below_[e]].noalias() -= L_[e] * work_[k];
  for (int k = n - 1; k >= 0; --k) {
    for (int e = start_[k]; e < start_[k + 1]; ++e) work_[k].noalias() -= U_[e] * work_[below_[e]];
    work_[k] = (D_[k] * work_[k]).eval();
  }
  for (int k = 0; k < n; ++k) x[order_[k]] = work_[k];
}

}  // namespace dynamy
