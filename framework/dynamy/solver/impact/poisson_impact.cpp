#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/impact/poisson_impact.hpp>

namespace dynamy {
namespace {

/// Trials for κ. The energy returned is nearly a parabola of κ, so that a secant method finds it to
/// kShare of the energy in four to six trials.
constexpr int kPoissonTrials = 24;
constexpr double kShare = 1e-12;

double epsilonN(const InclusionProblem& p, int i) {
  double epsilon[kMostRows] = {};
  if (!p.law(i).unilateral()) return 0.0;
  p.law(i).epsilon(p.dim(i), epsilon);
  return epsilon[0];
}

}  // namespace

// ---- FloorLaw ----------------------------------------------------------------------------------

void FloorLaw::prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const {
  // Evaluate the law itself at Λ_N = max(floor, Λ_N − r_N ξ_N) and ξ_N = 0: its other rows see this
  // Λ_N.
  double without[kMostRows];
  std::copy_n(xi, in.dim, without);
  Lambda[0] = std::max(floor_, Lambda[0] - r[0] * xi[0]);
  without[0] = 0.0;
  const double N = Lambda[0];
  law_->prox(in, r, without, Lambda);
  Lambda[0] = N;
}

bool FloorLaw::proxDerivative(const LawInput& in, double rho, const double* xi,
                              const double* Lambda, double* A, double* B) const {
  double at[kMostRows], without[kMostRows];
  std::copy_n(Lambda, in.dim, at), std::copy_n(xi, in.dim, without);
  const double z = Lambda[0] - rho * xi[0];
  at[0] = std::max(floor_, z), without[0] = 0.0;
  if (!law_->proxDerivative(in, rho, without, at, A, B)) return false;
  const bool free = z > floor_;
  for (int k = 0; k < in.dim; ++k) A[k] = B[k] = 0.0;
  A[0] = free ? 0.0 : 1.0, B[0] = free ? rho : 0.0;
  for (int r = 1; r < in.dim && !free; ++r) A[r * in.dim] = B[r * in.dim] = 0.0;
  return true;
}

// ---- TwoPhaseImpact ----------------------------------------------------------------------------

bool TwoPhaseImpact::compress(InclusionProblem& problem, InclusionSolver& solver, Vec Lambda,
                              SolveReport& report) const {
  problem.c = problem.gammaFree;
  report = solver.solve(problem, Lambda);
  if (!rebounds(problem)) return false;
  impact_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  if (problem.gammaFree == problem.gammaA) return true;
  // Compression of the velocities alone, without the forces of the step.
  const double dt = problem.dt;
  problem.c = problem.gammaA, problem.dt = 0.0;
  addSolve(report, solver.solve(problem, {impact_.data(), Lambda.size()}));
  problem.c = problem.gammaFree, problem.dt = dt;
  return true;
}

SolveReport TwoPhaseImpact::expand(const InclusionProblem& problem, InclusionSolver& solver,
                                   ConstVec compression, const std::vector<double>& kappa) const {
  const auto n = static_cast<std::size_t>(problem.rows());
  contacts_ = *problem.contacts;
  while (laws_.size() < static_cast<std::size_t>(problem.size()))
    laws_.push_back(std::make_unique<FloorLaw>());
  expansion_.assign(n, 0.0);
  for (int i = 0; i < problem.size(); ++i) {
    if (!problem.law(i).unilateral()) continue;
    const int first = problem.row0(i);
    const double share = kappa[static_cast<std::size_t>(i)];
    const double floor = std::max(0.0, share * impact_[static_cast<std::size_t>(first)]);
    FloorLaw& law = *laws_[static_cast<std::size_t>(i)];
    law.set(problem.law(i), floor);
    contacts_.law[static_cast<std::size_t>(i)] = &law;
    expansion_[static_cast<std::size_t>(first)] = floor;
  }
  InclusionProblem& p = expansionProblem_;
  p = problem;
  p.contacts = &contacts_, p.dt = 0.0;  // forces of given size act in the compression
  problem.G->apply(compression.data(), p.c.data());
  for (std::size_t k = 0; k < n; ++k) p.c[k] += problem.gammaFree[k];  // γ^C
  return solver.solve(p, {expansion_.data(), static_cast<Eigen::Index>(n)});
}

// ---- PoissonImpact -----------------------------------------------------------------------------

SolveReport PoissonImpact::percussions(InclusionProblem& problem, InclusionSolver& solver,
                                       const std::vector<double>& factor, Vec Lambda) const {
  SolveReport report;
  if (!compress(problem, solver, Lambda, report)) return report;
  kappa_.resize(factor.size());
  for (int i = 0; i < problem.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    kappa_[at] = factor[at] * epsilonN(problem, i);
  }
  addSolve(report, expand(problem, solver, {Lambda.data(), Lambda.size()}, kappa_));
  Lambda += expansion();
  return report;
}

void PoissonImpact::declare(Attributes& a) {
  a.about(
      "Poisson's impact law: a compression with epsilon = 0, then an expansion in which each "
      "normal "
      "percussion is at least epsilon_N times that of the compression.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><PoissonImpact/></simulation>");
}

// ---- EnergeticImpact ---------------------------------------------------------------------------

void EnergeticImpact::aims(const InclusionProblem& problem, const std::vector<double>& factor,
                           ConstVec /*compression*/) const {
  // Work of the normal percussions in the compression of γ^A, by the mean velocity.
  aim_.assign(static_cast<std::size_t>(groups_.size()), 0.0);
  gammaE_.resize(static_cast<std::size_t>(problem.rows()));
  problem.G->apply(impact().data(), gammaE_.data());
  for (int i = 0; i < problem.size(); ++i) {
    if (!problem.law(i).unilateral()) continue;
    const auto k = static_cast<std::size_t>(problem.row0(i));
    const double e = factor[static_cast<std::size_t>(i)] * epsilonN(problem, i);
    const double taken = -impact()[problem.row0(i)] * (problem.gammaA[k] + 0.5 * gammaE_[k]);
    aim_[static_cast<std::size_t>(groups_.of(i))] += e * e * std::max(0.0, taken);
  }
}

bool EnergeticImpact::search(InclusionProblem& problem) const {
  // Excess of the work returned by the expansion with κ over the required work.
  excess_ = aim_;
  for (double& e : excess_) e = -e;
  gammaE_.resize(static_cast<std::size_t>(problem.rows()));
  problem.G->apply(expansion().data(), gammaE_.data());
  for (int i = 0; i < problem.size(); ++i) {
    if (!problem.law(i).unilateral()) continue;
    const auto k = static_cast<std::size_t>(problem.row0(i));
    excess_[static_cast<std::size_t>(groups_.of(i))] +=
        expansion()[problem.row0(i)] * (gammaC()[k] + 0.5 * gammaE_[k]);
  }
  bool more = false;
  for (std::size_t g = 0; g < search_.size(); ++g) {
    Search& s = search_[g];
    if (s.done) continue;
    const double excess = excess_[g];
    if (std::abs(excess) <= kShare * aim_[g]) {
      s.done = true;
      continue;
    }
    if (excess < 0.0)
      s.low = s.kappa, s.excessLow = excess;
    else
      s.high = s.kappa, s.excessHigh = excess, s.bracketed = true;
    if (!s.bracketed) {
      s.kappa = s.kappa > 0.0 ? 2.0 * s.kappa : 1.0;
    } else {
      // The work grows like κ²: a secant step in κ².
      const double l2 = s.low * s.low, h2 = s.high * s.high;
      const double t = std::clamp(-s.excessLow / (s.excessHigh - s.excessLow), 0.01, 0.99);
      s.kappa = std::sqrt(l2 + t * (h2 - l2));
    }
    more = more || (s.high - s.low > 1e-15 * s.high || !s.bracketed);
  }
  return more;
}

SolveReport EnergeticImpact::percussions(InclusionProblem& problem, InclusionSolver& solver,
                                         const std::vector<double>& factor, Vec Lambda) const {
  SolveReport report;
  if (!compress(problem, solver, Lambda, report)) return report;
  groups_.find(problem);
  const ConstVec compression(Lambda.data(), Lambda.size());
  aims(problem, factor, compression);
  search_.assign(static_cast<std::size_t>(groups_.size()), {});
  for (std::size_t g = 0; g < search_.size(); ++g)
    if (aim_[g] > 0.0) search_[g] = {.excessLow = -aim_[g], .kappa = 1.0, .done = false};
  kappa_.resize(factor.size());
  for (int trial = 0; trial < kPoissonTrials; ++trial) {
    for (int i = 0; i < problem.size(); ++i)
      kappa_[static_cast<std::size_t>(i)] = search_[static_cast<std::size_t>(groups_.of(i))].kappa;
    addSolve(report, expand(problem, solver, compression, kappa_));
    if (!search(problem)) break;
  }
  Lambda += expansion();
  return report;
}

void EnergeticImpact::declare(Attributes& a) {
  a.about(
      "Energetic impact law: compression and expansion as Poisson's, the expansion such that "
      "normal "
      "percussions return epsilon_N squared of the work they took up in the compression. Contacts "
      "that share bodies expand by one common factor.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><EnergeticImpact/></simulation>");
}

}  // namespace dynamy
