// Stacks of boxes, four contacts each: tall, with large mass ratios, resting and sliding. Truth:
// the residuals of Λ, recomputed, and for resting stacks the weight that every face carries.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <dynamy/solver/automatic.hpp>
#include <support/contact_problems.hpp>

namespace dynamy {
namespace {

enum class Masses { equal, upward, downward, heavyTop, heavyBottom };

struct Stack {
  int boxes;
  double ratio;
  Masses masses;
  double mu, pull;
  double mass(int box) const {
    const double height = boxes > 1 ? static_cast<double>(box) / (boxes - 1) : 0.0;
    switch (masses) {
      case Masses::equal:
        return 1.0;
      case Masses::upward:
        return std::pow(ratio, height);
      case Masses::downward:
        return std::pow(ratio, 1.0 - height);
      case Masses::heavyTop:
        return box + 1 == boxes ? ratio : 1.0;
      case Masses::heavyBottom:
        return box == 0 ? ratio : 1.0;
    }
    return 1.0;
  }
  std::unique_ptr<GivenProblem> problem(double moreLoad = 0.0) const {
    FclibProblem p = boxStack(boxes, 1.0, mu, pull + moreLoad);
    Eigen::MatrixXd M = p.M;
    for (int b = 0; b < boxes; ++b)
      for (int k = 6 * b; k < 6 * b + 6; ++k) M(k, k) *= mass(b), p.f[k] *= mass(b);
    p.M = M.sparseView();
    return inclusionProblem(condensed(p));
  }
  std::string text() const {
    static constexpr const char* kNames[] = {"equal", "upward", "downward", "heavy top",
                                             "heavy bottom"};
    char out[96];
    std::snprintf(out, sizeof out, "%d boxes, %s %g, mu %g, pull %g", boxes,
                  kNames[static_cast<int>(masses)], ratio, mu, pull);
    return out;
  }
};

std::vector<Stack> stacks(double largestRatio) {
  std::vector<Stack> out;
  for (const int n : {2, 10, 30})
    for (const auto& [mu, pull] : {std::pair{0.5, 0.1}, std::pair{0.3, 0.4}}) {
      out.push_back({n, 1.0, Masses::equal, mu, pull});
      for (double ratio = 1e2; ratio <= largestRatio; ratio *= 1e2)
        for (const Masses m :
             {Masses::upward, Masses::downward, Masses::heavyTop, Masses::heavyBottom})
          out.push_back({n, ratio, m, mu, pull});
    }
  return out;
}

/// E_f and E_u of Λ, apart from what the solver says.
double residual(const InclusionProblem& p, const Eigen::VectorXd& Lambda) {
  std::vector<double> scratch;
  return residuals(p, {Lambda.data(), Lambda.size()}, scratch).largest();
}

TEST(Stacks, AreSolvedInFewNewtonStepsColdAndFewerWarm) {
  // Counts of this code, not laws of nature: all but a few stacks stay within 25 cold steps, or
  // none of them if the solver gets better; 3 warm ones likewise.
  int longCold = 0, longWarm = 0;
  for (const Stack& s : stacks(1e4)) {
    const auto now = s.problem(), next = s.problem(3e-4);  // 0.05 g swung at 1 Hz, 1 ms later
    Automatic solver({.tolerance = 1e-8});
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(now->problem().rows());
    const SolveReport cold = solver.solve(now->problem(), view(Lambda));
    EXPECT_TRUE(cold.ok()) << s.text();
    EXPECT_LE(residual(now->problem(), Lambda), 1e-8) << s.text();
    EXPECT_LE(cold.newton, 36) << s.text();
    longCold += cold.newton > 25;
    const SolveReport warm = solver.solve(next->problem(), view(Lambda));
    EXPECT_TRUE(warm.ok()) << s.text();
    EXPECT_LE(residual(next->problem(), Lambda), 1e-8) << s.text();
    EXPECT_LE(warm.newton, 6) << s.text();
    longWarm += warm.newton > 3;
  }
  EXPECT_LE(longCold, 2);
  EXPECT_LE(longWarm, 4);
}

TEST(Stacks, RestingFacesCarryTheWeightAbove) {
  for (const Masses m : {Masses::upward, Masses::downward}) {
    const Stack s{10, 1e4, m, 0.5, 0.01};  // tips above 0.05
    const auto p = s.problem();
    Automatic solver({.tolerance = 1e-10});
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(p->problem().rows());
    ASSERT_TRUE(solver.solve(p->problem(), view(Lambda)).ok());
    double above = 0.0;
    for (int b = s.boxes - 1; b >= 0; --b) {
      above += s.mass(b);
      Eigen::Vector3d force = Eigen::Vector3d::Zero();
      for (int k = 0; k < 4; ++k) force += Lambda.segment<3>(12 * b + 3 * k);
      // Velocities are off by 1e-10 of u_ref, 1e-3 g, for every box above.
      EXPECT_NEAR(force[0], 9.81e-3 * above, 1e-8 * above) << b;
      EXPECT_NEAR(force[1], -9.81e-5 * above, 1e-8 * above) << b;
      EXPECT_NEAR(force[2], 0.0, 1e-8 * above) << b;
    }
  }
}

TEST(Stacks, ReachTwelveDigitsWhereRoundingAllowsIt) {
  for (const Stack& s : stacks(1e2)) {
    const auto p = s.problem();
    Automatic solver({.tolerance = 1e-12});
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(p->problem().rows());
    EXPECT_TRUE(solver.solve(p->problem(), view(Lambda)).ok()) << s.text();
    EXPECT_LE(residual(p->problem(), Lambda), 1e-12) << s.text();
  }
}

TEST(LongStacks, PrintTheTableOfTheDocument) {
  std::printf("| boxes | masses | ratio | | sweeps | Newton | E_u | warm | Gauss-Seidel |\n");
  for (const Stack& s : stacks(1e6)) {
    const auto now = s.problem(), next = s.problem(3e-4);
    Automatic solver({.tolerance = 1e-8});
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(now->problem().rows()), swept = Lambda;
    const SolveReport cold = solver.solve(now->problem(), view(Lambda));
    const SolveReport warm = solver.solve(next->problem(), view(Lambda));
    ProxGaussSeidel sweeps({1e-8, 20000, Relaxation::exact, 1.0});
    const SolveReport gs = sweeps.solve(now->problem(), view(swept));
    std::printf("| %s | %d | %d | %.0e%s | %d%s | %d%s, %.0e |\n", s.text().c_str(),
                cold.iterations - cold.newton, cold.newton, cold.residuals.Eu,
                cold.ok() ? "" : " FAILED", warm.newton, warm.ok() ? "" : " FAILED", gs.iterations,
                gs.ok() ? "" : " FAILED", gs.residuals.Eu);
  }
}

}  // namespace
}  // namespace dynamy
