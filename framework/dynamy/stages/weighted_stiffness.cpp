#include <dynamy/stages/weighted_stiffness.hpp>

namespace dynamy {

void WeightedStiffness::addStart(double dt, const Eigen::VectorXd& v, Eigen::VectorXd& out) const {
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const StiffEntry& e = entries[k];
    if (const double s = weights(k).s; s != 0.0) out[e.i] += dt * dt * s * e.K * v[e.j];
  }
}

void WeightedStiffness::addUsedForce(double dt, const Eigen::VectorXd& uA,
                                     const Eigen::VectorXd& uE, Eigen::VectorXd& h,
                                     Eigen::VectorXd& hNonPotential) const {
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const StiffEntry& e = entries[k];
    const ImplicitWeights& w = weights(k);
    const double change = uE[e.j] - uA[e.j], damping = w.b * e.D * change;
    h[e.i] += dt * e.K * (w.s * uA[e.j] + w.a * change) + damping;
    hNonPotential[e.i] += damping;
  }
}

double WeightedStiffness::workOfDamped(double dt, const Eigen::VectorXd& uA,
                                       const Eigen::VectorXd& uE) const {
  double work = 0.0;
  for (std::size_t k = declared; k < kept; ++k) {
    const StiffEntry& e = entries[k];
    work += 0.5 * (uA[e.i] + uE[e.i]) * e.K *
            (kImplicitEnd.s * uA[e.j] + kImplicitEnd.a * (uE[e.j] - uA[e.j]));
  }
  return dt * dt * work;
}

}  // namespace dynamy
