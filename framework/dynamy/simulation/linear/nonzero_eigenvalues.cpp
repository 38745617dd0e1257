#include <Eigen/SVD>
#include <algorithm>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/simulation/linear/linearisation.hpp>
#include <numeric>

namespace dynamy {

int nonzeroEigenvalues(const Eigen::MatrixXd& A, double noise, Eigen::VectorXcd& values,
                       Eigen::MatrixXcd& vectors) {
  // QᵀAQ = [N *; 0 R] with N nilpotent: one null space after the other goes to the front.
  const Eigen::Index n = A.rows();
  Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(n, n), T = A;
  Eigen::Index zeros = 0;
  for (Eigen::Index found = 1; found > 0 && zeros < n;) {
    const Eigen::Index m = n - zeros;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(T.bottomRightCorner(m, m), Eigen::ComputeFullV);
    found = (svd.singularValues().array() <= noise).count();
    Q.rightCols(m) = (Q.rightCols(m) * svd.matrixV().rowwise().reverse()).eval();
    T = Q.transpose() * A * Q;
    T.block(zeros, zeros, m, found).setZero();
    zeros += found;
  }

  // Eigenvalues of R, sorted.
  const Eigen::Index m = n - zeros;
  values.resize(m), vectors.resize(n, m);
  if (m == 0) return static_cast<int>(zeros);
  const EigenPairs pairs = eigenPairs(T.bottomRightCorner(m, m));
  std::vector<Eigen::Index> order(static_cast<std::size_t>(m));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const Eigen::VectorXcd& found = pairs.values;
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    // The real parts of a conjugate pair are equal up to rounding: the positive frequency comes
    // first.
    const double scale = 1e-10 * (std::abs(found[a]) + std::abs(found[b]));
    if (std::abs(found[a].real() - found[b].real()) > scale)
      return found[a].real() < found[b].real();
    return found[a].imag() > found[b].imag();
  });

  // Eigenvectors of QᵀAQ: (N − λ) x₁ = −T₁₂ x₂.
  const Eigen::MatrixXcd N = T.topLeftCorner(zeros, zeros).cast<std::complex<double>>();
  const Eigen::MatrixXd T12 = T.topRightCorner(zeros, m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const Eigen::Index from = order[static_cast<std::size_t>(k)];
    values[k] = found[from];
    Eigen::VectorXcd x(n);
    x.tail(m) = pairs.vectors.col(from);
    if (zeros > 0) {
      const Eigen::MatrixXcd shifted = N - values[k] * Eigen::MatrixXcd::Identity(zeros, zeros);
      x.head(zeros) = ComplexLu(shifted).solve(-(T12 * x.tail(m)));
    }
    vectors.col(k) = Q * x;
  }
  return static_cast<int>(zeros);
}

}  // namespace dynamy
