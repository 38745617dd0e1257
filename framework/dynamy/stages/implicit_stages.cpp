// The stages of MechanicalSystem that take stiff forces linearly implicitly, and those by which a
// scheme replaces u_free or h.
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

void MechanicalSystem::freeVelocity(const Eigen::VectorXd& uFree) {
  uFree_ = uFree - uFree_;
  gammaWork_.resize(problem_.gammaFree.size());
  const auto rows = static_cast<Eigen::Index>(gammaWork_.size());
  if (rows > 0) problem_.contacts->gamma({uFree_.data(), uFree_.size()}, {gammaWork_.data(), rows});
  for (std::size_t k = 0; k < gammaWork_.size(); ++k)
    problem_.gammaFree[k] += gammaWork_[k] - problem_.contacts->chi[k];
  uFree_ = uFree;
  scales();
}

void MechanicalSystem::implicitMass(const State& x, double dt, const ImplicitWeights& weights,
                                    int slot) {
  if (!stiff_.any()) return;
  const Evaluation& e = slots_[static_cast<std::size_t>(slot)];
  const MassMatrix& mass = slots_[static_cast<std::size_t>(slot_)].mass;
  stiff_.evaluate(*parts_.topology, parts_.forces, e.kinematics, x);
  stiff_.factor(mass, dt, weights);
  implicit_ = true;
  if (problem_.rows() > 0) stiff_.delassus(*problem_.contacts, mass, delassus_);
}

void MechanicalSystem::linearlyImplicit(const State& x, const ImplicitWeights& weights, int slot) {
  if (!stiff_.any() || implicit_) return;  // no stiff forces, or they are taken implicitly already
  const Evaluation& e = slots_[static_cast<std::size_t>(slot)];
  implicitMass(x, problem_.dt, weights, slot);
  implicitChange(e, uA_, problem_.dt);
  implicitFree_ += uA_;
  freeVelocity(implicitFree_);
}

/// u_free − u^A = M̂⁻¹ Δt (h + Δt s K u^A)
void MechanicalSystem::implicitChange(const Evaluation& e, const Eigen::VectorXd& uA, double dt) {
  work_ = dt * e.h;
  stiff_.addStart(dt, uA, work_);
  stiff_.applyInverse(e.mass, work_, implicitFree_);
}

const Evaluation& MechanicalSystem::evaluateDamped(const State& x, double dt,
                                                   const ImplicitWeights& declared) {
  Evaluation& e = slots_.front();
  smooth(x, e);
  forgetAside();
  unresolved_ =
      stiff_.evaluateUnresolved(*parts_.topology, parts_.forces, e.kinematics, x, e.mass, dt);
  damped_ = unresolved_ ? stiff_.unresolved() : 0;
  if (unresolved_) {
    stiff_.factor(e.mass, dt, declared);
    implicitChange(e, x.u, dt);
    change_ = implicitFree_ / dt;
  } else {
    e.mass.applyInverse(view(std::as_const(e.h)), view(change_));
  }
  detectAhead(x, dt, e);
  return e;
}

void MechanicalSystem::gyroscopicAtMean(const State& x, double dt) {
  const Topology& topology = *parts_.topology;
  Evaluation& e = slots_.front();
  // Where forces are damped, bodies turn under M (u_free − u^A)/Δt: h would spin them up.
  if (unresolved_) {
    e.mass.apply(view(std::as_const(implicitFree_)), view(work_));
    work_ /= dt;
    e.h -= work_;
  }
  Eigen::VectorXd& h = unresolved_ ? work_ : e.h;
  for (std::size_t i = 0; i < topology.systems().size(); ++i) {
    const SystemHandle& s = topology.system(static_cast<int>(i));
    if (s.nu > 0)
      topology.systems()[i]->gyroscopicAtMean(x.t, slice(x.q, s.q0, s.nq), slice(x.u, s.u0, s.nu),
                                              dt, slice(h, s.u0, s.nu));
  }
  if (unresolved_) e.h += h;
}

bool MechanicalSystem::explicitIsUnstable(const State& x, double dt, double limit, int slot) {
  if (!stiff_.any()) return false;
  const Evaluation& e = slots_[static_cast<std::size_t>(slot)];
  stiff_.evaluate(*parts_.topology, parts_.forces, e.kinematics, x);
  return stiff_.explicitIsUnstable(e.mass, dt, limit);
}

void MechanicalSystem::applyInverseMass(const Eigen::VectorXd& in, Eigen::VectorXd& out) const {
  const MassMatrix& mass = slots_[static_cast<std::size_t>(slot_)].mass;
  out.resize(in.size());
  if (implicit_)
    stiff_.applyInverse(mass, in, out);
  else
    mass.applyInverse(view(in), view(out));
}

void MechanicalSystem::addImplicitVelocity(State& x) {
  Evaluation& e = slots_[static_cast<std::size_t>(slot_)];
  if (problem_.rows() > 0)
    stiff_.addVelocity(e.contacts, e.mass, Lambda_.data(), x.u);  // u^E = u_free + M̂⁻¹WΛ
  // The h that the step used:  M(u^E − u^A) = Δt h + WΛ; dampers have no potential.
  stiff_.addUsedForce(problem_.dt, uA_, x.u, e.h, e.hNonPotential);
}

void MechanicalSystem::usedForce(const Eigen::VectorXd& h, const Eigen::VectorXd& hNonPotential) {
  slots_.front().h = h, slots_.front().hNonPotential = hNonPotential;
}

}  // namespace dynamy
