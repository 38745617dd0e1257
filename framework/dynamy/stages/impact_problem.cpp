#include <algorithm>
#include <dynamy/stages/impact_problem.hpp>
#include <dynamy/stages/problem_scales.hpp>

namespace dynamy {

void ImpactProblem::pose(const Posing& from, const State& x, double step, const PositionAim* aim) {
  parts_ = &from.parts, from_ = &from.at, implicitForces_ = &from.implicit, gTol_ = from.gTol;
  G = &delassus_, contacts = &from_->contacts;
  dt = step, corrected = Corrected::never;
  effort = from.limits.effort, workers = from.limits.workers, stop = from.limits.stop;
  work = from.limits.work;
  freeMotion(from, x);
  gammaOf(uFree_, gammaFree);
  if (aim && from.main &&
      closing_.reduce(from_->contacts, view(std::as_const(uFree_)), dt, gTol_, x.impulses))
    gammaOf(uFree_, gammaFree);
  gammaOf(uA_, gammaA);
  c.resize(gammaA.size());
  if (implicit_ && rows() > 0)
    implicitForces_->stiff().delassus(*contacts, from_->mass, delassus_);
  else if (rows() > 0)
    delassus_.assemble(*contacts, from_->mass, from.limits.form);
  gapNoise_ = aim ? aim->noise / dt : 0.0;
  if (aim) addAim({*aim, gTol_, from.limits.pushOut}, uA_, uFree_, *this, arriving_);
  start_.set(*contacts, x.impulses, dt, Lambda_);
  scale();
}

/// u_free = u^A + M⁻¹hΔt
void ImpactProblem::freeMotion(const Posing& from, const State& x) {
  uA_ = x.u, uFree_.resize(uA_.size());
  implicit_ = from.main && implicitForces_->unresolved();
  if (implicit_) {
    uFree_ = uA_ + implicitForces_->change(*from_, uA_, dt);
    return;
  }
  from_->mass.applyInverse(view(std::as_const(from_->h)), view(uFree_));
  uFree_ = uA_ + dt * uFree_;
}

void ImpactProblem::gammaOf(const Eigen::VectorXd& u, std::vector<double>& out) const {
  const Eigen::Index n = rows();
  out.resize(static_cast<std::size_t>(n));
  if (n > 0) contacts->gamma({u.data(), u.size()}, {out.data(), n});
}

void ImpactProblem::scale() {
  if (setScales({uA_, uFree_, gTol_, gapNoise_}, *this, work_))
    std::fill(Lambda_.begin(), Lambda_.end(), 0.0);
}

SolveReport ImpactProblem::solve(InclusionSolver& solver) {
  return parts_->impactLaw->solve(*this, solver, Lambda());
}

bool ImpactProblem::bringIn() {
  if (!closing_.any()) return false;
  work_ = uFree_;
  if (rows() > 0 && implicit_)
    implicitForces_->stiff().addVelocity(*contacts, from_->mass, Lambda_.data(), work_);
  else if (rows() > 0)
    delassus_.addVelocity(Lambda_.data(), view(work_));
  start_.again(*contacts, Lambda_);
  return closing_.bringIn(from_->contacts, work_, dt);
}

void ImpactProblem::freeVelocity(const Eigen::VectorXd& uFree) {
  uFree_ = uFree - uFree_;
  gammaWork_.resize(gammaFree.size());
  const auto n = static_cast<Eigen::Index>(gammaWork_.size());
  if (n > 0) contacts->gamma({uFree_.data(), uFree_.size()}, {gammaWork_.data(), n});
  for (std::size_t k = 0; k < gammaWork_.size(); ++k)
    gammaFree[k] += gammaWork_[k] - contacts->chi[k];
  uFree_ = uFree;
  scale();
}

void ImpactProblem::implicitMass(const Evaluation& at, const State& x, double step,
                                 const ImplicitWeights& weights) {
  if (!implicitForces_->any()) return;
  implicitForces_->factor(*parts_, at, x, from_->mass, step, weights);
  implicit_ = true;
  if (rows() > 0) implicitForces_->stiff().delassus(*contacts, from_->mass, delassus_);
}

void ImpactProblem::linearlyImplicit(const State& x, const ImplicitWeights& weights) {
  // No stiff forces, or they are taken implicitly already.
  if (!implicitForces_->any() || implicit_) return;
  implicitMass(*from_, x, dt, weights);
  work_ = uA_ + implicitForces_->change(*from_, uA_, dt);
  freeVelocity(work_);
}

void ImpactProblem::applyInverseMass(const Eigen::VectorXd& in, Eigen::VectorXd& out) const {
  out.resize(in.size());
  if (implicit_)
    implicitForces_->stiff().applyInverse(from_->mass, in, out);
  else
    from_->mass.applyInverse(view(in), view(out));
}

void ImpactProblem::velocityFromImpulses(State& x) {
  x.u = uFree_;
  if (implicit_) {
    StiffPart& stiff = implicitForces_->stiff();
    if (rows() > 0)
      stiff.addVelocity(*contacts, from_->mass, Lambda_.data(), x.u);  // u^E = u_free + M̂⁻¹WΛ
    implicitForces_->bookDampedWork(*parts_, *from_, dt, uA_, x.u);
    // The h that the step used:  M(u^E − u^A) = Δt h + WΛ; dampers have no potential.
    stiff.addUsedForce(dt, uA_, x.u, from_->h, from_->hNonPotential);
  } else if (rows() > 0) {
    delassus_.addVelocity(Lambda_.data(), view(x.u));  // u^E = u^A + M⁻¹WΛ
  }
  keepImpulses(x);
}

void ImpactProblem::keepImpulses(State& x) const {
  x.impulses.key = contacts->key;
  x.impulses.first = contacts->row0;
  x.impulses.Lambda = Lambda_;
  x.impulses.dt = dt;
}

}  // namespace dynamy
