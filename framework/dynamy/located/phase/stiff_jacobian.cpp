#include <algorithm>
#include <cmath>
#include <complex>
#include <dynamy/located/phase/radau_method.hpp>
#include <dynamy/located/phase/stiff_jacobian.hpp>
#include <limits>

namespace dynamy {

bool StiffJacobian::take(const Field& field, const Place& at, const Eigen::VectorXd& scale) {
  const Eigen::Index n = at.y.size();
  known_ = false;
  place_ = at;
  J_.resize(n, n);
  moved_ = at.y;
  for (Eigen::Index j = 0; j < n; ++j) {
    // A change by the square root of rounding balances truncation and rounding of the difference.
    moved_[j] +=
        std::sqrt(std::numeric_limits<double>::epsilon()) * std::max(std::abs(at.y[j]), scale[j]);
    const double d = moved_[j] - at.y[j];
    if (!field(at.t, moved_, -1, f_) || !f_.allFinite()) return false;
    J_.col(j) = (f_ - at.f) / d;
    moved_[j] = at.y[j];
  }
  h_ = 0.0, known_ = true;
  return true;
}

void StiffJacobian::factor(double h) {
  if (h == h_) return;
  const RadauMethod& method = radauMethod();
  Eigen::MatrixXd real = -J_;
  real.diagonal().array() += method.gamma / h;
  real_.compute(real);
  Eigen::MatrixXcd pair = -J_.cast<std::complex<double>>();
  pair.diagonal().array() += std::complex<double>(method.alpha, method.beta) / h;
  complex_.compute(pair);
  h_ = h;
}

double StiffJacobian::fastest(Eigen::VectorXd v) const {
  // Power method: mean growth under J over an even number of iterations, so that a pair ±iω shows
  // its ω. Computing all eigenvalues would cost some tens of factorisations.
  constexpr int kTurns = 16, kFirst = 8;
  if (J_.size() == 0) return 0.0;
  Eigen::VectorXd next;
  double grown = 0.0;  // log of the growth from turn kFirst on
  for (int i = 0; i < kTurns; ++i) {
    v /= v.norm();
    next.noalias() = J_ * v;
    const double size = next.norm();
    if (!(size > 0.0) || !std::isfinite(size)) return 0.0;
    if (i >= kFirst) grown += std::log(size);
    v.swap(next);
  }
  return std::exp(grown / (kTurns - kFirst));
}

}  // namespace dynamy
