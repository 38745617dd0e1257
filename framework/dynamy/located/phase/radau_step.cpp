#include <algorithm>
#include <cmath>
#include <complex>
#include <dynamy/located/phase/radau_step.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr int kStages = 3;
constexpr int kMostNewtonSteps = 10;
/// Newton's method ends at an error of this part of the tolerance.
constexpr double kNewton = 0.02;
/// A Jacobian with which Newton's method contracts at this rate is used for the next step, too.
constexpr double kKeep = 1e-3;
const double kRoot6 = std::sqrt(6.0);
const double kNodes[kStages] = {(4.0 - kRoot6) / 10.0, (4.0 + kRoot6) / 10.0, 1.0};

}  // namespace

double RadauStep::weight(int stage) {
  return stage == 0 ? (16.0 - kRoot6) / 36.0 : stage == 1 ? (16.0 + kRoot6) / 36.0 : 1.0 / 9.0;
}

double RadauStep::node(int stage) { return kNodes[stage]; }

RadauStep::RadauStep() {
  const double s = kRoot6;
  A_ << (88.0 - 7.0 * s) / 360.0, (296.0 - 169.0 * s) / 1800.0, (-2.0 + 3.0 * s) / 225.0,
      (296.0 + 169.0 * s) / 1800.0, (88.0 + 7.0 * s) / 360.0, (-2.0 - 3.0 * s) / 225.0,
      (16.0 - s) / 36.0, (16.0 + s) / 36.0, 1.0 / 9.0;
  // A⁻¹ = T Λ T⁻¹, Λ = diag(γ, [α −β; β α]): T holds the real eigenvector and the parts of the
  // complex one, A⁻¹ (a + ib) = (α − iβ)(a + ib).
  const EigenPairs pairs = eigenPairs(A_.inverse());
  for (int k = 0; k < kStages; ++k) {
    const std::complex<double> value = pairs.values[k];
    const Eigen::Vector3cd vector = pairs.vectors.col(k);
    if (std::abs(value.imag()) < 1e-8) {
      gamma_ = value.real(), T_.col(0) = vector.real();
    } else if (value.imag() < 0.0) {
      alpha_ = value.real(), beta_ = -value.imag();
      T_.col(1) = vector.real(), T_.col(2) = vector.imag();
    }
  }
  TInverse_ = T_.inverse();
}

double RadauStep::measure(const Eigen::VectorXd& change) const {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    const double unit = tolerance_ * std::max(scale_[i], std::abs(y_[i]));
    if (!(std::abs(change[i]) <= worst * unit)) worst = std::abs(change[i]) / unit;
  }
  return worst;
}

bool RadauStep::jacobian(const Field& field, const Place& at) {
  const Eigen::Index n = at.y.size();
  known_ = false, tookJacobian_ = true;
  place_ = at;
  J_.resize(n, n);
  work_ = at.y;
  for (Eigen::Index j = 0; j < n; ++j) {
    // A change by the square root of rounding balances truncation and rounding of the difference.
    work_[j] +=
        std::sqrt(std::numeric_limits<double>::epsilon()) * std::max(std::abs(at.y[j]), scale_[j]);
    const double d = work_[j] - at.y[j];
    if (!field(at.t, work_, -1, change_) || !change_.allFinite()) return false;
    J_.col(j) = (change_ - at.f) / d;
    work_[j] = at.y[j];
  }
  factorised_ = 0.0, known_ = true;
  return true;
}

bool RadauStep::keep(const Field& field, const Place& place) {
  keeps_ = true;
  return jacobian(field, place);
}

void RadauStep::factorise() {
  if (h_ == factorised_) return;
  Eigen::MatrixXd real = -J_;
  real.diagonal().array() += gamma_ / h_;
  real_.compute(real);
  Eigen::MatrixXcd pair = -J_.cast<std::complex<double>>();
  pair.diagonal().array() += std::complex<double>(alpha_, beta_) / h_;
  complex_.compute(pair);
  factorised_ = h_;
}

void RadauStep::correct() {
  // (Λ/h ⊗ I − I ⊗ J) Δw = T⁻¹ F − Λ w/h; the complex pair is solved as one complex equation.
  work_ = TInverse_(0, 0) * F_[0] + TInverse_(0, 1) * F_[1] + TInverse_(0, 2) * F_[2] -
          gamma_ / h_ * w_[0];
  real_.solve(work_, change_);
  w_[0] += change_;
  pair_.resize(y_.size());
  pair_.real() = TInverse_(1, 0) * F_[0] + TInverse_(1, 1) * F_[1] + TInverse_(1, 2) * F_[2] -
                 (alpha_ * w_[1] - beta_ * w_[2]) / h_;
  pair_.imag() = TInverse_(2, 0) * F_[0] + TInverse_(2, 1) * F_[1] + TInverse_(2, 2) * F_[2] -
                 (beta_ * w_[1] + alpha_ * w_[2]) / h_;
  pair_ = complex_.solve(pair_);
  w_[1] += pair_.real(), w_[2] += pair_.imag();
}

