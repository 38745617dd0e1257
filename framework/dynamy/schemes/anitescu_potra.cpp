#include <dynamy/schemes/anitescu_potra.hpp>

namespace dynamy {

StepReport AnitescuPotra::step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) {
  s.evaluate(x);                           // M, h, and W, χ where g(q^A) ≤ g_tol
  auto& problem = s.impactProblem(x, dt);  // ξ = G Λ + c
  problem.linearlyImplicit(x, kImplicitEnd);
  const auto solved = problem.solve(solver);  // Λ = prox_C(Λ − r ξ)
  problem.velocityFromImpulses(x);            // u^E = u^A + M⁻¹(h Δt + W Λ)
  s.move(x, dt);                              // q^E = q^A + Δt (F u^E + β)
  return {dt, solved, problem.size()};
}

void AnitescuPotra::declare(Attributes& a) {
  a.about(
      "Anitescu and Potra's scheme: laws on velocity level at the beginning of the step, order 1; "
      "the original takes PoissonImpact.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><AnitescuPotra/><PoissonImpact/></simulation>");
}

}  // namespace dynamy
