#include <dynamy/located/phase/phase_point.hpp>

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

bool ratesArePlain(const Topology& topology) {
  // Tested with velocities that all differ.
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

void QuinticPath::through(const MechanicalSystem&, const PhasePoint& from, const PhasePoint& to) {
  from_ = &from, to_ = &to, h_ = to.x.t - from.x.t;
  derivative_ = from.qdot.size() == from.x.u.size() && from.qdot == from.x.u && to.qdot == to.x.u;
}

/// Hermite's polynomials of degree 5 for value, slope and curvature at both ends, their derivatives
/// if u = q̇, else those of degree 3 for u.
struct QuinticPath::Weights {
  double v0, v1, d0, d1, c0, c1;
  double w = 0.0, e0, e1, k0, k1, k2 = 0.0;
  Weights(double s, double h, bool derivative) {
    const double r = 1.0 - s, s3 = s * s * s, r3 = r * r * r;
    v0 = r3 * (1.0 + 3.0 * s + 6.0 * s * s), v1 = s3 * (1.0 + 3.0 * r + 6.0 * r * r);
    d0 = h * r3 * s * (1.0 + 3.0 * s), d1 = -h * s3 * r * (1.0 + 3.0 * r);
    c0 = 0.5 * h * h * r3 * s * s, c1 = 0.5 * h * h * s3 * r * r;
    if (derivative) {
      w = 30.0 * s * s * r * r / h;
      e0 = r * r * (1.0 + 2.0 * s - 15.0 * s * s), e1 = s * s * (1.0 + 2.0 * r - 15.0 * r * r);
      k0 = 0.5 * h * s * r * r * (2.0 - 5.0 * s), k1 = -0.5 * h * r * s * s * (2.0 - 5.0 * r);
    } else {
      e0 = r * r * (1.0 + 2.0 * s), e1 = s * s * (1.0 + 2.0 * r);
      k0 = r, k1 = h * s * r, k2 = s;
    }
  }
};

void QuinticPath::position(const Weights& w, Eigen::Index first, Eigen::Index n,
                           Eigen::VectorXd& q) const {
  const auto part = [&](const Eigen::VectorXd& x) { return x.segment(first, n); };
  q.segment(first, n) = w.v0 * part(from_->x.q) + w.v1 * part(to_->x.q) + w.d0 * part(from_->qdot) +
                        w.d1 * part(to_->qdot) + w.c0 * part(from_->qddot) +
                        w.c1 * part(to_->qddot);
}

void QuinticPath::velocity(const Weights& w, Eigen::Index first, Eigen::Index n,
                           Eigen::VectorXd& u) const {
  const auto part = [&](const Eigen::VectorXd& x) { return x.segment(first, n); };
  const auto &u0 = from_->x.u, &u1 = to_->x.u;
  if (derivative_)
    u.segment(first, n) = w.w * (part(to_->x.q) - part(from_->x.q)) + w.e0 * part(u0) +
                          w.e1 * part(u1) + w.k0 * part(from_->a) + w.k1 * part(to_->a);
  else
    u.segment(first, n) =
        w.e0 * part(u0) + w.e1 * part(u1) + w.k1 * (w.k0 * part(from_->a) - w.k2 * part(to_->a));
}

void QuinticPath::at(double s, State& out) const {
  const Weights w(s, h_, derivative_);
  out.t = from_->x.t + s * h_;
  out.q.resize(from_->x.q.size()), out.u.resize(from_->x.u.size());
  position(w, 0, out.q.size(), out.q), velocity(w, 0, out.u.size(), out.u);
}

void QuinticPath::at(double s, const SystemParts& parts, std::span<const FrameHandle> frames,
                     State& out) const {
  const Weights w(s, h_, derivative_);
  out.t = from_->x.t + s * h_;
  if (out.q.size() != from_->x.q.size()) out.q = from_->x.q;
  if (out.u.size() != from_->x.u.size()) out.u = from_->x.u;
  const Topology& topology = *parts.topology;
  for (const FrameHandle f : frames) {
    const int own = parts.numberOf(f);
    if (own < 0) continue;
    const SystemHandle& handle =
        topology.system(topology.requestedFrames()[static_cast<std::size_t>(own)].first);
    position(w, handle.q0, handle.nq, out.q), velocity(w, handle.u0, handle.nu, out.u);
  }
}

}  // namespace dynamy
