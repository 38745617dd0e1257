#include <algorithm>
#include <cmath>
#include <dynamy/schemes/half_explicit_heun.hpp>

namespace dynamy {
namespace {

constexpr int kMostHeunIterations = 40;
constexpr double kHeunConverged = 1e-14;  ///< change of γ, relative to the velocities

/// With Heun's rule oscillations grow by (ωΔt)⁴/8 per step; up to this ωΔt by 2e-4.
constexpr double kHeun = 0.2;

}  // namespace

StepReport HalfExplicitHeun::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                  double dt) {
  begin_ = x;
  activeContacts(s, x, dt);
  if (explicitIsUnstable(s, 1, begin_, dt, kHeun)) return {dt, {}, 0, lacks(Asked::stiffForces)};
  const auto first = predict(s, solver, dt);  // U, Λ₁ and h(Q, U)

  // q^E = q^A + Δt/2 F (u^A + U)
  uMean_ = 0.5 * (begin_.u + stage_.u);
  s.move(x, uMean_, dt);
  s.evaluate(x, {.held = HeldContacts{keys_}});
  auto& problem = s.impactProblem(x, dt);  // γ^A = W^Eᵀ u^A
  // u_free = (u^A + U)/2 + M⁻¹ (Δt/2 h(Q, U) − WΛ₁/2)
  carry(first_, s.slot(0).contacts, carried_);
  momentum_.setZero(x.u.size());
  addForce(s.slot(0).contacts, carried_.data(), momentum_);
  momentum_ = 0.5 * dt * s.slot(2).h - 0.5 * momentum_;
  problem.applyInverseMass(momentum_, uFree_);
  uFree_ += uMean_;
  problem.freeVelocity(uFree_);
  auto solved = problem.solve(solver);
  h_ = 0.5 * (s.slot(1).h + s.slot(2).h);
  hNonPotential_ = 0.5 * (s.slot(1).hNonPotential + s.slot(2).hNonPotential);
  problem.velocityFromImpulses(x);
  s.change(0).h = h_, s.change(0).hNonPotential = hNonPotential_;
  solved.iterations += first.iterations;
  if (!first.ok()) solved.status = first.status;
  return {dt, solved, problem.size()};
}

void HalfExplicitHeun::activeContacts(MechanicalSystem& s, const State& x, double dt) {
  keys_.clear();
  addKeys(s.evaluate(x, {.slot = 1}).contacts, keys_);
  stage_ = x;
  s.move(stage_, dt);  // Q = q^A + Δt F u^A
  addKeys(s.evaluate(stage_, {.slot = 2}).contacts, keys_);
  addPressed(x.impulses, keys_);
}

SolveReport HalfExplicitHeun::predict(MechanicalSystem& s, InclusionSolver& solver, double dt) {
  s.evaluate(begin_, {.slot = 1, .held = HeldContacts{keys_}});  // M, h, W at q^A
  s.evaluate(stage_, {.slot = 2, .held = HeldContacts{keys_}});  // W at Q
  auto& problem = s.impactProblem(begin_, dt, 1);
  const auto n = static_cast<Eigen::Index>(problem.rows());
  free_ = problem.gammaFree;
  gammaA_.resize(free_.size()), gammaQ_.resize(free_.size());
  stage_.u = begin_.u;
  SolveReport solved;
  double before = 0.0;
  for (int i = 0;; ++i) {
    // W(Q)ᵀU = W^Aᵀ U + the part that the turning of W adds, taken at the last U.
    s.slot(2).contacts.gamma(view(std::as_const(stage_.u)), {gammaQ_.data(), n});
    s.slot(1).contacts.gamma(view(std::as_const(stage_.u)), {gammaA_.data(), n});
    double change = 0.0, size = 0.0;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const double next = free_[k] + gammaQ_[k] - gammaA_[k];
      if (i > 0) change = std::max(change, std::abs(next - problem.gammaFree[k]));
      size = std::max(size, std::abs(next));
      problem.gammaFree[k] = next;
    }
    const double speed = std::max(size, begin_.u.lpNorm<Eigen::Infinity>());
    if (i > 0 && (change <= kHeunConverged * speed || n == 0)) break;
    if (i > 4 && change > 0.5 * before && change <= 1e-9 * speed) break;
    before = change;
    if (i == kMostHeunIterations) {
      solved.status = SolveStatus::stalled;
      break;
    }
    const auto last = problem.solve(solver);
    addSolve(solved, last);
    solved.status = last.status;
    stage_.impulses = begin_.impulses;
    problem.velocityFromImpulses(stage_);  // U = u^A + M⁻¹(Δt h + WΛ₁)
  }
  first_ = stage_.impulses;
  s.evaluate(stage_, {.slot = 2, .held = HeldContacts{keys_}});  // h(Q, U)
  return solved;
}

void HalfExplicitHeun::declare(Attributes& a) {
  a.about(
      "Half-explicit Heun scheme: two evaluations and two inclusions on velocity level, order 2 "
      "between impacts, also on curved surfaces.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><HalfExplicitHeun/></simulation>");
}

}  // namespace dynamy
