#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/smooth_step.hpp>

namespace dynamy {

void configurationRate(const Topology& topology, const State& x, Eigen::VectorXd& qdot) {
  qdot.resize(x.q.size());
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    if (s.nq > 0)
      topology.systems()[i]->qdot(x.t, slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu),
                                  slice(qdot, s.q0, s.nq));
  }
}

namespace {

/// True if all systems have q̇ = u; tested with velocities that all differ.
bool isPlain(const Topology& topology) {
  State x;
  x.q.setOnes(topology.nq()), x.u.resize(topology.nu());
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    if (s.nq > 0)
      topology.systems()[i]->initialState(slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu));
  }
  for (Eigen::Index i = 0; i < x.u.size(); ++i) x.u[i] = 1.0 + 0.37 * static_cast<double>(i);
  Eigen::VectorXd rate;
  configurationRate(topology, x, rate);
  return rate.size() == x.u.size() && rate == x.u;
}

}  // namespace

// ---- QuinticPath -------------------------------------------------------------------------------

void QuinticPath::through(const MechanicalSystem&, const PhasePoint& from, const PhasePoint& to) {
  from_ = &from, to_ = &to, h_ = to.x.t - from.x.t;
  derivative_ = from.qdot.size() == from.x.u.size() && from.qdot == from.x.u && to.qdot == to.x.u;
}

void QuinticPath::at(double s, State& out) const {
  const double h = h_, r = 1.0 - s;
  out.t = from_->x.t + s * h;
  // Hermite's polynomials of degree 5 for value, slope and curvature at both ends.
  const double s3 = s * s * s, r3 = r * r * r;
  const double v0 = r3 * (1.0 + 3.0 * s + 6.0 * s * s), v1 = s3 * (1.0 + 3.0 * r + 6.0 * r * r);
  const double d0 = h * r3 * s * (1.0 + 3.0 * s), d1 = -h * s3 * r * (1.0 + 3.0 * r);
  const double c0 = 0.5 * h * h * r3 * s * s, c1 = 0.5 * h * h * s3 * r * r;
  out.q = v0 * from_->x.q + v1 * to_->x.q + d0 * from_->qdot + d1 * to_->qdot + c0 * from_->qddot +
          c1 * to_->qddot;
  if (derivative_) {
    const double w = 30.0 * s * s * r * r / h;
    const double e0 = r * r * (1.0 + 2.0 * s - 15.0 * s * s),
                 e1 = s * s * (1.0 + 2.0 * r - 15.0 * r * r);
    const double k0 = 0.5 * h * s * r * r * (2.0 - 5.0 * s),
                 k1 = -0.5 * h * r * s * s * (2.0 - 5.0 * r);
    out.u =
        w * (to_->x.q - from_->x.q) + e0 * from_->x.u + e1 * to_->x.u + k0 * from_->a + k1 * to_->a;
    return;
  }
  out.u = r * r * (1.0 + 2.0 * s) * from_->x.u + s * s * (1.0 + 2.0 * r) * to_->x.u +
          h * s * r * (r * from_->a - s * to_->a);
}

// ---- SmoothStep --------------------------------------------------------------------------------

void SmoothStep::prepare(const MechanicalSystem& s, const ButcherTableau& table,
                         const ButcherTableau* light) {
  table_ = full_ = &table, light_ = light, enough_ = kEnough;
  const Topology& topology = *s.parts().topology;
  const int columns = table.stages + 1 + table.denseStages;  // `light` has fewer
  Q_.setZero(topology.nq(), columns), U_.setZero(topology.nu(), columns);
  plain_ = isPlain(topology);
}

void SmoothStep::rates(const MechanicalSystem& s, PhasePoint& p) const {
  if (plain_) {
    p.qdot = p.x.u, p.qddot = p.a;
    return;
  }
  const Topology& topology = *s.parts().topology;
  configurationRate(topology, p.x, p.qdot);
  // q̈ by the central difference of q̇ along the motion; only the search of switches uses it.
  constexpr double kDifference = 1e-5;
  const double speed = p.x.u.lpNorm<Eigen::Infinity>(), a = p.a.lpNorm<Eigen::Infinity>();
  const double d = kDifference / (1.0 + speed + std::sqrt(a));
  State y;
  Eigen::VectorXd forward;
  y.t = p.x.t + d, y.q = p.x.q + d * p.qdot, y.u = p.x.u + d * p.a;
  configurationRate(topology, y, forward);
  y.t = p.x.t - d, y.q = p.x.q - d * p.qdot, y.u = p.x.u - d * p.a;
  configurationRate(topology, y, p.qddot);
  p.qddot = (forward - p.qddot) / (2.0 * d);
}

