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

}  // namespace dynamy
