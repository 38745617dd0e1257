#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/schemes/constraint_index.hpp>

namespace dynamy {
namespace {

bool anyUnilateral(const ContactSet& c) {
  for (const SetValuedForceLaw* law : c.law)
    if (law->unilateral()) return true;
  return false;
}

}  // namespace

StepReport ConstraintIndex::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                 double dt) {
  s.evaluate(x, {.bias = index_ == 1});    // M, h, W, χ at q^A
  auto& problem = s.impactProblem(x, dt);  // ξ = G Λ + c
  problem.linearlyImplicit(x, kImplicitEnd);
  if (anyUnilateral(*problem.contacts)) return {dt, {}, problem.size(), lacks(Asked::contact)};
  SolveReport solved;
  if (index_ == 3) {  // g(q^E) = 0
    solved = level_.solve(s, problem, solver, x, dt, 1);
    return {dt, solved, problem.size()};
  }
  problem.c = problem.gammaFree;                    // γ^E = 0
  if (index_ == 1) poseAccelerations(problem, dt);  // γ̇ = 0
  solved = solver.solve(problem, problem.Lambda());
  problem.velocityFromImpulses(x);  // u^E = u^A + M⁻¹(h Δt + W Λ)
  s.move(x, dt);                    // q^E = q^A + Δt (F u^E + β)
  return {dt, solved, problem.size()};
}

void ConstraintIndex::poseAccelerations(InclusionProblem& p, double dt) const {
  for (int i = 0; i < p.size(); ++i)
    for (int r = 0; r < p.dim(i); ++r) {
      if (!isPositionRow(p.law(i), r)) continue;
      const auto k = static_cast<std::size_t>(p.row0(i) + r);
      p.c[k] = p.gammaFree[k] - p.gammaA[k] + dt * p.contacts->bias[k];
    }
}

ConstraintIndex::ConstraintIndex(const Parameters& x) : OneStep(x), index_(x["index"].integer()) {}

void ConstraintIndex::declare(Attributes& a) {
  a.about(
      "Joints on the level of accelerations (index 1), velocities (2) or positions (3), order 1; "
      "for comparison, without impacts.");
  a.add(AttributeType::integer, "index", "2", "1, 2 or 3").between(1, 3);
  a.example("<simulation until=\"1\" step=\"1e-3\"><ConstraintIndex index=\"3\"/></simulation>");
}

}  // namespace dynamy
