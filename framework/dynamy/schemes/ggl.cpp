#include <algorithm>
#include <dynamy/schemes/ggl.hpp>

namespace dynamy {

StepReport Ggl::step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) {
  begin_ = x;
  // Position level: no forces, no friction; velocities (q^E − q^A)/Δt = u^A + M⁻¹Wτ/Δt.
  s.evaluate(x, {.slot = 1, .ahead = dt});
  ContactSet& contacts = s.change(1).contacts;
  while (laws_.size() < contacts.law.size()) laws_.push_back(std::make_unique<PositionLaw>());
  for (std::size_t i = 0; i < contacts.law.size(); ++i) {
    laws_[i]->of(*contacts.law[i]);
    contacts.law[i] = laws_[i].get();
  }
  auto& positions = s.impactProblem(x, dt, 1);
  positions.freeVelocity(begin_.u);
  positions.Lambda().setZero();
  const auto moved = level_.solve(s, positions, solver, x, dt, 2);
  // Velocity level at q^E.
  x.u = begin_.u, x.impulses = begin_.impulses;
  s.evaluate(x);
  auto& problem = s.impactProblem(x, dt);
  problem.linearlyImplicit(x, kImplicitEnd);
  auto solved = problem.solve(solver);
  problem.velocityFromImpulses(x);
  solved.iterations += moved.iterations;
  if (!moved.ok()) solved.status = moved.status;
  return {dt, solved, problem.size()};
}

void PositionLaw::prox(const LawInput& in, const double* r, const double* xi,
                       double* Lambda) const {
  for (int k = 0; k < in.dim; ++k) {
    const bool kept = isPositionRow(*law_, k);
    Lambda[k] = kept ? Lambda[k] - r[k] * xi[k] : 0.0;
    if (unilateral()) Lambda[k] = std::max(0.0, Lambda[k]);
  }
}

bool PositionLaw::proxDerivative(const LawInput& in, double rho, const double* xi,
                                 const double* Lambda, double* A, double* B) const {
  std::fill_n(A, in.dim * in.dim, 0.0);
  std::fill_n(B, in.dim * in.dim, 0.0);
  for (int k = 0; k < in.dim; ++k) {
    const bool kept = isPositionRow(*law_, k);
    const bool free = kept && (!unilateral() || Lambda[k] - rho * xi[k] > 0.0);
    A[k * in.dim + k] = free ? 0.0 : 1.0, B[k * in.dim + k] = free ? rho : 0.0;
  }
  return true;
}

void Ggl::declare(Attributes& a) {
  a.about(
      "Gear, Gupta and Leimkuhler's stabilisation: laws on velocity and on position level, order "
      "1, neither drift nor penetration.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><Ggl/></simulation>");
}

}  // namespace dynamy
