/// No scheme hides an inclusion that was not solved, whichever of a step's inclusions it is: a
/// solver that gives up from its k-th call on makes the report of that step say so, for every k.
#include <gtest/gtest.h>

#include <dynamy/solver/proximal_newton.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

/// Solves as ProximalNewton does until call `last` of a step; then it leaves Λ = 0 and says so.
class GivesUp final : public InclusionSolver {
 public:
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override {
    if (calls++ < last) return solver_.solve(problem, Lambda);
    Lambda.setZero();
    SolveReport report;
    report.status = SolveStatus::stalled;
    report.residuals = residuals(problem, {Lambda.data(), Lambda.size()}, scratch_);
    return report;
  }
  int calls = 0, last = 1 << 30;

 private:
  ProximalNewton solver_;
  std::vector<double> scratch_;
};

/// A ball that hits the floor while a pendulum swings: joint, impact, and, with `project`, a
/// projection after the step.
std::string ballAndPendulum(const std::string& scheme, const std::string& project) {
  return R"(<dynamy version="1"><systems>
<PointMass name="bob" plane="xz" position="-1 0 2" mass="1" velocity="0 0 -1"/>
<RigidBody name="ball" position="3 0 0.1001" velocity="0.5 0 -1"><Sphere radius="0.1" mass="1" material="rubber"/></RigidBody>
<Ground name="world"><HalfSpace material="floor"/></Ground></systems><forces><Gravity/></forces>
<elements><Distance name="rod" between="world bob"/><Contact between="rubber floor"><UnilateralCoulomb mu="0.3"/></Contact>
</elements><simulation until="1" step="1e-3")" +
         project + "><" + scheme + "/></simulation></dynamy>";
}

struct Case {
  const char* scheme;
  const char* project;
};

class EveryScheme : public testing::TestWithParam<Case> {};

TEST_P(EveryScheme, ReportsEachInclusionThatWasNotSolved) {
  const auto [scheme, project] = GetParam();
  for (int k = 0; k < 40; ++k) {
    auto owned = std::make_unique<GivesUp>();
    GivesUp& solver = *owned;
    Scene scene("unsolved", {.solver = std::move(owned), .text = ballAndPendulum(scheme, project)});
    scene.step(1e-3);
    ASSERT_TRUE(scene.report().solved.ok()) << scheme << ": not with a solver that works either";
    solver.calls = 0, solver.last = k;
    const StepReport& report = scene.step(1e-3);
    if (solver.calls <= k) return;  // the step takes k inclusions, and all were looked at
    EXPECT_FALSE(report.solved.ok() && report.refused.empty())
        << scheme << project << ": inclusion " << k + 1 << " of the step was not solved";
  }
}

std::string caseName(const testing::TestParamInfo<Case>& tested) {
  std::string name = std::string(tested.param.scheme) + tested.param.project;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme,
                         testing::Values(Case{"MoreauMidpoint", ""}, Case{"HalfExplicitEuler", ""},
                                         Case{"StewartTrinkle", ""}, Case{"AnitescuPotra", ""},
                                         Case{"PaoliSchatzman", ""}, Case{"ThetaMethod", ""},
                                         Case{"NonsmoothRattle", ""}, Case{"GeneralizedAlpha", ""},
                                         Case{"HalfExplicitHeun", ""}, Case{"Ggl", ""},
                                         Case{"AugmentedMoreau", ""}, Case{"StaggeredMoreau", ""},
                                         Case{"EnergyMomentum", ""},
                                         Case{"EnergyMomentum project=\"velocities\"", ""},
                                         Case{"MoreauMidpoint", " project=\"both\""}),
                         caseName);

}  // namespace
}  // namespace dynamy::reference
