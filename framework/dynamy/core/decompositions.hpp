/// Eigen's decompositions of dense matrices, compiled once for the whole library, because each
/// takes a compiler seconds wherever it is instantiated. Steps and inner loops solve small systems
/// with their own fixed-size kernels; these decompositions serve larger and rarer systems.
/// Rejected: `extern template` for Eigen's classes; their members are templates themselves.
#pragma once
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <vector>

namespace dynamy {

/// A = P L U of a square matrix with partial pivoting.
class Lu {
 public:
  Lu() = default;
  explicit Lu(const Eigen::MatrixXd& A) { compute(A); }
  void compute(const Eigen::MatrixXd& A);
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// x = A⁻¹ b; x and b may be one vector.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

class ComplexLu {
 public:
  ComplexLu() = default;
  explicit ComplexLu(const Eigen::MatrixXcd& A) { compute(A); }
  void compute(const Eigen::MatrixXcd& A);
  Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXcd> lu_;
};

/// Pseudo-inverse A⁺ of any matrix: of all x that bring A x nearest to b, x = A⁺ b has the least
/// norm. Pivots below `threshold` times the largest count as zero.
class PseudoInverse {
 public:
  /// The threshold is Eigen's default: rounding times the smaller dimension of the matrix.
  PseudoInverse() = default;
  explicit PseudoInverse(double threshold) { qr_.setThreshold(threshold); }
  void compute(const Eigen::MatrixXd& A);
  Eigen::Index rank() const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> qr_;
};

/// Pseudo-inverse of a product A = X Yᵀ of tall matrices, m × n with n < m, without A:
///
///   X = Q₁ R₁,  Y = Q₂ R₂,  A⁺ = Q₂ (R₁ R₂ᵀ)⁺ Q₁ᵀ
class ProductPseudoInverse {
 public:
  explicit ProductPseudoInverse(double threshold) : core_(threshold) {}
  void compute(const Eigen::MatrixXd& X, const Eigen::MatrixXd& Y);
  Eigen::Index rank() const { return core_.rank(); }
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  Eigen::HouseholderQR<Eigen::MatrixXd> left_, right_;
  PseudoInverse core_;
};

/// A P = Q R with pivoting of columns; rank as in PseudoInverse.
class PivotedQr {
 public:
  PivotedQr() = default;
  explicit PivotedQr(double threshold) { qr_.setThreshold(threshold); }
  void compute(const Eigen::MatrixXd& A);
  Eigen::Index rank() const;
  Eigen::MatrixXd Q() const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr_;
};

/// Columns of A that are independent by far, as many as its rank: by pivots of A P = Q R, of which
/// those of the others are below `least` and theirs above `clear` times the largest. Empty where
/// pivots lie between.
std::vector<int> independentColumns(const Eigen::MatrixXd& A, double least, double clear);

/// Orthonormal columns that A maps to zero; rank as in PseudoInverse. All of ℝⁿ if A has no rows.
Eigen::MatrixXd nullSpace(const Eigen::MatrixXd& A, double threshold);

/// Eigenvalues, and the columns of eigenvectors, of a square matrix; unsorted.
struct EigenPairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
EigenPairs eigenPairs(const Eigen::MatrixXd& A);
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& A);

/// Eigenvalues and eigenvectors of a symmetric matrix, in ascending order.
struct SymmetricEigenPairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigenPairs symmetricEigenPairs(const Eigen::MatrixXd& A);

}  // namespace dynamy
