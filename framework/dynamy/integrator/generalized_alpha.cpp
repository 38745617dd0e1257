#include <dynamy/core/parameters.hpp>
#include <dynamy/integrator/generalized_alpha.hpp>
#include <dynamy/integrator/velocity_iteration.hpp>

namespace dynamy {
namespace {

constexpr int kMostIterations = 60;

}  // namespace

void GeneralizedAlpha::start(MechanicalSystem& s, State& x) {
  const Eigen::Index n = x.u.size();
  if (x.scheme.size() != 2 * n) {  // v̇ = a = M⁻¹h
    s.evaluate(x, 1);
    x.scheme.resize(2 * n);
    vdotA_.resize(n);
    s.slot(1).mass.applyInverse(view(s.slot(1).h), view(vdotA_));
    x.scheme << vdotA_, vdotA_;
  }
  aA_ = x.scheme.head(n), vdotA_ = x.scheme.tail(n);
}

StepReport GeneralizedAlpha::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                  double dt) {
  const double alphaM = (2.0 * rho_ - 1.0) / (1.0 + rho_), alphaF = rho_ / (1.0 + rho_);
  const double gamma = 0.5 + alphaF - alphaM, beta = 0.25 * (gamma + 0.5) * (gamma + 0.5);
  const double share = (1.0 - alphaF) / (1.0 - alphaM);  // ∂a^E/∂v̇^E
  start(s, x);
  begin_ = x;

  // Active: closed at q^A or at the forecast, or pressed in the last step.
  keys_.clear();
  addKeys(s.evaluate(x, 1).contacts, keys_);
  mean_ = begin_.u + 0.5 * dt * aA_;
  s.move(x, mean_, dt);
  addKeys(s.evaluate(x, 0).contacts, keys_);
  addPressed(begin_.impulses, keys_);

  s.freeze(keys_);
  vdot_ = vdotA_;
  w_.setZero(x.u.size());
  SolveReport solved;
  VelocityIteration iteration(kMostIterations);
  for (bool last = false; !last;) {
    a_ = (1.0 - alphaF) / (1.0 - alphaM) * vdot_ + alphaF / (1.0 - alphaM) * vdotA_ -
         alphaM / (1.0 - alphaM) * aA_;
    uTilde_ = begin_.u + dt * ((1.0 - gamma) * aA_ + gamma * a_);
    mean_ = begin_.u + dt * ((0.5 - beta) * aA_ + beta * a_) + 0.5 * w_;
    x.t = begin_.t, x.q = begin_.q;
    s.move(x, mean_, dt);
    x.u = uTilde_ + w_;
    s.evaluate(x, 0);  // M, h, W at q^E, u^E
    auto& problem = s.impactProblem(begin_, dt);
    s.freeVelocity(uTilde_);
    const auto found = s.impactLaw().solve(problem, solver, s.Lambda());  // −ξ ∈ N_C(Λ)
    addSolve(solved, found);
    solved.status = found.status;
    s.velocityFromImpulses(x);
    begin_.impulses = x.impulses;
    change_ = x.u - uTilde_ - w_;
    w_ = x.u - uTilde_;  // w = M⁻¹WΛ
    double change = change_.lpNorm<Eigen::Infinity>();
    // Newton for M v̇ = h
    residual_.resize(x.u.size());
    s.slot(0).mass.apply(view(std::as_const(vdot_)), view(residual_));
    residual_ = s.slot(0).h - residual_;
    s.implicitMass(x, dt, {0.0, beta * share, gamma * share}, 0);
    s.applyInverseMass(residual_, change_);
    vdot_ += change_;
    change = std::max(change, dt * change_.lpNorm<Eigen::Infinity>());
    const double size = x.u.lpNorm<Eigen::Infinity>();
    last = iteration.done(s, change, size, dt, solved);
  }
  s.thaw();
  x.scheme.head(x.u.size()) = a_, x.scheme.tail(x.u.size()) = vdot_;
  return {dt, solved, s.problem().size()};
}

GeneralizedAlpha::GeneralizedAlpha(const Parameters& x) : OneStep(x), rho_(x["rho"]) {}

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
