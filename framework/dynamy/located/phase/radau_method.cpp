#include <cmath>
#include <complex>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/located/phase/radau_method.hpp>

namespace dynamy {
namespace {

RadauMethod coefficients() {
  RadauMethod m;
  const double s = std::sqrt(6.0);
  m.nodes = {(4.0 - s) / 10.0, (4.0 + s) / 10.0, 1.0};
  m.weights = {(16.0 - s) / 36.0, (16.0 + s) / 36.0, 1.0 / 9.0};
  m.error = {-(13.0 + 7.0 * s) / 3.0, (-13.0 + 7.0 * s) / 3.0, -1.0 / 3.0};
  Eigen::Matrix3d A;
  A << (88.0 - 7.0 * s) / 360.0, (296.0 - 169.0 * s) / 1800.0, (-2.0 + 3.0 * s) / 225.0,
      (296.0 + 169.0 * s) / 1800.0, (88.0 + 7.0 * s) / 360.0, (-2.0 - 3.0 * s) / 225.0,
      (16.0 - s) / 36.0, (16.0 + s) / 36.0, 1.0 / 9.0;
  // T holds the real eigenvector of A⁻¹ and the parts of the complex one,
  // A⁻¹ (a + ib) = (α − iβ)(a + ib).
  const EigenPairs pairs = eigenPairs(A.inverse());
  for (int k = 0; k < RadauMethod::kStages; ++k) {
    const std::complex<double> value = pairs.values[k];
    const Eigen::Vector3cd vector = pairs.vectors.col(k);
    if (std::abs(value.imag()) < 1e-8) {
      m.gamma = value.real(), m.T.col(0) = vector.real();
    } else if (value.imag() < 0.0) {
      m.alpha = value.real(), m.beta = -value.imag();
      m.T.col(1) = vector.real(), m.T.col(2) = vector.imag();
    }
  }
  m.TInverse = m.T.inverse();
  return m;
}

}  // namespace

const RadauMethod& radauMethod() {
  static const RadauMethod method = coefficients();
  return method;
}

}  // namespace dynamy
