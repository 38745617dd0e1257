#include <algorithm>
#include <dynamy/stages/implicit_forces.hpp>

namespace dynamy {

ImplicitForces::ImplicitForces(const SystemParts& parts) {
  change_.setZero(parts.topology->nu());
  work_ = change_, acceleration_ = change_;
  stiff_.resize(*parts.topology, parts.forces);
}

void ImplicitForces::resolve(const SystemParts& parts, const Evaluation& e, const State& x,
                             double dt, const ImplicitWeights& declared, Keeping keeping) {
  unresolved_ = stiff_.evaluateUnresolved(*parts.topology, parts.forces, e.kinematics, x, e.mass,
                                          dt, keeping);
  const double swing = stiff_.found().swing();
  resolution_ = {swing, swing > ForceResolution::kExplicit};
  damp(unresolved_ ? stiff_.found().damped() : std::span<const char>());
  if (!unresolved_) return;
  stiff_.factor(e.mass, dt, declared);
  acceleration_ = change(e, x.u, dt) / dt;
}

void ImplicitForces::damp(std::span<const char> forces) {
  which_ = forces, dampedWork_ = 0.0;
  damped_ = static_cast<int>(std::count(forces.begin(), forces.end(), 1));
}

void ImplicitForces::bookDampedWork(const SystemParts& parts, const Evaluation& e, double dt,
                                    const Eigen::VectorXd& uA, const Eigen::VectorXd& uE) {
  if (damped_ == 0) return;
  work_.setZero(uA.size()), change_.setZero(uA.size());
  ForceSink sink(view(work_), view(change_));
  for (std::size_t i = 0; i < which_.size(); ++i) {
    if (which_[i] == 0) continue;
    sink.hasPotential(parts.forces[i]->hasPotential());
    parts.forces[i]->addTo(e.kinematics, sink);
  }
  dampedWork_ = 0.5 * dt * (work_ - change_).dot(uA + uE) + stiff_.workOfDamped(dt, uA, uE);
}

const Eigen::VectorXd& ImplicitForces::change(const Evaluation& e, const Eigen::VectorXd& uA,
                                              double dt) {
  work_ = dt * e.h;
  stiff_.addStart(dt, uA, work_);
  stiff_.applyInverse(e.mass, work_, change_);
  return change_;
}

const Eigen::VectorXd& ImplicitForces::acceleration(const Evaluation& e) const {
  if (!unresolved_) e.mass.applyInverse(view(e.h), view(acceleration_));
  return acceleration_;
}

void ImplicitForces::factor(const SystemParts& parts, const Evaluation& e, const State& x,
                            const MassMatrix& mass, double dt, const ImplicitWeights& weights) {
  expects(!parts.subset, "stiff forces are those of a whole system, not of a view");
  stiff_.evaluate(*parts.topology, parts.forces, e.kinematics, x);
  stiff_.factor(mass, dt, weights);
}

bool ImplicitForces::explicitIsUnstable(const SystemParts& parts, const Evaluation& e,
                                        const State& x, double dt, double limit) {
  if (!any()) return false;
  stiff_.evaluate(*parts.topology, parts.forces, e.kinematics, x);
  return stiff_.explicitIsUnstable(e.mass, dt, limit);
}

void ImplicitForces::gyroscopicAtMean(const SystemParts& parts, Evaluation& e, const State& x,
                                      double dt) {
  // Where forces are damped, bodies turn under M (u_free − u^A)/Δt: h would spin them up.
  if (unresolved_) {
    e.mass.apply(view(std::as_const(change_)), view(work_));
    work_ /= dt;
    e.h -= work_;
  }
  Eigen::VectorXd& h = unresolved_ ? work_ : e.h;
  parts.forSystems([&](std::size_t i) {
    const SystemHandle& s = parts.topology->system(static_cast<int>(i));
    if (s.nu > 0)
      parts.topology->systems()[i]->gyroscopicAtMean(
          x.t, slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu), dt, slice(h, s.u0, s.nu));
  });
  if (unresolved_) e.h += h;
}

}  // namespace dynamy
