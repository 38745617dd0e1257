#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/resolution_watch.hpp>
#include <dynamy/stages/error_norm.hpp>

namespace dynamy {

ResolutionWatch::ResolutionWatch(const Model& model, RunReport& report) : report_(report) {
  for (Eigen::VectorXd* v : {&increment_, &before_, &momentum_}) v->setZero(model.topology().nu());
  Eigen::VectorXd positions;
  unitScales(model.topology(), model.length(), positions, perUnit_);
  perUnit_ = model.length() * perUnit_.cwiseInverse();
}

double ResolutionWatch::step(const StepView& view) {
  const Evaluation& e = view.system.slot(0);
  const double dt = view.report.dt;
  // Energy that the forces alone would give in one step: the smallest scale of energies at rest.
  before_ = view.after.u - view.before.u;
  e.mass.applyInverse(dynamy::view(e.h), dynamy::view(momentum_));
  const double force = dt * dt * e.h.dot(momentum_);
  double given = 0.0;
  // Forces that the step does not resolve are excluded, because it takes only a part of them in h.
  if (view.system.implicitForces().damped() == 0) {
    given = 0.5 * force;
    report_.trust.stepEnergy = std::max(report_.trust.stepEnergy, given);
    if (momentum_.size() > 0)
      report_.trust.fall =
          std::max(report_.trust.fall,
                   0.5 * dt * dt * momentum_.cwiseProduct(perUnit_).cwiseAbs().maxCoeff());
  }
  const bool changed =
      report_.contacts.switches != switches_ || report_.contacts.impacts != impacts_;
  switches_ = report_.contacts.switches, impacts_ = report_.contacts.impacts;
  smooth_ = changed ? 0 : smooth_ + 1;
  if (smooth_ > 1) {
    increment_ = before_ - increment_;
    e.mass.apply(dynamy::view(std::as_const(increment_)), dynamy::view(momentum_));
    curvature_ += increment_.dot(momentum_);
    e.mass.apply(dynamy::view(view.after.u), dynamy::view(momentum_));
    speed_ += view.after.u.dot(momentum_) + force;
  }
  increment_ = before_;
  return given;
}

void ResolutionWatch::finish() {
  const RunTrust& t = report_.trust;
  const bool moves = t.kineticMax * RunTrust::kWarned > t.rounding;
  report_.trust.omegaDt = moves && speed_ > 0.0 ? std::sqrt(std::sqrt(curvature_ / speed_)) : 0.0;
}

void ResolutionWatch::archive(Archive& a) {
  a.section("resolution watch");
  const Eigen::Index nu = increment_.size();
  a(switches_), a(impacts_), a(smooth_), a(curvature_), a(speed_), a(increment_);
  if (increment_.size() != nu)
    throw ModelError("the checkpoint belongs to another model: it has " +
                     std::to_string(increment_.size()) + " velocities");
}

}  // namespace dynamy
