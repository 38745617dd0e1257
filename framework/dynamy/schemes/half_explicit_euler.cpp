#include <dynamy/schemes/half_explicit_euler.hpp>

namespace dynamy {

StepReport HalfExplicitEuler::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                   double dt) {
  s.move(x, dt);                           // q^E = q^A + Δt (F u^A + β)
  s.evaluate(x);                           // M, h, and W, χ where g(q^E) ≤ g_tol
  auto& problem = s.impactProblem(x, dt);  // ξ = G Λ + c
  problem.linearlyImplicit(x, kImplicitEnd);
  const auto solved = problem.solve(solver);  // Λ = prox_C(Λ − r ξ)
  problem.velocityFromImpulses(x);            // u^E = u^A + M⁻¹(h Δt + W Λ)
  return {dt, solved, problem.size()};
}

void HalfExplicitEuler::declare(Attributes& a) {
  a.about(
      "Half-explicit Euler (Stiegelmeyr, Funk, Foerg, Pfeiffer): W and the laws at the end "
      "position, order 1.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><HalfExplicitEuler/></simulation>");
}

}  // namespace dynamy
