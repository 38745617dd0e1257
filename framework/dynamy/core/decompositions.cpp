#include <algorithm>
#include <dynamy/core/decompositions.hpp>

namespace dynamy {

void Lu::compute(const Eigen::MatrixXd& A) { lu_.compute(A); }

Eigen::VectorXd Lu::solve(const Eigen::VectorXd& b) const { return lu_.solve(b); }

void Lu::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { x = lu_.solve(b).eval(); }

void ComplexLu::compute(const Eigen::MatrixXcd& A) { lu_.compute(A); }

Eigen::VectorXcd ComplexLu::solve(const Eigen::VectorXcd& b) const { return lu_.solve(b); }

void PseudoInverse::compute(const Eigen::MatrixXd& A) { qr_.compute(A); }

Eigen::Index PseudoInverse::rank() const { return qr_.rank(); }

Eigen::MatrixXd PseudoInverse::solve(const Eigen::MatrixXd& B) const {
  if (B.cols() == 0) return Eigen::MatrixXd(qr_.cols(), 0);  // Eigen would refer to its first entry
  return qr_.solve(B);
}

void PseudoInverse::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { x = qr_.solve(b); }

void ProductPseudoInverse::compute(const Eigen::MatrixXd& X, const Eigen::MatrixXd& Y) {
  left_.compute(X), right_.compute(Y);
  const Eigen::Index n = X.cols();
  const Eigen::MatrixXd R1 = left_.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd R2 = right_.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  core_.compute(R1 * R2.transpose());
}

void ProductPseudoInverse::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  const Eigen::Index n = left_.cols();
  const Eigen::VectorXd c = (left_.householderQ().adjoint() * b).head(n);
  Eigen::VectorXd z;
  core_.solve(c, z);
  x.setZero(right_.rows());
  x.head(n) = z;
  x.applyOnTheLeft(right_.householderQ());
}

void PivotedQr::compute(const Eigen::MatrixXd& A) { qr_.compute(A); }

Eigen::Index PivotedQr::rank() const { return qr_.rank(); }

Eigen::MatrixXd PivotedQr::Q() const { return qr_.householderQ(); }

Eigen::MatrixXd PivotedQr::solve(const Eigen::MatrixXd& B) const {
  if (B.cols() == 0) return Eigen::MatrixXd(qr_.cols(), 0);
  return qr_.solve(B);
}

std::vector<int> independentColumns(const Eigen::MatrixXd& A, double least, double clear) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  const Eigen::VectorXd pivots = qr.matrixR().diagonal().cwiseAbs();
  std::vector<int> out;
  for (Eigen::Index k = 0; k < pivots.size(); ++k) {
    if (pivots[k] > clear * pivots[0])
      out.push_back(static_cast<int>(qr.colsPermutation().indices()[k]));
    else if (pivots[k] >= least * pivots[0])
      return {};
  }
  std::sort(out.begin(), out.end());
  return out;
}

Eigen::MatrixXd nullSpace(const Eigen::MatrixXd& A, double threshold) {
  const Eigen::Index n = A.cols();
  if (A.rows() == 0 || n == 0) return Eigen::MatrixXd::Identity(n, n);
  PivotedQr qr(threshold);
  qr.compute(A.transpose());
  const Eigen::MatrixXd Q = qr.Q();
  return Q.rightCols(n - qr.rank());
}

EigenPairs eigenPairs(const Eigen::MatrixXd& A) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& A) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(A, false).eigenvalues();
}

SymmetricEigenPairs symmetricEigenPairs(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace dynamy
