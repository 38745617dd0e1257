#include <dynamy/system/partial_mechanical_system.hpp>

namespace dynamy {

void PartialMechanicalSystem::qdot(double, ConstVec, ConstVec u, Vec qdot) const { qdot = u; }

void PartialMechanicalSystem::move(double t, Vec q, ConstVec u, double dt) const {
  const Blocks b = blocks();
  const auto n = static_cast<Eigen::Index>(b.nq) * b.capacity;
  constexpr Eigen::Index kLocal = 1024;
  if (n <= kLocal) {
    double rate[kLocal];
    qdot(t, {q.data(), n}, u, {rate, n});
    for (Eigen::Index i = 0; i < n; ++i) q[i] += dt * rate[i];
    return;
  }
  // Large populations override move(); this keeps a forgotten override correct.
  Eigen::VectorXd rate(n);
  qdot(t, {q.data(), n}, u, {rate.data(), n});
  q += dt * rate;
}

double PartialMechanicalSystem::gravity(double, ConstVec, const Vec3&, Vec h) const {
  h.setZero();
  return 0.0;
}

void PartialMechanicalSystem::nonPotentialForce(double, ConstVec, ConstVec, Vec h) const {
  h.setZero();
}

void PartialMechanicalSystem::frame(double, ConstVec, ConstVec, int, Frame&) const {
  expects(false, "a system with frames() > 0 overrides frame()");
}

bool PartialMechanicalSystem::feelsGravity(ConstVec q) const {
  const Blocks b = blocks();
  Eigen::VectorXd h = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(b.nu) * b.capacity);
  for (int axis = 0; axis < 3; ++axis) {
    const double V = gravity(0.0, q, Vec3::Unit(axis), {h.data(), h.size()});
    if (V != 0.0 || !h.isZero(0.0)) return true;
  }
  return false;
}

}  // namespace dynamy
