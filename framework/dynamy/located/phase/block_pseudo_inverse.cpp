#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/block_pseudo_inverse.hpp>

namespace dynamy {
namespace {

/// Smaller matrices are decomposed whole: they cost less than an evaluation of the bodies.
constexpr Eigen::Index kWhole = 24;
/// Least pivot of a regular block, whose rows and columns are of size 1: four digits above those
/// that may belong to redundant rows.
constexpr double kRegular = 1e-6;
/// Rows are implied by others if pivots fall from above the second to below the first.
constexpr double kImplied = 1e-11, kIndependent = 1e-4;
/// Of a row's terms: what an implied row may miss. Its own rounding is 1e-16 times the forces that
/// cancel.
constexpr double kMissed = 1e-11;
constexpr double kOrthogonal = 3.0;  ///< time of an orthogonal decomposition over that of triangles
constexpr int kRefined = 2;  ///< corrections, of a factor of 1e-16 over the square of kRegular each

}  // namespace

/// Makes rows of size 1. False: some are zero or not finite.
bool BlockPseudoInverse::Block::scale() {
  rowScale = A.rowwise().norm(), scaled = A;
  if (!(A.rows() > 0 && rowScale.minCoeff() > 0.0 && rowScale.allFinite())) return false;
  rowScale = rowScale.cwiseInverse();
  scaled.array().colwise() *= rowScale.array();
  return true;
}

void BlockPseudoInverse::Block::compute() {
  by = By::orthogonal;
  if (scale()) {
    if (!independent.empty() && computeIndependent()) {
      by = By::independent;
      return;
    }
    columnScale = scaled.colwise().norm();
    if (columnScale.minCoeff() > 0.0) {
      columnScale = columnScale.cwiseInverse();
      lu.compute(scaled * columnScale.asDiagonal());
      if (lu.matrixLU().diagonal().cwiseAbs().minCoeff() > kRegular) by = By::triangles;
    }
  }
  if (by == By::orthogonal) inverse.compute(A);
}

/// False: the rows that were thought independent are not.
bool BlockPseudoInverse::Block::computeIndependent() {
  chosen = scaled(independent, Eigen::all);
  square.setZero(chosen.rows(), chosen.rows());
  square.selfadjointView<Eigen::Lower>().rankUpdate(chosen);
  llt.compute(square);
  return llt.info() == Eigen::Success && llt.matrixLLT().diagonal().minCoeff() > kRegular;
}

/// False: the other rows do not follow.
bool BlockPseudoInverse::Block::solveIndependent(const Eigen::VectorXd& of, Eigen::VectorXd& to) {
  rest = of.cwiseProduct(rowScale);
  const double asked = rest.lpNorm<Eigen::Infinity>();
  to.setZero(scaled.cols());
  for (int turn = 0; turn <= kRefined; ++turn) {
    y = rest(independent);
    llt.solveInPlace(y);
    to.noalias() += chosen.transpose() * y;
    rest = of.cwiseProduct(rowScale);
    rest.noalias() -= scaled * to;
  }
  return rest.lpNorm<Eigen::Infinity>() <= kMissed * (asked + to.lpNorm<Eigen::Infinity>());
}

void BlockPseudoInverse::Block::solve(const Eigen::VectorXd& of, Eigen::VectorXd& to) {
  if (by == By::independent) {
    if (solveIndependent(of, to)) return;
    by = By::orthogonal;
    inverse.compute(A);
  }
  if (by == By::orthogonal) {
    inverse.solve(of, to);
    return;
  }
  to = of.cwiseProduct(rowScale);
  to = lu.solve(to).eval();
  to.array() *= columnScale.array();
}

Eigen::Index BlockPseudoInverse::Block::rank() const {
  if (by == By::independent) return static_cast<Eigen::Index>(independent.size());
  return by == By::triangles ? rowScale.size() : inverse.rank();
}

/// Finds the blocks of A.
void BlockPseudoInverse::divide(const Eigen::MatrixXd& A) {
  const auto m = static_cast<int>(A.rows());
  blocks_ = 0;
  blockOf_.assign(static_cast<std::size_t>(m), -1);
  for (int first = 0; first < m; ++first) {
    if (blockOf_[static_cast<std::size_t>(first)] >= 0) continue;
    const int block = blocks_++;
    waiting_.assign(1, first), blockOf_[static_cast<std::size_t>(first)] = block;
    while (!waiting_.empty()) {
      const int i = waiting_.back();
      waiting_.pop_back();
      for (int j = first + 1; j < m; ++j) {
        int& of = blockOf_[static_cast<std::size_t>(j)];
        if (of < 0 && (A(i, j) != 0.0 || A(j, i) != 0.0)) of = block, waiting_.push_back(j);
      }
    }
  }
}

/// Lists the rows of each block.
void BlockPseudoInverse::list(int rows) {
  while (static_cast<int>(block_.size()) < blocks_) block_.emplace_back(threshold_);
  for (int k = 0; k < blocks_; ++k) block_[static_cast<std::size_t>(k)].rows.clear();
  local_.resize(static_cast<std::size_t>(rows));
  for (int i = 0; i < rows; ++i) {
    std::vector<int>& of =
        block_[static_cast<std::size_t>(blockOf_[static_cast<std::size_t>(i)])].rows;
    local_[static_cast<std::size_t>(i)] = static_cast<int>(of.size());
    of.push_back(i);
  }
}

void BlockPseudoInverse::begin(std::span<const int> group) {
  const auto m = static_cast<int>(group.size());
  blocks_ = 0, blockOf_.resize(group.size());
  if (m < kWhole) {
    blockOf_.assign(group.size(), 0), blocks_ = 1;
  } else {
    waiting_.assign(group.size(), -1);  // block of each group
    for (std::size_t i = 0; i < group.size(); ++i) {
      int& block = waiting_[static_cast<std::size_t>(group[i])];
      if (block < 0) block = blocks_++;
      blockOf_[i] = block;
    }
  }
  list(m);
  for (int k = 0; k < blocks_; ++k) {
    Block& block = block_[static_cast<std::size_t>(k)];
    const auto n = static_cast<Eigen::Index>(block.rows.size());
    block.A.setZero(n, n);
  }
}

void BlockPseudoInverse::compute(const Eigen::MatrixXd& A, std::span<const char> implied) {
  const auto m = static_cast<int>(A.rows());
  if (m >= kWhole)
    divide(A);
  else
    blockOf_.assign(static_cast<std::size_t>(m), 0), blocks_ = 1;
  list(m);
  for (int k = 0; k < blocks_; ++k) {
    Block& block = block_[static_cast<std::size_t>(k)];
    if (blocks_ == 1)
      block.A = A;
    else
      block.A = A(block.rows, block.rows);
  }
  compute(implied);
}

void BlockPseudoInverse::compute(std::span<const char> implied) {
  double largest = 0.0;
  for (int k = 0; k < blocks_; ++k) {
    Block& block = block_[static_cast<std::size_t>(k)];
    block.independent.clear();
    for (std::size_t i = 0; i < block.rows.size() && !implied.empty(); ++i)
      if (implied[static_cast<std::size_t>(block.rows[i])] == 0)
        block.independent.push_back(static_cast<int>(i));
    if (block.independent.size() == block.rows.size()) block.independent.clear();
    block.size = block.A.size() > 0 ? block.A.colwise().squaredNorm().maxCoeff() : 0.0;
    largest = std::max(largest, block.size);
  }
  const double least = blocks_ > 1 ? threshold_ * std::sqrt(largest) : -1.0;
  for (int k = 0; k < blocks_; ++k) {
    Block& block = block_[static_cast<std::size_t>(k)];
    block.counts = !(std::sqrt(block.size) <= least);
    if (block.counts) block.compute();
  }
}

Eigen::MatrixXd BlockPseudoInverse::matrix() const {
  const auto m = static_cast<Eigen::Index>(blockOf_.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(m, m);
  for (int k = 0; k < blocks_; ++k) {
    const Block& block = block_[static_cast<std::size_t>(k)];
    out(block.rows, block.rows) = block.A;
  }
  return out;
}

Eigen::Index BlockPseudoInverse::rank() const {
  Eigen::Index rank = 0;
  for (int k = 0; k < blocks_; ++k)
    if (const Block& block = block_[static_cast<std::size_t>(k)]; block.counts)
      rank += block.rank();
  return rank;
}

double BlockPseudoInverse::cubes() const {
  double sum = 0.0;
  for (int k = 0; k < blocks_; ++k) {
    const Block& block = block_[static_cast<std::size_t>(k)];
    const auto n = static_cast<double>(block.rows.size());
    sum += n * n * n * (block.by == Block::By::orthogonal ? kOrthogonal : 1.0);
  }
  return sum;
}

void BlockPseudoInverse::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  if (blocks_ == 1) {
    block_[0].solve(b, x);
    return;
  }
  x.setZero(b.size());
  for (int k = 0; k < blocks_; ++k) {
    Block& block = block_[static_cast<std::size_t>(k)];
    if (!block.counts) continue;
    block.b = b(block.rows);
    block.solve(block.b, block.x);
    x(block.rows) = block.x;
  }
}

void BlockPseudoInverse::findImplied(std::vector<char>& implied) const {
  for (int k = 0; k < blocks_; ++k) {
    const Block& block = block_[static_cast<std::size_t>(k)];
    if (!block.counts || block.by != Block::By::orthogonal || block.rows.empty()) continue;
    if (block.rowScale.size() != static_cast<Eigen::Index>(block.rows.size())) continue;
    const std::vector<int> independent =
        independentColumns(block.scaled.transpose(), kImplied, kIndependent);
    if (independent.empty()) continue;
    for (std::size_t i = 0; i < block.rows.size(); ++i)
      if (!std::binary_search(independent.begin(), independent.end(), static_cast<int>(i)))
        implied[static_cast<std::size_t>(block.rows[i])] = 1;
  }
}

}  // namespace dynamy
