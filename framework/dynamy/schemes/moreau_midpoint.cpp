#include <dynamy/schemes/moreau_midpoint.hpp>

namespace dynamy {

StepReport MoreauMidpoint::step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) {
  s.move(x, dt / 2);                       // q^M = q^A + Δt/2 (F u^A + β)
  s.evaluate(x);                           // M, h, and W, χ where g(q^M) ≤ g_tol
  auto& problem = s.impactProblem(x, dt);  // ξ = G Λ + c
  problem.linearlyImplicit(x, kImplicitMidpoint);
  const auto solved = problem.solve(solver);  // Λ = prox_C(Λ − r ξ)
  problem.velocityFromImpulses(x);            // u^E = u^A + M⁻¹(h Δt + W Λ)
  s.move(x, dt / 2);                          // q^E = q^M + Δt/2 (F u^E + β)
  return {dt, solved, problem.size()};
}

void MoreauMidpoint::interpolate(const MechanicalSystem& s, const State& a, const State& b,
                                 double theta, State& out) const {
  // The scheme's own trajectory: u^A up to the midpoint, u^E after it.
  const double dt = b.t - a.t;
  out.t = a.t, out.q = a.q, out.u = theta < 0.5 ? a.u : b.u;
  if (theta <= 0.5) {
    s.move(out, a.u, theta * dt);
  } else {
    s.move(out, a.u, 0.5 * dt);
    s.move(out, b.u, (theta - 0.5) * dt);
  }
}

void MoreauMidpoint::declare(Attributes& a) {
  a.about(
      "Moreau's midpoint rule: explicit in positions, one inclusion problem per step, order 1 with "
      "contact.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><MoreauMidpoint/></simulation>");
}

}  // namespace dynamy
