#include <algorithm>
#include <cmath>
#include <dynamy/schemes/joints/joint_equations.hpp>

namespace dynamy {
namespace {

/// Velocities below this share of what a joint's impulse changes in a step count as rest, see the header.
constexpr double kAtRest = 1e-4;
/// Error above which a joint is off, over g_tol: steps and projections that succeed leave less.
constexpr double kOff = 1e3;

bool massDependsOnPosition(const Topology& topology) {
  return std::any_of(topology.systems().begin(), topology.systems().end(), [](const auto* system) {
    const Blocks blocks = system->blocks();
    return blocks.nu > 0 && !blocks.constantMass;
  });
}

void findJoints(const ContactSet& c, std::vector<int>& out) {
  out.clear();
  for (int i = 0; i < c.size(); ++i)
    if (!c.law[i]->unilateral() && c.law[i]->rowKind(0) == RowKind::joint) out.push_back(i);
}

}  // namespace

bool JointEquations::begin(MechanicalSystem& s, const State& x, double dt) {
  xA_ = &x, dt_ = dt;
  const bool coupled = damped_.begin(s, x, dt);
  const ContactSet& c = s.slot(0).contacts;
  findJoints(c, joints_);
  if (joints_.empty() && !massDependsOnPosition(*s.parts().topology)) return false;
  if (coupled || !graph_.isOf(c, joints_)) {
    graph_.build(s.slot(0).mass, c, joints_, damped_.pairs());
    Lambda.assign(static_cast<std::size_t>(graph_.rows()), 0.0);
    R.g = Lambda, R.meanRate = Lambda, gA_ = Lambda, aim_ = Lambda;
  }
  elements_.assign(s.parts().contacts.size(), 0);
  for (const int i : joints_) elements_[c.element[i]] = 1;
  for (std::size_t k = 0; k < joints_.size(); ++k)
    for (int r = 0; r < c.dim(joints_[k]); ++r)
      gA_[graph_.row0(static_cast<int>(k)) + r] = c.position[c.row0[joints_[k]] + r];
  setAim(s);
  v = x.u;
  startFrom(x.impulses, c);
  boundQuotients(s.slot(0));
  return true;
}

/// Sets g* of the step.
void JointEquations::setAim(const MechanicalSystem& s) {
  const double full = s.limits.pushOut, left = full > dt_ ? 1.0 - dt_ / full : 0.0;
  for (std::size_t row = 0; row < gA_.size(); ++row)
    aim_[row] = std::abs(gA_[row]) > kOff * s.gTol() ? left * gA_[row] : 0.0;
}

/// Sets least_ to (kAtRest)² ΛᵀWᵀM⁻¹WΛ per joint.
void JointEquations::boundQuotients(const Evaluation& e) {
  const ContactSet& c = e.contacts;
  least_.assign(joints_.size(), 0.0);
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const int i = joints_[k];
    const double* lambda = Lambda.data() + graph_.row0(static_cast<int>(k));
    for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
      const Segment& seg = c.segment[m];
      const ConstBlock inverse = e.mass.inverse(seg.block);
      const double* W = c.W.data() + seg.w;
      const auto impulse = [&](int j) {
        double sum = 0.0;
        for (int r = 0; r < c.dim(i); ++r) sum += lambda[r] * W[r * seg.nu + j];
        return sum;
      };
      for (int a = 0; a < seg.nu; ++a)
        for (int b = 0; b < seg.nu; ++b)
          least_[k] += kAtRest * kAtRest * impulse(a) * inverse(a, b) * impulse(b);
    }
  }
}

/// Λ of the last step in proportion to Δt; zero for joints that were not there.
void JointEquations::startFrom(const RememberedImpulses& last, const ContactSet& c) {
  std::fill(Lambda.begin(), Lambda.end(), 0.0);
  if (!(last.dt > 0.0)) return;
  // Both lists have mostly the same order: the next one is searched behind the last one found.
  auto behind = last.key.begin();
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const ContactKey key = c.key[joints_[k]];
    auto found = std::find(behind, last.key.end(), key);
    if (found == last.key.end()) {
      found = std::find(last.key.begin(), behind, key);
      if (found == behind) continue;
    }
    behind = found + 1;
    const auto i = static_cast<std::size_t>(found - last.key.begin());
    if (last.first[i + 1] - last.first[i] != c.dim(joints_[k])) continue;
    for (int r = 0; r < c.dim(joints_[k]); ++r)
      Lambda[graph_.row0(static_cast<int>(k)) + r] = dt_ / last.dt * last.Lambda[last.first[i] + r];
  }
}

