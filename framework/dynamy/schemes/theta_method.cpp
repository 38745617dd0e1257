#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/schemes/theta_method.hpp>
#include <dynamy/stages/velocity_iteration.hpp>

namespace dynamy {
namespace {

constexpr int kMostThetaIterations = 50;

}  // namespace

StepReport ThetaMethod::step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) {
  begin_ = x;
  s.evaluate(x, {.slot = 1});      // h(q^A, u^A)
  s.move(x, (1.0 - theta_) * dt);  // q^M = q^A + (1−Θ)Δt (F u^A + β)
  s.evaluate(x);                   // M, and W, χ where g(q^M) ≤ g_tol
  end_ = x;
  SolveReport solved;
  VelocityIteration iteration(kMostThetaIterations);
  for (bool last = false; !last;) {
    // h at the present q^E = q^M + ΘΔt (F u^E + β)
    x.t = end_.t, x.q = end_.q;
    s.move(x, theta_ * dt);
    const Evaluation &A = s.slot(1), &E = s.evaluate(x, {.slot = 2});
    h_ = theta_ * E.h + (1.0 - theta_) * A.h;
    hNonPotential_ = theta_ * E.hNonPotential + (1.0 - theta_) * A.hNonPotential;
    // M̂ (u_free − u) = M (u^A − u) + Δt h
    auto& problem = s.impactProblem(begin_, dt);
    problem.implicitMass(E, x, dt, {0.0, theta_ * theta_, theta_});
    uFree_ = begin_.u - x.u;
    residual_.resize(x.u.size());
    s.slot(0).mass.apply(view(std::as_const(uFree_)), view(residual_));
    residual_ += dt * h_;
    problem.applyInverseMass(residual_, uFree_);
    uFree_ += x.u;
    problem.freeVelocity(uFree_);
    const auto found = problem.solve(solver);  // Λ = prox_C(Λ − r ξ)
    addSolve(solved, found);
    solved.status = found.status;
    residual_ = x.u;
    problem.velocityFromImpulses(x);  // u^E = u_free + M̂⁻¹ W Λ
    const double size = x.u.lpNorm<Eigen::Infinity>();
    const double change = (x.u - residual_).lpNorm<Eigen::Infinity>();
    begin_.impulses = x.impulses;
    begin_.impulses.dt = dt;
    last = iteration.done(s, change, size, dt, solved);
  }
  s.change(0).h = h_, s.change(0).hNonPotential = hNonPotential_;
  x.t = end_.t, x.q = end_.q;
  s.move(x, theta_ * dt);  // q^E = q^M + ΘΔt (F u^E + β)
  return {dt, solved, s.problem().size()};
}

ThetaMethod::ThetaMethod(const Parameters& x) : OneStep(x), theta_(x["theta"]) {}

void ThetaMethod::declare(Attributes& a) {
  a.about(
      "Modified theta method: smooth forces implicit, theta h(end) + (1 - theta) h(begin), "
      "contacts "
      "as in Moreau's rule; theta = 1/2 is neutral, above it dissipates.");
  a.optional("theta", Unit::none, 0.5, "theta, 1/2 to 1").between(0.5, 1.0);
  a.example("<simulation until=\"1\" step=\"1e-3\"><ThetaMethod theta=\"0.6\"/></simulation>");
}

}  // namespace dynamy
