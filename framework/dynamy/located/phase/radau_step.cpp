#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/radau_method.hpp>
#include <dynamy/located/phase/radau_step.hpp>

namespace dynamy {
namespace {

constexpr int kStages = RadauMethod::kStages;
constexpr int kMostNewtonSteps = 10;
/// Newton's method ends at an error of this part of the tolerance.
constexpr double kNewton = 0.02;
/// A Jacobian with which Newton's method contracts at this rate is used for the next step, too.
constexpr double kKeep = 1e-3;

}  // namespace

double RadauStep::measure(const Eigen::VectorXd& change) const {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    const double unit = tolerance_ * std::max(scale_[i], std::abs(from_.y[i]));
    if (!(std::abs(change[i]) <= worst * unit)) worst = std::abs(change[i]) / unit;
  }
  return worst;
}

bool RadauStep::takeJacobian(const Field& field, const Place& at) {
  tookJacobian_ = true;
  return jacobian_.take(field, at, scale_);
}

bool RadauStep::keep(const Field& field, const Place& place) {
  keeps_ = true;
  return takeJacobian(field, place);
}

void RadauStep::correct() {
  // (Λ/h ⊗ I − I ⊗ J) Δw = T⁻¹ F − Λ w/h; the complex pair is solved as one complex equation.
  const RadauMethod& m = radauMethod();
  const Eigen::Matrix3d& TInverse = m.TInverse;
  work_ = TInverse(0, 0) * F_[0] + TInverse(0, 1) * F_[1] + TInverse(0, 2) * F_[2] -
          m.gamma / h_ * w_[0];
  jacobian_.solve(work_, change_);
  w_[0] += change_;
  pair_.resize(from_.y.size());
  pair_.real() = TInverse(1, 0) * F_[0] + TInverse(1, 1) * F_[1] + TInverse(1, 2) * F_[2] -
                 (m.alpha * w_[1] - m.beta * w_[2]) / h_;
  pair_.imag() = TInverse(2, 0) * F_[0] + TInverse(2, 1) * F_[1] + TInverse(2, 2) * F_[2] -
                 (m.beta * w_[1] + m.alpha * w_[2]) / h_;
  pair_ = jacobian_.solve(pair_);
  w_[1] += pair_.real(), w_[2] += pair_.imag();
}

bool RadauStep::newton(const Field& field, const Eigen::VectorXd& second, double& contraction) {
  const RadauMethod& m = radauMethod();
  const Eigen::Matrix3d &T = m.T, &TInverse = m.TInverse;
  // Starts from Taylor's polynomial, which follows the slow motion after fast parts have died out.
  for (std::size_t k = 0; k < kStages; ++k) {
    const double d = m.nodes[k] * h_;
    z_[k] = d * from_.f + 0.5 * d * d * second;
  }
  for (int i = 0; i < kStages; ++i)
    w_[static_cast<std::size_t>(i)] =
        TInverse(i, 0) * z_[0] + TInverse(i, 1) * z_[1] + TInverse(i, 2) * z_[2];
  double before = 0.0;
  for (int iteration = 0; iteration < kMostNewtonSteps; ++iteration) {
    iterations_ = iteration + 1;
    for (int i = 0; i < kStages; ++i) {
      const auto k = static_cast<std::size_t>(i);
      work_ = from_.y + z_[k];
      if (!field(from_.t + m.nodes[k] * h_, work_, i, F_[k]) || !F_[k].allFinite()) return false;
    }
    correct();
    double size = 0.0;
    for (int i = 0; i < kStages; ++i) {
      const auto k = static_cast<std::size_t>(i);
      work_ = T(i, 0) * w_[0] + T(i, 1) * w_[1] + T(i, 2) * w_[2];
      change_ = work_ - z_[k];
      z_[k] = work_;
      size = std::max(size, measure(change_));
    }
    if (!std::isfinite(size)) return false;
    const double ratio = iteration > 0 ? size / std::max(before, 1e-300) : 1.0;
    contraction = ratio;
    if (size == 0.0 || (iteration > 0 && ratio < 1.0 && ratio / (1.0 - ratio) * size <= kNewton))
      return true;
    if (iteration > 0 && ratio >= 1.0) return size <= kNewton;  // rounding
    before = size;
  }
  return false;
}

bool RadauStep::take(const Field& field, double t, const Eigen::VectorXd& y,
                     const Eigen::VectorXd& f, const Eigen::VectorXd& second, double h, bool same) {
  h_ = h, from_.t = t, from_.y = y, from_.f = f, tookJacobian_ = false;
  const bool known = jacobian_.known();
  const Place& at = jacobian_.place();
  bool here = same && known && at.t == t && at.y == y;
  const bool take = !known || (!same && !keeps_);
  if (take && !takeJacobian(field, from_)) return false;
  here = here || take;
  jacobian_.factor(h);
  double contraction = 1.0;
  bool good = newton(field, second, contraction);
  if (!good && !here) {
    if (!takeJacobian(field, from_)) return false;
    jacobian_.factor(h);
    good = newton(field, second, contraction);
  }
  keeps_ = good && contraction <= kKeep;
  if (!good) return false;
  end_ = from_.y + z_[2];
  return end_.allFinite();
}

double RadauStep::error(const Field& field) {
  // The error of an embedded rule of order 3 with the real eigenvalue, filtered by (γ/h − J)⁻¹.
  const std::array<double, 3>& e = radauMethod().error;
  const Eigen::VectorXd sum = (e[0] * z_[0] + e[1] * z_[1] + e[2] * z_[2]) / h_;
  Eigen::VectorXd estimate;
  work_ = from_.f + sum;
  jacobian_.solve(work_, estimate);
  double size = measure(estimate);
  if (size > 1.0) {
    work_ = from_.y + estimate;
    if (field(from_.t, work_, -1, change_) && change_.allFinite()) {
      work_ = change_ + sum;
      jacobian_.solve(work_, estimate);
      size = measure(estimate);
    }
  }
  return size;
}

double RadauStep::fastest() const {
  if (from_.f.size() == 0) return 0.0;
  return jacobian_.fastest((from_.f.array().abs() + scale_.cwiseInverse().array()).matrix());
}

void RadauStep::dense(double theta, Eigen::VectorXd& y) const {
  // Lagrange's polynomial through 0, z₁, z₂, z₃ at 0, c₁, c₂, 1.
  const std::array<double, 3>& c = radauMethod().nodes;
  y = from_.y;
  for (std::size_t i = 0; i < kStages; ++i) {
    double w = theta / c[i];
    for (std::size_t j = 0; j < kStages; ++j)
      if (j != i) w *= (theta - c[j]) / (c[i] - c[j]);
    y += w * z_[i];
  }
}

}  // namespace dynamy
