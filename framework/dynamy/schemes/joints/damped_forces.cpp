#include <algorithm>
#include <dynamy/schemes/joints/damped_forces.hpp>

namespace dynamy {

bool DampedForces::begin(MechanicalSystem& s, const State& x, double dt) {
  dt_ = dt;
  const std::vector<const ExternalForce*>& forces = s.parts().forces;
  // The forces of the last step, mostly the same.
  const Evaluation* e = &without(s, x);
  if (forces.empty()) return false;
  const bool some = forces_.find(forces, e->kinematics, e->mass, dt);
  s.implicitForces().resolution({forces_.swing(), some});
  if (!some && withheld_.empty()) return false;
  if (!std::equal(withheld_.begin(), withheld_.end(), forces_.damped().begin(),
                  forces_.damped().end())) {
    withheld_.assign(forces_.damped().begin(), forces_.damped().end());
    if (!some) withheld_.clear();
    e = &without(s, x);
  }
  uBegin_ = x.u;
  h_.setZero(x.u.size()), nonPotential_.setZero(x.u.size());
  ForceSink sink(view(h_), view(nonPotential_));
  for (std::size_t i = 0; i < withheld_.size(); ++i) {
    if (withheld_[i] == 0) continue;
    sink.hasPotential(forces[i]->hasPotential());
    forces[i]->addTo(e->kinematics, sink);
  }
  couple();
  const bool same = found_ == pairs_;
  pairs_.swap(found_);
  return !same;
}

const Evaluation& DampedForces::without(MechanicalSystem& s, const State& x) const {
  s.implicitForces().damp(withheld_);
  return s.evaluate(x, {.ahead = dt_, .withheld = withheld_});
}

void DampedForces::couple() {
  found_.clear();
  for (const StiffEntry& e : forces_.entries())
    if (forces_.block(e.i) != forces_.block(e.j))
      found_.emplace_back(forces_.block(e.i), forces_.block(e.j));
  std::sort(found_.begin(), found_.end());
  found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
}

void DampedForces::addTo(const Eigen::VectorXd& v, const Eigen::VectorXd& uA, Eigen::VectorXd& h,
                         Eigen::VectorXd& nonPotential) const {
  if (!any()) return;
  h += h_, nonPotential += nonPotential_;
  for (const StiffEntry& e : forces_.entries()) {
    const double damping = e.D * (2.0 * v[e.j] - uA[e.j] - uBegin_[e.j]);
    h[e.i] += dt_ * e.K * (2.0 * v[e.j] - 0.5 * uA[e.j]) + damping;
    nonPotential[e.i] += damping;
  }
}

}  // namespace dynamy
