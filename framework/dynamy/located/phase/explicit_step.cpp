#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/explicit_step.hpp>

namespace dynamy {
namespace {

/// Bounds of stability h |λ| of order 5 and 8 [hairer_wanner1996, IV.2].
constexpr double kBound5 = 3.25, kBound8 = 6.1;
/// At tight tolerances steps are shorter: the fast part is accurate, not only stable. A damped fast
/// part draws both states of a step together, along its own direction.
constexpr double kDamped = 0.8, kAlong = 0.9;

/// −cos of the angle between a difference of states and that of their rates, in units of the
/// tolerance: 1 where all of it decays at one rate.
double decay(const ErrorNorm& norm, const PhasePoint& to, const State& stage,
             const Eigen::Ref<const Eigen::VectorXd>& qdot,
             const Eigen::Ref<const Eigen::VectorXd>& a) {
  double dot = 0.0, states = 0.0, rates = 0.0;
  const auto add = [&](double unit, double y, double f) {
    dot += unit * unit * y * f, states += unit * unit * y * y, rates += unit * unit * f * f;
  };
  for (Eigen::Index i = 0; i < to.x.q.size(); ++i)
    add(norm.position(i, 1.0, 0.0), to.x.q[i] - stage.q[i], to.qdot[i] - qdot[i]);
  for (Eigen::Index i = 0; i < to.x.u.size(); ++i)
    add(norm.velocity(i, 1.0, 0.0), to.x.u[i] - stage.u[i], to.a[i] - a[i]);
  return states > 0.0 && rates > 0.0 ? -dot / std::sqrt(states * rates) : 0.0;
}

/// Size of a difference of states or of their rates, in units of the tolerance.
double sizeOf(const ErrorNorm& norm, const Eigen::VectorXd& dq, const Eigen::VectorXd& du) {
  double size = 0.0;
  for (Eigen::Index i = 0; i < dq.size(); ++i) size = std::max(size, norm.position(i, dq[i], 0.0));
  for (Eigen::Index i = 0; i < du.size(); ++i) size = std::max(size, norm.velocity(i, du[i], 0.0));
  return size;
}

}  // namespace

void ExplicitStep::prepare(const Topology& topology, const ButcherTableau& table,
                           const ButcherTableau* light, bool plain) {
  table_ = full_ = &table, light_ = light, enough_ = kEnough, plain_ = plain;
  const int columns = table.stages + 1 + table.denseStages;  // `light` has fewer
  Q_.setZero(topology.nq(), columns), U_.setZero(topology.nu(), columns);
}

void ExplicitStep::combine(const PhasePoint& from, int row, State& out) const {
  out.q = from.x.q, out.u = from.x.u;
  const int n = std::min(row, table_->stages + 1 + table_->denseStages);
  for (int j = 0; j < n; ++j) {
    const double w = j < table_->stride ? table_->weight(row, j) : 0.0;
    if (w == 0.0) continue;
    out.q += h_ * w * Q_.col(j), out.u += h_ * w * U_.col(j);
  }
}

bool ExplicitStep::stage(MechanicalSystem& s, FrozenPhase& phase, int i) {
  // At positions that are not finite elements report nothing. The step was too long: no contact has
  // disappeared.
  if (!stage_.q.allFinite() || !stage_.u.allFinite()) return false;
  s.evaluate(stage_, phase.request.ofStage());
  if (!phase.accelerate(s.slot(1), stage_.u, a_)) return false;
  U_.col(i) = a_;
  if (plain_) {
    Q_.col(i) = stage_.u;
  } else {
    configurationRate(*s.parts().topology, stage_, rate_);
    Q_.col(i) = rate_;
  }
  return true;
}

bool ExplicitStep::take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
                        State& to) {
  h_ = h, t0_ = from.x.t, stage_.memory = from.x.memory;
  Q_.col(0) = from.qdot, U_.col(0) = from.a;
  impulse_.setZero(from.lambda.size()), works_ = {};
  const auto collect = [&](int i, const Eigen::VectorXd& lambda,
                           const std::array<double, 5>& power) {
    const double weight = h * table_->weight(table_->stages, i);
    if (weight == 0.0) return;
    impulse_ += weight * lambda;
    for (std::size_t k = 0; k < works_.size(); ++k) works_[k] += weight * power[k];
  };
  collect(0, from.lambda, from.power);
  for (int i = 1; i < table_->stages; ++i) {
    stage_.t = from.x.t + table_->nodes[i] * h;
    combine(from, i, stage_);
    if (!stage(s, phase, i)) return false;
    collect(i, phase.lambda(), phase.power());
  }
  to.t = from.x.t + h;
  combine(from, table_->stages, to);
  return true;
}