bool RadauStep::newton(const Field& field, const Eigen::VectorXd& second) {
  // Starts from Taylor's polynomial, which follows the slow motion after fast parts have died out.
  for (int i = 0; i < kStages; ++i) {
    const double d = kNodes[i] * h_;
    z_[static_cast<std::size_t>(i)] = d * f_ + 0.5 * d * d * second;
  }
  for (int i = 0; i < kStages; ++i)
    w_[static_cast<std::size_t>(i)] =
        TInverse_(i, 0) * z_[0] + TInverse_(i, 1) * z_[1] + TInverse_(i, 2) * z_[2];
  double before = 0.0;
  for (int iteration = 0; iteration < kMostNewtonSteps; ++iteration) {
    iterations_ = iteration + 1;
    for (int i = 0; i < kStages; ++i) {
      const auto k = static_cast<std::size_t>(i);
      work_ = y_ + z_[k];
      if (!field(t_ + kNodes[i] * h_, work_, i, F_[k]) || !F_[k].allFinite()) return false;
    }
    correct();
    double size = 0.0;
    for (int i = 0; i < kStages; ++i) {
      const auto k = static_cast<std::size_t>(i);
      work_ = T_(i, 0) * w_[0] + T_(i, 1) * w_[1] + T_(i, 2) * w_[2];
      change_ = work_ - z_[k];
      z_[k] = work_;
      size = std::max(size, measure(change_));
    }
    if (!std::isfinite(size)) return false;
    const double ratio = iteration > 0 ? size / std::max(before, 1e-300) : 1.0;
    contraction_ = ratio;
    if (size == 0.0 || (iteration > 0 && ratio < 1.0 && ratio / (1.0 - ratio) * size <= kNewton))
      return true;
    if (iteration > 0 && ratio >= 1.0) return size <= kNewton;  // rounding
    before = size;
  }
  return false;
}

bool RadauStep::take(const Field& field, double t, const Eigen::VectorXd& y,
                     const Eigen::VectorXd& f, const Eigen::VectorXd& second, double h, bool same) {
  t_ = t, h_ = h, y_ = y, f_ = f, tookJacobian_ = false;
  bool here = same && known_ && place_.t == t && place_.y == y;
  const bool take = !known_ || (!same && !keeps_);
  if (take && !jacobian(field, {t, y, f})) return false;
  here = here || take;
  factorise();
  bool good = newton(field, second);
  if (!good && !here) {
    if (!jacobian(field, {t, y, f})) return false;
    factorise();
    good = newton(field, second);
  }
  keeps_ = good && contraction_ <= kKeep;
  if (!good) return false;
  end_ = y_ + z_[2];
  return end_.allFinite();
}

double RadauStep::error(const Field& field) {
  // The error of an embedded rule of order 3 with the real eigenvalue, filtered by (γ/h − J)⁻¹.
  const double e[kStages] = {-(13.0 + 7.0 * kRoot6) / 3.0, (-13.0 + 7.0 * kRoot6) / 3.0,
                             -1.0 / 3.0};
  const Eigen::VectorXd sum = (e[0] * z_[0] + e[1] * z_[1] + e[2] * z_[2]) / h_;
  Eigen::VectorXd estimate = real_.solve(f_ + sum);
  double size = measure(estimate);
  if (size > 1.0) {
    work_ = y_ + estimate;
    if (field(t_, work_, -1, change_) && change_.allFinite()) {
      estimate = real_.solve(change_ + sum);
      size = measure(estimate);
    }
  }
  return size;
}

double RadauStep::fastest() const {
  // Power method: mean growth under J over an even number of iterations, so that a pair ±iω shows
  // its ω. Computing all eigenvalues would cost some tens of factorisations.
  constexpr int kTurns = 16, kFirst = 8;
  if (J_.size() == 0) return 0.0;
  Eigen::VectorXd v = (f_.array().abs() + scale_.cwiseInverse().array()).matrix(), next;
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

void RadauStep::dense(double theta, Eigen::VectorXd& y) const {
  // Lagrange's polynomial through 0, z₁, z₂, z₃ at 0, c₁, c₂, 1.
  y = y_;
  for (int i = 0; i < kStages; ++i) {
    double w = theta / kNodes[i];
    for (int j = 0; j < kStages; ++j)
      if (j != i) w *= (theta - kNodes[j]) / (kNodes[i] - kNodes[j]);
    y += w * z_[static_cast<std::size_t>(i)];
  }
}

}  // namespace dynamy
