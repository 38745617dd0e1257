/// BlockPseudoInverse: A⁺ b for a matrix A that falls into blocks (theory 50.1).
///
///   rows and columns i, j with A_ij ≠ 0 are in one block:   A⁺ = Σ A_b⁺,   m³ → Σ m_b³
///
/// Held rows of mechanisms that share no body are in different blocks. A block that is regular by far
/// is divided into triangles with partial pivoting, which costs a fifth of a complete orthogonal
/// decomposition. Where it is known which rows the others imply, these others A_K alone are solved:
///
///   A_K x = b_K with the least |x|:   x = A_Kᵀ (A_K A_Kᵀ)⁻¹ b_K
///
/// which is A⁺b if all rows can be fulfilled. The implied rows are tested.
#pragma once
#include <Eigen/Dense>
#include <dynamy/core/decompositions.hpp>
#include <span>
#include <vector>

namespace dynamy {

/// Of a square matrix. Pivots below `threshold` times the largest of their block count as zero, and
/// so does a block whose largest column is below this share of the largest column of A.
class BlockPseudoInverse {
 public:
  explicit BlockPseudoInverse(double threshold) : threshold_(threshold) {}
  /// Begins a matrix of zeros, where A_ij stays 0 for rows with another entry in `group`.
  void begin(std::span<const int> group);
  /// A_ij of rows of one group, after begin().
  double& at(int i, int j) {
    Block& block = block_[static_cast<std::size_t>(blockOf_[static_cast<std::size_t>(i)])];
    return block.A(local_[static_cast<std::size_t>(i)], local_[static_cast<std::size_t>(j)]);
  }
  /// Decomposes the matrix that has been filled in since begin(). `implied`: for each row, not 0 if
  /// others are thought to imply it; empty: nothing is known.
  void compute(std::span<const char> implied = {});
  /// Decomposes A, whose blocks are found.
  void compute(const Eigen::MatrixXd& A, std::span<const char> implied = {});
  /// A.
  Eigen::MatrixXd matrix() const;
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  /// Rank of A, after solve().
  Eigen::Index rank() const;
  /// Σ n³ over its blocks of n rows, after solve(); one that is not regular costs three times as much.
  double cubes() const;
  /// Blocks that the last matrix was divided into.
  int blocks() const { return blocks_; }
  /// Marks the rows that others imply beyond doubt, in blocks that are not regular; one entry per row.
  void findImplied(std::vector<char>& implied) const;

 private:
  void divide(const Eigen::MatrixXd& A);
  void list(int rows);
  struct Block {
    enum class By : unsigned char { triangles, independent, orthogonal };
    explicit Block(double threshold) : inverse(threshold) {}
    void compute();
    void solve(const Eigen::VectorXd& of, Eigen::VectorXd& to);
    Eigen::Index rank() const;
    bool scale();
    bool computeIndependent();
    bool solveIndependent(const Eigen::VectorXd& of, Eigen::VectorXd& to);
    std::vector<int> rows;         ///< of A, ascending
    std::vector<int> independent;  ///< rows of the block that imply the others; empty: unknown
    bool counts = true;            ///< false: its entries are rounding
    By by = By::orthogonal;
    double size = 0.0;  ///< of its largest column, squared
    Eigen::MatrixXd A, scaled, chosen, square;
    Eigen::VectorXd b, x, y, rest, rowScale, columnScale;
    Eigen::PartialPivLU<Eigen::MatrixXd> lu;  ///< of A with rows and columns of size 1
    Eigen::LLT<Eigen::MatrixXd> llt;          ///< of A_K A_Kᵀ with rows of size 1
    PseudoInverse inverse;
  };
  double threshold_;
  int blocks_ = 0;
  std::vector<int> blockOf_, local_, waiting_;  // of each row; local_: its index in the block
  std::vector<Block> block_;                    // the first blocks_ are in use
};

}  // namespace dynamy
