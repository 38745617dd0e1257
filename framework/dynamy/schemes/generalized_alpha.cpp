#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/schemes/generalized_alpha.hpp>
#include <dynamy/stages/velocity_iteration.hpp>

namespace dynamy {
namespace {

constexpr int kMostAlphaIterations = 60;

}  // namespace

void GeneralizedAlpha::start(MechanicalSystem& s, State& x) {
  const Eigen::Index n = x.u.size();
  if (x.scheme.size() != 2 * n) {  // v̇ = a = M⁻¹h
    s.evaluate(x, {.slot = 1});
    x.scheme.resize(2 * n);
    vdotA_.resize(n);
    s.slot(1).mass.applyInverse(view(s.slot(1).h), view(vdotA_));
    x.scheme << vdotA_, vdotA_;
  }
  aA_ = x.scheme.head(n), vdotA_ = x.scheme.tail(n);
}

StepReport GeneralizedAlpha::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                  double dt) {
  start(s, x);
  begin_ = x;
  activeContacts(s, x, dt);
  vdot_ = vdotA_;
  w_.setZero(x.u.size());
  SolveReport solved;
  VelocityIteration iteration(kMostAlphaIterations);
  for (bool last = false; !last;) {
    place(s, x, dt);  // a^E, ũ, and M, h, W at q^E, u^E
    const double change = correct(s, solver, x, dt, solved);
    const double size = x.u.lpNorm<Eigen::Infinity>();
    last = iteration.done(s, change, size, dt, solved);
  }
  x.scheme.head(x.u.size()) = a_, x.scheme.tail(x.u.size()) = vdot_;
  return {dt, solved, s.problem().size()};
}

/// Finds the contacts that are closed at q^A or at the prediction, or pressed in the last step.
void GeneralizedAlpha::activeContacts(MechanicalSystem& s, State& x, double dt) {
  keys_.clear();
  addKeys(s.evaluate(x, {.slot = 1}).contacts, keys_);
  mean_ = begin_.u + 0.5 * dt * aA_;
  s.move(x, mean_, dt);
  addKeys(s.evaluate(x).contacts, keys_);
  addPressed(begin_.impulses, keys_);
}

void GeneralizedAlpha::place(MechanicalSystem& s, State& x, double dt) {
  a_ = ((1.0 - alphaF_) * vdot_ + alphaF_ * vdotA_ - alphaM_ * aA_) / (1.0 - alphaM_);
  uTilde_ = begin_.u + dt * ((1.0 - gamma_) * aA_ + gamma_ * a_);
  mean_ = begin_.u + dt * ((0.5 - beta_) * aA_ + beta_ * a_) + 0.5 * w_;
  x.t = begin_.t, x.q = begin_.q;
  s.move(x, mean_, dt);
  x.u = uTilde_ + w_;
  s.evaluate(x, {.held = HeldContacts{keys_}});
}

double GeneralizedAlpha::correct(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt,
                                 SolveReport& solved) {
  const double share = (1.0 - alphaF_) / (1.0 - alphaM_);  // ∂a^E/∂v̇^E
  const double perVdot = gamma_ * share * dt;              // ∂ũ/∂v̇^E
  // u_free = ũ + w + M̂⁻¹ [∂ũ/∂v̇ (h − M v̇) − M w],   u^E = u_free + M̂⁻¹WΛ
  h_ = s.slot(0).h, hNonPotential_ = s.slot(0).hNonPotential;
  uFree_ = -perVdot * vdot_ - w_;
  residual_.resize(x.u.size());
  s.slot(0).mass.apply(view(std::as_const(uFree_)), view(residual_));
  residual_ += perVdot * h_;
  auto& problem = s.impactProblem(begin_, dt);
  problem.implicitMass(s.slot(0), x, dt, {0.0, beta_ * share, gamma_ * share});
  problem.applyInverseMass(residual_, uFree_);
  uFree_ += x.u;
  problem.freeVelocity(uFree_);
  const auto last = problem.solve(solver);  // −ξ ∈ N_C(Λ)
  addSolve(solved, last);
  solved.status = last.status;
  problem.velocityFromImpulses(x);
  s.change(0).h = h_, s.change(0).hNonPotential = hNonPotential_;
  begin_.impulses = x.impulses;
  // w = M⁻¹WΛ; v̇ gains M̂⁻¹(h − M v̇) and, per ∂ũ/∂v̇, the effect of springs on the change of w
  const MassMatrix& mass = s.slot(0).mass;
  mass.apply(view(std::as_const(vdot_)), view(residual_));
  residual_ = h_ - residual_;
  problem.applyInverseMass(residual_, change_);
  vdot_ += change_;
  double change = dt * change_.lpNorm<Eigen::Infinity>();
  mass.apply(view(std::as_const(w_)), view(residual_));
  residual_ = -residual_;
  addForce(s.slot(0).contacts, problem.Lambda().data(), residual_);  // WΛ − M w
  problem.applyInverseMass(residual_, uFree_);
  mass.applyInverse(view(std::as_const(residual_)), view(change_));
  w_ += change_;
  change = std::max(change, change_.lpNorm<Eigen::Infinity>());
  vdot_ += (uFree_ - change_) / perVdot;  // 0 to the last bit without stiff elements
  return std::max(change, (uFree_ - change_).lpNorm<Eigen::Infinity>());
}

GeneralizedAlpha::GeneralizedAlpha(const Parameters& x) : OneStep(x) { weights(x["rho"]); }

void GeneralizedAlpha::weights(double rho) {
  alphaM_ = (2.0 * rho - 1.0) / (1.0 + rho), alphaF_ = rho / (1.0 + rho);
  gamma_ = 0.5 + alphaF_ - alphaM_, beta_ = 0.25 * (gamma_ + 0.5) * (gamma_ + 0.5);
}

void GeneralizedAlpha::declare(Attributes& a) {
  a.about(
      "Nonsmooth generalised-alpha scheme: implicit, order 2 for smooth motion, numerical damping "
      "by "
      "rho, contacts on velocity level.");
  a.optional("rho", Unit::none, 0.9,
             "what is left of infinitely fast oscillations after a step, 0 to 1")
      .between(0.0, 1.0);
  a.example("<simulation until=\"1\" step=\"1e-3\"><GeneralizedAlpha rho=\"0.8\"/></simulation>");
}

}  // namespace dynamy