/// Sets force_ to W̃ Λ.
void JointEquations::setJointForces(const Evaluation& e) {
  const ContactSet& c = e.contacts;
  force_.setZero();
  if (joints_.empty()) return;
  e.mass.apply(view(std::as_const(v)), view(momentum_));
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const int i = joints_[k], dim = c.dim(i), row0 = graph_.row0(static_cast<int>(k));
    const double* lambda = Lambda.data() + row0;
    double power = 0.0, twiceT = 0.0;
    for (int r = 0; r < dim; ++r)
      power += lambda[r] * (c.chi[c.row0[i] + r] - R.meanRate[row0 + r]);
    for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
      const Segment& seg = c.segment[m];
      for (int j = 0; j < seg.nu; ++j) twiceT += v[seg.u0 + j] * momentum_[seg.u0 + j];
      const double* w = c.W.data() + seg.w;
      for (int r = 0; r < dim; ++r, w += seg.nu)
        for (int j = 0; j < seg.nu; ++j) {
          const double f = lambda[r] * w[j];
          force_[seg.u0 + j] += f, power += f * v[seg.u0 + j];
        }
    }
    twiceT = std::max(twiceT, least_[k]);
    if (!(twiceT > 0.0)) continue;
    for (int m = c.segment0[i]; m < c.segment0[i + 1]; ++m) {
      const Segment& seg = c.segment[m];
      for (int j = 0; j < seg.nu; ++j) force_[seg.u0 + j] -= power / twiceT * momentum_[seg.u0 + j];
    }
  }
}

/// Sets R_g, and mean rates, from the joints at q^E.
void JointEquations::setGaps(MechanicalSystem& s) {
  const ContactSet& atEnd =
      s.evaluate(end, {.slot = 1, .elements = elements_, .withheld = damped_.withheld()}).contacts;
  findJoints(atEnd, endJoints_);
  for (std::size_t k = 0; k < endJoints_.size(); ++k)
    for (int r = 0; r < atEnd.dim(endJoints_[k]); ++r) {
      const auto row = static_cast<std::size_t>(graph_.row0(static_cast<int>(k)) + r);
      const double g = atEnd.position[atEnd.row0[endJoints_[k]] + r];
      R.g[row] = (g - aim_[row]) / dt_;
      R.meanRate[row] = g / dt_ - gA_[row] / dt_;
    }
}

void JointEquations::evaluate(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse,
                              Search search) {
  const Eigen::Index nu = v.size();
  momentum_.resize(nu), force_.resize(nu), change_.resize(nu), R.v.resize(nu);
  midpoint.t = end.t = xA_->t;
  midpoint.q = end.q = xA_->q;
  midpoint.memory = end.memory = xA_->memory;
  s.move(midpoint, v, 0.5 * dt_), s.move(end, v, dt_);
  midpoint.u = v, end.u = 2.0 * v - xA_->u;
  EvaluationRequest atMidpoint{.withheld = damped_.withheld()};
  if (search == Search::all)
    atMidpoint.ahead = dt_;
  else
    atMidpoint.elements = elements_;
  const Evaluation& e = s.evaluate(midpoint, atMidpoint);
  findJoints(e.contacts, joints_);
  endJoints_.clear();
  if (rows() > 0) setGaps(s);
  setJointForces(e);
  change_ = 2.0 * (v - xA_->u);
  e.mass.apply(view(std::as_const(change_)), view(momentum_));
  R.v = momentum_ - dt_ * e.h - force_ - contactImpulse;
  if (!damped_.any()) return;
  h_.setZero(nu), hNonPotential_.setZero(nu);
  damped_.addTo(v, xA_->u, h_, hNonPotential_);
  R.v -= dt_ * h_;
}

void JointEquations::finish(MechanicalSystem& s) {
  if (!damped_.any()) return;
  h_ = s.slot(0).h, hNonPotential_ = s.slot(0).hNonPotential;
  damped_.addTo(v, xA_->u, h_, hNonPotential_);
  const Evaluation& e = s.slot(0);
  s.implicitForces().dampedWork(dt_ * (h_ - e.h - hNonPotential_ + e.hNonPotential).dot(v));
  s.change(0).h = h_, s.change(0).hNonPotential = hNonPotential_;
}

}  // namespace dynamy
