/// Landing stacks: boxes of a stack displaced and tilted at random and dropped, then stepped, with
/// everything counted that the solver did.
#pragma once
#include <algorithm>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/stages/projection.hpp>
#include <random>
#include <reference/scene.hpp>
#include <vector>

namespace dynamy::reference {

/// Hands every problem to another solver and counts.
class CountingSolver final : public InclusionSolver {
 public:
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override {
    const SolveReport report = solver_.solve(problem, Lambda);
    newton += report.newton, sweeps += report.iterations - report.newton;
    if (!report.ok()) ++unsolved, worst = std::max(worst, report.residuals.largest());
    return report;
  }
  long newton = 0, sweeps = 0, unsolved = 0;
  double worst = 0.0;  ///< largest residual of an unsolved problem

 private:
  Automatic solver_;
};

struct Landing {
  long unsolvedSteps = 0;  ///< with a problem, of impact or projection, that was not solved
  long silent = 0;         ///< of them, those whose report says that all is well
  double worst = 0.0, overlap = 0.0;  ///< largest residual unsolved [-]; largest overlap [m]
  double lowest = 0.0;                ///< of the body on top at the end [m]
  std::vector<long> newton;           ///< of every step, ascending
  std::vector<double> cost;           ///< of every step, ascending, in evaluations of the system
};

/// What a Newton step and a sweep cost beside one evaluation of system and contacts: estimates.
constexpr double kNewtonCost = 4.0, kSweepCost = 0.5;

/// `file` of models/; each box moved and turned by k (m, rad) times numbers of [−1, 1], and each
/// 3 to 4 k above the one below, so that none overlap; `seed` as it is printed.
inline Landing land(const std::string& file, double k, double dt, double until, unsigned seed) {
  auto solver = std::make_unique<CountingSolver>();
  CountingSolver& count = *solver;
  Scene scene(file, {.solver = std::move(solver)});
  std::mt19937_64 random(seed);
  const auto fraction = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  State& x = scene.state();
  Eigen::VectorXd way(x.u.size());
  double drop = 0.0;
  for (Eigen::Index body = 0; body < way.size(); body += 6) {
    for (Eigen::Index j = 0; j < 6; ++j) way[body + j] = k * (2.0 * fraction() - 1.0);
    way[body + 2] = drop += k * (3.0 + fraction());
  }
  scene.system().move(x, way, 1.0);
  x.t = 0.0;
  Landing out;
  scene.run(until, dt, [&, newton = 0L, sweeps = 0L, unsolved = 0L, evaluations = 0L]() mutable {
    const long all = scene.system().evaluations() - evaluations;
    out.newton.push_back(count.newton - newton);
    out.cost.push_back(static_cast<double>(all) +
                       kNewtonCost * static_cast<double>(count.newton - newton) +
                       kSweepCost * static_cast<double>(count.sweeps - sweeps));
    const bool failed = count.unsolved > unsolved;
    out.unsolvedSteps += failed, out.silent += failed && scene.report().solved.ok();
    newton = count.newton, sweeps = count.sweeps, unsolved = count.unsolved;
    out.overlap =
        std::max(out.overlap, largestOverlap(scene.system().evaluate(x, {.slot = 1}).contacts, x));
    evaluations = scene.system().evaluations();
  });
  out.worst = count.worst;
  out.lowest = x.q[x.q.size() - 5];
  std::sort(out.newton.begin(), out.newton.end());
  std::sort(out.cost.begin(), out.cost.end());
  return out;
}

}  // namespace dynamy::reference
