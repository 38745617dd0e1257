#include <dynamy/schemes/stewart_trinkle.hpp>
#include <dynamy/stages/displacement_level.hpp>

namespace dynamy {

StepReport StewartTrinkle::step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) {
  s.evaluate(x, {.ahead = dt});            // M, h, W, χ and g at q^A
  auto& problem = s.impactProblem(x, dt);  // ξ = G Λ + c
  problem.linearlyImplicit(x, kImplicitEnd);
  aimAtPositions(problem, dt);                                  // ξ_N = γ_N^E + g/Δt
  const auto solved = solver.solve(problem, problem.Lambda());  // Λ = prox_C(Λ − r ξ)
  const auto lacking = lackingAtImpact(s);
  problem.velocityFromImpulses(x);  // u^E = u^A + M⁻¹(h Δt + W Λ)
  s.move(x, dt);                    // q^E = q^A + Δt (F u^E + β)
  return {dt, solved, problem.size(), lacking};
}

std::string_view StewartTrinkle::lacks(Asked what) const {
  switch (what) {
    case Asked::rebound:
      return "a contact with restitution closes, and this scheme knows no rebound";
    case Asked::impactLaw:
      return "it stops what arrives by its own law and takes no impact law";
    default:
      return {};
  }
}

void StewartTrinkle::declare(Attributes& a) {
  a.about(
      "Stewart and Trinkle's scheme: the linearised gap at the end of the step in the law, no "
      "rebound, order 1.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><StewartTrinkle/></simulation>");
}

}  // namespace dynamy