double ExplicitStep::error(const ErrorNorm& norm, const State& from, const State& to) {
  worst_ = -1;
  // Order 8: |h| e5²/√(e5² + 0.01 e3²) of each component; order 5: its one estimate.
  const int n = table_->stages, estimate = errorNeedsEnd() ? n + 1 : n;
  double worst = 0.0;
  lighter_ = 0.0;
  const auto judge = [&](const Eigen::MatrixXd& K, Eigen::Index i, auto&& measure) {
    double e5 = 0.0, e3 = 0.0;
    for (int j = 0; j < estimate; ++j) {
      e5 += table_->error[j] * K(i, j);
      if (table_->error3) e3 += (table_->weight(n, j) - table_->error3[j]) * K(i, j);
    }
    const double d = e5 * e5 + 0.01 * e3 * e3, alone = measure(h_ * e5);
    const double share = table_->error3 ? (d > 0.0 ? std::abs(e5) / std::sqrt(d) : 0.0) : 1.0;
    lighter_ = std::max(lighter_, alone);
    return alone * share;
  };
  for (Eigen::Index i = 0; i < from.q.size(); ++i)
    worst = std::max(worst, judge(Q_, i, [&](double e) {
                       return norm.position(i, e, std::max(std::abs(from.q[i]), std::abs(to.q[i])));
                     }));
  double faster = 0.0;
  for (Eigen::Index i = 0; i < from.u.size(); ++i) {
    const double own = judge(U_, i, [&](double e) {
      return norm.velocity(i, e, std::max(std::abs(from.u[i]), std::abs(to.u[i])));
    });
    if (own > faster) faster = own, worst_ = static_cast<int>(i);
  }
  return std::max(worst, faster);
}

bool ExplicitStep::tooLight(double error) {
  constexpr double kMost = 0.1, kLess = 0.1;
  if (!light() || error <= kMost) return false;
  light(false), enough_ *= kLess;
  return true;
}

bool ExplicitStep::prepareDense(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from,
                                const PhasePoint& to) {
  const int n = table_->stages;
  Q_.col(n) = to.qdot, U_.col(n) = to.a;
  stage_.memory = from.x.memory;
  for (int k = 0; k < table_->denseStages; ++k) {
    stage_.t = from.x.t + table_->nodes[n + 1 + k] * h_;
    combine(from, n + 1 + k, stage_);
    if (!stage(s, phase, n + 1 + k)) return false;
  }
  const auto fill = [&](std::array<Eigen::VectorXd, 8>& r, const Eigen::MatrixXd& K,
                        const Eigen::VectorXd& y0, const Eigen::VectorXd& y1) {
    r[0] = y0, r[1] = y1 - y0;
    r[2] = h_ * K.col(0) - r[1];
    r[3] = r[1] - h_ * K.col(n) - r[2];
    const int columns = n + 1 + table_->denseStages;
    for (int row = 0; row < 4; ++row) {
      Eigen::VectorXd& out = r[static_cast<std::size_t>(4 + row)];
      out.setZero(y0.size());
      for (int j = 0; row < table_->denseRows && j < columns; ++j)
        out += h_ * table_->dense[row * columns + j] * K.col(j);
    }
  };
  fill(denseQ_, Q_, from.x.q, to.x.q), fill(denseU_, U_, from.x.u, to.x.u);
  return true;
}

void ExplicitStep::dense(double theta, State& out) const {
  const double r = 1.0 - theta;
  const auto value = [&](const std::array<Eigen::VectorXd, 8>& c, Eigen::VectorXd& y) {
    y = c[7];
    for (std::size_t k = 7; k-- > 0;) y = c[k] + (k % 2 == 0 ? theta : r) * y;
  };
  value(denseQ_, out.q), value(denseU_, out.u);
  out.t = t0_ + theta * h_;
}

bool ExplicitStep::stiffness(const ErrorNorm& norm, const PhasePoint& to, Stiffness& out) const {
  // The last stage and the result, two states at the end of the step, differ by the stiff part.
  const int last = table_->stages - 1;
  if (table_->nodes[last] != 1.0) return false;
  const double states = sizeOf(norm, to.x.q - stage_.q, to.x.u - stage_.u);
  const double rates = sizeOf(norm, to.qdot - Q_.col(last), to.a - U_.col(last));
  out.product = states > 0.0 ? h_ * rates / states : 0.0;
  out.bound = table_->order >= 8 ? kBound8 : kBound5;
  out.damped =
      out.product > kDamped && decay(norm, to, stage_, Q_.col(last), U_.col(last)) > kAlong;
  return true;
}

}  // namespace dynamy
