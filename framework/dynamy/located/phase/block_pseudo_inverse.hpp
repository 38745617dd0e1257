/// BlockPseudoInverse: A⁺ b for a matrix A that falls into blocks (theory 50.1).
///
///   rows and columns i, j with A_ij ≠ 0 are in one block:   A⁺ = Σ A_b⁺,   m³ → Σ m_b³
///
/// Held rows of mechanisms that share no body are in different blocks. A block that is regular by far
/// is divided into triangles with partial pivoting, which costs a fifth of a complete orthogonal
/// decomposition.
#pragma once
#include <Eigen/Dense>
#include <dynamy/core/decompositions.hpp>
#include <vector>

namespace dynamy {

/// Of a square matrix. Pivots below `threshold` times the largest of their block count as zero, and
/// so does a block whose largest column is below this share of the largest column of A.
class BlockPseudoInverse {
 public:
  explicit BlockPseudoInverse(double threshold) : threshold_(threshold) {}
  void compute(const Eigen::MatrixXd& A);
  Eigen::Index rank() const { return rank_; }
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  /// Blocks that the last matrix was divided into.
  int blocks() const { return blocks_; }

 private:
  void divide(const Eigen::MatrixXd& A);
  struct Block {
    explicit Block(double threshold) : inverse(threshold) {}
    void compute(const Eigen::MatrixXd& of);
    void solve(const Eigen::VectorXd& of, Eigen::VectorXd& to);
    Eigen::Index rank() const { return regular ? rowScale.size() : inverse.rank(); }
    std::vector<int> rows;  ///< of A, ascending
    bool counts = true;     ///< false: its entries are rounding
    bool regular = false;   ///< A = L U, else its inverse is `inverse`
    Eigen::MatrixXd A, scaled;
    Eigen::VectorXd b, x, rowScale, columnScale;
    Eigen::PartialPivLU<Eigen::MatrixXd> lu;  ///< of A with rows and columns of size 1
    PseudoInverse inverse;
  };
  double threshold_;
  int blocks_ = 0;
  Eigen::Index rank_ = 0;
  std::vector<int> blockOf_, waiting_;
  std::vector<Block> block_;  // the first blocks_ are in use
};

}  // namespace dynamy
