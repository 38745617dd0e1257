// FrozenPhase: distances of forces from their bounds, and corrections of positions and velocities.
#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/located/phase/frozen_phase.hpp>

namespace dynamy {
namespace {

constexpr int kMostGauge = 50;    ///< most Newton steps
constexpr double kGauge = 1e-13;  ///< relative size of the last Newton step

}  // namespace

bool FrozenPhase::margin(std::size_t i, double& value) const {
  const int first = row0_[i], d = dim(i);
  const Bounds& b = bounds_[i];
  switch (form_[i]) {
    case Form::joint:
      return false;
    case Form::normal:
      value = lambda_[first] - b.lower;
      return true;
    case Form::cone:
      value = lambda_[first];
      if (!held[i].slips)
        value = std::min(value, b.upper * value - lambda_.segment(first + 1, d - 1).norm());
      return true;
    case Form::disc:
      if (held[i].slips) return false;
      value = normalForce(i) - lambda_.segment(first, d).norm() / b.upper;
      return true;
    case Form::reservoir:
      value = lambda_[first];
      if (!held[i].slips)
        value = std::min(value, b.upper * (value - gauge(i, lambda_.data() + first + 1)));
      return true;
    case Form::given:
    case Form::notch:
      if (held[i].slips) return false;
      value = d > 1 ? b.upper - lambda_.segment(first, d).norm()
                    : std::min(b.upper - lambda_[first], lambda_[first] - b.lower);
      return true;
  }
  return false;
}

bool FrozenPhase::slipBounds(const SetValuedForceLaw& law, LawInput in, const Held& h, double* slip,
                             Bounds& out) {
  const int t = law.rowKind(0) == RowKind::normal ? 1 : 0;
  if (h.slips) in.gammaA = slip, in.rest = 0.0;
  const double v = h.sign * slip[t];
  if (!h.slips || h.first > 0 || in.dim - t != 1 || v > Held::kLeastSlip)
    return bounds(law, in, out, h.first);
  slip[t] = h.sign * Held::kLeastSlip;
  if (!bounds(law, in, out, h.first)) return false;
  if (v > -Held::kLeastSlip || out.form == Form::notch) return true;
  // a(−v) = 4 a(0) − 6 a(v) + 4 a(2v) − a(3v)
  constexpr double kWeight[4] = {4.0, -6.0, 4.0, -1.0};
  out.lower *= kWeight[0], out.upper *= kWeight[0];
  for (int k = 1; k < 4; ++k) {
    Bounds far;
    slip[t] = -k * h.sign * v;
    if (!bounds(law, in, far, h.first)) return false;
    out.lower += kWeight[k] * far.lower, out.upper += kWeight[k] * far.upper;
  }
  return true;
}

double FrozenPhase::normalForce(std::size_t i) const {
  while (held[i].first > 0) --i;
  return lambda_[row0_[i]];
}

double FrozenPhase::gauge(std::size_t i, const double* x) const {
  // Smallest N with x ∈ N B: S_B(y) where ½ S_B² − x·y is smallest, x = S_B(y) ∇S_B(y).
  const int k = slipRows(i);
  const Bounds& b = bounds_[i];
  const LawInput in{.dim = k + 1, .dt = 1.0, .gammaA = gamma_.data() + row0_[i]};
  using Square =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostRows - 1, kMostRows - 1>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows - 1, 1>;
  Column y(k), g(k), step(k), trial(k);
  Square H(k, k);
  const ConstVec asked(x, k);
  for (int r = 0; r < k; ++r) {
    const double width = b.upper * b.weight[static_cast<std::size_t>(r)];
    y[r] = x[r] / (width * width);
  }
  const auto value = [&](const Column& at) {
    const double S = b.set->support(in, k, at.data());
    return 0.5 * S * S - asked.dot(at);
  };
  double S = 0.0;
  for (int turn = 0; turn < kMostGauge; ++turn) {
    S = b.set->support(in, k, y.data(), g.data(), H.data());
    if (!(S > 0.0)) return S;
    H = g * g.transpose() + S * H;
    step = H.ldlt().solve(asked - S * g);
    if (step.norm() <= kGauge * y.norm()) break;
    const double f = value(y);
    double part = 1.0;
    for (trial = y + step; part > 1e-3 && value(trial) > f; trial = y + part * step) part *= 0.5;
    y = trial;
  }
  return b.set->support(in, k, y.data());
}

/// M⁻¹W P; each of its columns combines only few columns of M⁻¹W.
void FrozenPhase::multiplyByP() {
  const auto m = static_cast<Eigen::Index>(kept_.size());
  MP_.setZero(MInvW_.rows(), m);
  for (Eigen::Index k = 0; k < m; ++k)
    for (Eigen::Index row = 0; row < P_.rows(); ++row)
      if (P_(row, k) != 0.0) MP_.col(k) += P_(row, k) * MInvW_.col(row);
}

bool FrozenPhase::correction(const Evaluation& e, Eigen::VectorXd& delta) {
  const auto m = static_cast<Eigen::Index>(kept_.size());
  bool off = false;
  for (Eigen::Index k = 0; k < m; ++k) off = off || rhs_[k] != 0.0;
  delta.setZero(e.h.size());
  if (!off) return false;
  A_.resize(m, m);
  A_.setZero();
  for (Eigen::Index k = 0; k < m; ++k) {
    const int row = kept_[static_cast<std::size_t>(k)];
    for (Eigen::Index j = 0; j < m; ++j)
      for (const Moved& p : moved(row))
        A_(k, j) += W_.col(row)
                        .segment(p.u0, p.nu)
                        .dot(MInvW_.col(kept_[static_cast<std::size_t>(j)]).segment(p.u0, p.nu));
  }
  inverse_.compute(A_);
  inverse_.solve(rhs_, work_);
  for (Eigen::Index k = 0; k < m; ++k)
    delta += work_[k] * MInvW_.col(kept_[static_cast<std::size_t>(k)]);
  return true;
}

bool FrozenPhase::positionCorrection(const Evaluation& e, Eigen::VectorXd& delta) {
  work_.setZero(e.h.size());
  if (!gather(e, work_)) return false;
  kept_.clear();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const SetValuedForceLaw& law = *e.contacts.law[static_cast<std::size_t>(index_[i])];
    for (int r = 0; r < dim(i); ++r)
      if (!yields(law.rowKind(held[i].first + r)) || inNotch(law, dim(i), held[i]))
        kept_.push_back(row0_[i] + r);
  }
  rhs_.resize(static_cast<Eigen::Index>(kept_.size()));
  for (std::size_t k = 0; k < kept_.size(); ++k)
    rhs_[static_cast<Eigen::Index>(k)] = -position_[kept_[k]];
  return correction(e, delta);
}

bool FrozenPhase::velocityCorrection(const Evaluation& e, const Eigen::VectorXd& u,
                                     Eigen::VectorXd& delta) {
  if (!gather(e, u)) return false;
  kept_.clear();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const SetValuedForceLaw& law = *e.contacts.law[static_cast<std::size_t>(index_[i])];
    for (int r = 0; r < dim(i); ++r)
      if (!held[i].slips || law.rowKind(held[i].first + r) == RowKind::normal)
        kept_.push_back(row0_[i] + r);
  }
  rhs_.resize(static_cast<Eigen::Index>(kept_.size()));
  for (std::size_t k = 0; k < kept_.size(); ++k)
    rhs_[static_cast<Eigen::Index>(k)] = -gamma_[kept_[k]];
  return correction(e, delta);
}

}  // namespace dynamy