void SmoothStep::combine(const PhasePoint& from, int row, State& out) const {
  out.q = from.x.q, out.u = from.x.u;
  const int n = std::min(row, table_->stages + 1 + table_->denseStages);
  for (int j = 0; j < n; ++j) {
    const double w = j < table_->stride ? table_->weight(row, j) : 0.0;
    if (w == 0.0) continue;
    out.q += h_ * w * Q_.col(j), out.u += h_ * w * U_.col(j);
  }
}

bool SmoothStep::stage(MechanicalSystem& s, FrozenPhase& phase, int i) {
  // At positions that are not finite elements report nothing. The step was too long: no contact has
  // disappeared.
  if (!stage_.q.allFinite() || !stage_.u.allFinite()) return false;
  s.evaluate(stage_, 1);
  Eigen::VectorXd& a = denseU_[7];  // scratch until the dense output
  if (!phase.accelerate(s.slot(1), stage_.u, a)) return false;
  U_.col(i) = a;
  if (plain_) {
    Q_.col(i) = stage_.u;
  } else {
    configurationRate(*s.parts().topology, stage_, denseQ_[7]);
    Q_.col(i) = denseQ_[7];
  }
  return true;
}

bool SmoothStep::take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
                      State& to) {
  h_ = h, t0_ = from.x.t, tookImplicit_ = implicit_, tookHalf_ = halfExplicit();
  stage_.memory = from.x.memory;
  if (implicit_) return takeImplicit(s, phase, from, h, to);
  if (tookHalf_) {
    if (!half_.take(s, phase, from.x, h, columns_, plain_, to)) return false;
    impulse_ = half_.impulse(), works_ = half_.works();
    return finish(s, to);
  }
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
  return finish(s, to);
}

bool SmoothStep::finish(const MechanicalSystem& s, State& to) const {
  const Topology& topology = *s.parts().topology;
  if (!plain_)
    for (std::size_t i = 0; i < topology.systems().size(); ++i)
      if (const SystemHandle& handle = topology.system(static_cast<int>(i)); handle.nq > 0)
        topology.systems()[i]->normalise(slice(to.q, handle.q0, handle.nq));
  return to.q.allFinite() && to.u.allFinite();
}

double SmoothStep::error(const ErrorNorm& norm, const State& from, const State& to) {
  worst_ = -1;
  if (tookImplicit_) return radauError_;
  if (tookHalf_) return half_.error(norm, from, to);
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

bool SmoothStep::tooLight(double error) {
  constexpr double kMost = 0.1, kLess = 0.1;
  if (tookImplicit_ || tookHalf_ || !light() || error <= kMost) return false;
  light(false), enough_ *= kLess;
  return true;
}

bool SmoothStep::prepareDense(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from,
                              const PhasePoint& to) {
  if (tookImplicit_) return true;
  if (tookHalf_) {
    through_.through(s, from, to);
    return true;
  }
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

void SmoothStep::dense(double theta, State& out) const {
  if (tookImplicit_) {
    Eigen::VectorXd y;
    radau_.dense(theta, y);
    out.q = y.head(Q_.rows()), out.u = y.tail(U_.rows()), out.t = t0_ + theta * h_;
    return;
  }
  if (tookHalf_) {
    through_.at(theta, out);
    return;
  }
  const double r = 1.0 - theta;
  const auto value = [&](const std::array<Eigen::VectorXd, 8>& c, Eigen::VectorXd& y) {
    y = c[7];
    for (std::size_t k = 7; k-- > 0;) y = c[k] + (k % 2 == 0 ? theta : r) * y;
  };
  value(denseQ_, out.q), value(denseU_, out.u);
  out.t = t0_ + theta * h_;
}

}  // namespace dynamy
