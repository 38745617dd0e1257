#include <algorithm>
#include <dynamy/schemes/nonsmooth_rattle.hpp>

namespace dynamy {
namespace {

constexpr int kMostRattleIterations = 30;
constexpr double kRattleConverged = 1e-13;  ///< change of h(q^A, u^½), relative
constexpr double kRattleStalled = 1e-9;     ///< a change that stalls is accepted below this
constexpr double kLeapfrog = 2.0;           ///< largest stable ωΔt

}  // namespace

StepReport NonsmoothRattle::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                 double dt) {
  begin_ = x;
  s.evaluate(begin_, {.slot = 1, .ahead = dt});  // M, h, W at q^A
  if (explicitIsUnstable(s, 1, begin_, dt, kLeapfrog))
    return {dt, {}, 0, lacks(Asked::stiffForces)};
  const auto first = positions(s, solver, x, dt);
  auto solved = velocities(s, solver, x, dt);
  solved.iterations += first.iterations;
  if (!first.ok()) solved.status = first.status;
  return {dt, solved, s.problem().size()};
}

SolveReport NonsmoothRattle::positions(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                       double dt) {
  keys_.clear();
  addKeys(s.slot(1).contacts, keys_);
  SolveReport solved;
  half_ = begin_;
  double before = 0.0;
  for (int i = 0;; ++i) {
    h_ = s.slot(1).h, hNonPotential_ = s.slot(1).hNonPotential;
    x = begin_, x.impulses = half_.impulses;
    auto& problem = s.impactProblem(x, 0.5 * dt, 1);  // u_free = u^A + Δt/2 M⁻¹ h
    // g(q^A ⊕ Δt u^½) ⊥ Λ₁
    const auto last = level_.solve(s, problem, solver, x, dt, 0);
    addSolve(solved, last);
    solved.status = last.status;
    // h(q^A, u^½)
    half_.u = x.u, half_.impulses = x.impulses;
    s.evaluate(half_, {.slot = 1, .held = HeldContacts{keys_}});
    const double size = s.slot(1).h.lpNorm<Eigen::Infinity>();
    const double change = (s.slot(1).h - h_).lpNorm<Eigen::Infinity>();
    const bool stalls = i > 4 && change > 0.5 * before;
    if (change <= kRattleConverged * size || (stalls && change <= kRattleStalled * size)) break;
    before = change;
    if (i == kMostRattleIterations) {
      solved.status = SolveStatus::maxIterations;
      break;
    }
  }
  first_ = x.impulses;
  return solved;
}

void NonsmoothRattle::closedAtEnd(const MechanicalSystem& s) {
  keys_.clear();
  const ContactSet& c = s.slot(0).contacts;
  for (std::size_t i = 0; i < c.key.size(); ++i)
    if (!c.law[i]->unilateral() || c.position[static_cast<std::size_t>(c.row0[i])] <= s.gTol())
      keys_.push_back(c.key[i]);
  addPressed(first_, keys_);
}

SolveReport NonsmoothRattle::velocities(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                        double dt) {
  uHalf_ = x.u;
  closedAtEnd(s);
  s.evaluate(x, {.held = HeldContacts{keys_}});  // M, h, W at q^E, u^½
  // γ^A = W^Eᵀ u^A;  u_free = u^½ + M⁻¹(Δt/2 h − W Λ₁)
  x.u = begin_.u;
  auto& problem = s.impactProblem(x, dt, 0);
  carry(first_, s.slot(0).contacts, carried_);
  momentum_.setZero(x.u.size());
  addForce(s.slot(0).contacts, carried_.data(), momentum_);
  momentum_ = 0.5 * dt * s.slot(0).h - momentum_;
  problem.applyInverseMass(momentum_, uFree_);
  uFree_ += uHalf_;
  problem.freeVelocity(uFree_);
  const auto solved = problem.solve(solver);  // −ξ ∈ N_C(Λ)
  h_ = 0.5 * (h_ + s.slot(0).h), hNonPotential_ = 0.5 * (hNonPotential_ + s.slot(0).hNonPotential);
  problem.velocityFromImpulses(x);  // u^E = u_free + M⁻¹ W Λ
  s.change(0).h = h_, s.change(0).hNonPotential = hNonPotential_;
  return solved;
}

void NonsmoothRattle::declare(Attributes& a) {
  a.about(
      "Nonsmooth RATTLE: laws for positions and for velocities at the end of the step, order 2 "
      "between impacts, no drift.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><NonsmoothRattle/></simulation>");
}

}  // namespace dynamy
