#include <cmath>
#include <dynamy/located/phase/block_pseudo_inverse.hpp>

namespace dynamy {
namespace {

/// Smaller matrices are decomposed whole: they cost less than an evaluation of the bodies.
constexpr Eigen::Index kWhole = 24;
/// Least pivot of a regular block, whose rows and columns are of size 1: four digits above those
/// that may belong to redundant rows.
constexpr double kRegular = 1e-6;

}  // namespace

void BlockPseudoInverse::Block::compute(const Eigen::MatrixXd& of) {
  rowScale = of.rowwise().norm(), scaled = of;
  regular = of.rows() > 0 && rowScale.minCoeff() > 0.0 && rowScale.allFinite();
  if (regular) {
    rowScale = rowScale.cwiseInverse();
    scaled.array().colwise() *= rowScale.array();
    columnScale = scaled.colwise().norm();
    regular = columnScale.minCoeff() > 0.0;
  }
  if (regular) {
    columnScale = columnScale.cwiseInverse();
    scaled.array().rowwise() *= columnScale.transpose().array();
    lu.compute(scaled);
    regular = lu.matrixLU().diagonal().cwiseAbs().minCoeff() > kRegular;
  }
  if (!regular) inverse.compute(of);
}

void BlockPseudoInverse::Block::solve(const Eigen::VectorXd& of, Eigen::VectorXd& to) {
  if (!regular) {
    inverse.solve(of, to);
    return;
  }
  to = of.cwiseProduct(rowScale);
  to = lu.solve(to).eval();
  to.array() *= columnScale.array();
}

/// Finds the blocks of A.
void BlockPseudoInverse::divide(const Eigen::MatrixXd& A) {
  const auto m = static_cast<int>(A.rows());
  blocks_ = 0;
  blockOf_.assign(static_cast<std::size_t>(m), -1);
  for (int first = 0; first < m; ++first) {
    if (blockOf_[static_cast<std::size_t>(first)] >= 0) continue;
    const int block = blocks_++;
    if (static_cast<int>(block_.size()) < blocks_) block_.emplace_back(threshold_);
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
  for (int k = 0; k < blocks_; ++k) block_[static_cast<std::size_t>(k)].rows.clear();
  for (int i = 0; i < m; ++i)
    block_[static_cast<std::size_t>(blockOf_[static_cast<std::size_t>(i)])].rows.push_back(i);
}

void BlockPseudoInverse::compute(const Eigen::MatrixXd& A) {
  if (A.rows() >= kWhole)
    divide(A);
  else
    blocks_ = 1;
  if (blocks_ <= 1) {
    blocks_ = 1;
    if (block_.empty()) block_.emplace_back(threshold_);
    block_[0].compute(A);
    rank_ = block_[0].rank();
    return;
  }
  const double least = threshold_ * std::sqrt(A.colwise().squaredNorm().maxCoeff());
  rank_ = 0;
  for (int k = 0; k < blocks_; ++k) {
    Block& block = block_[static_cast<std::size_t>(k)];
    const auto m = static_cast<Eigen::Index>(block.rows.size());
    block.A.resize(m, m);
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index i = 0; i < m; ++i)
        block.A(i, j) =
            A(block.rows[static_cast<std::size_t>(i)], block.rows[static_cast<std::size_t>(j)]);
    block.counts = !(std::sqrt(block.A.colwise().squaredNorm().maxCoeff()) <= least);
    if (!block.counts) continue;
    block.compute(block.A);
    rank_ += block.rank();
  }
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
    const auto m = static_cast<Eigen::Index>(block.rows.size());
    block.b.resize(m);
    for (Eigen::Index i = 0; i < m; ++i) block.b[i] = b[block.rows[static_cast<std::size_t>(i)]];
    block.solve(block.b, block.x);
    for (Eigen::Index i = 0; i < m; ++i) x[block.rows[static_cast<std::size_t>(i)]] = block.x[i];
  }
}

}  // namespace dynamy
