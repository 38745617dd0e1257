/// What a step costs, counted: evaluations of M, h, W and solved inclusions per step. The table of
/// doc/theory/31_more_schemes.md has these numbers.
#include <gtest/gtest.h>

#include <dynamy/solver/prox_solvers.hpp>
#include <reference/schemes/scheme_table.hpp>

namespace dynamy::reference {
namespace {

/// Gauss–Seidel that counts the problems with rows.
class CountingSolver final : public InclusionSolver {
 public:
  explicit CountingSolver(long& solves) : solves_(solves) {}
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override {
    if (problem.rows() > 0) ++solves_;
    return solver_.solve(problem, Lambda);
  }

 private:
  ProxGaussSeidel solver_;
  long& solves_;
};

struct Cost {
  double evaluations = 0.0, solves = 0.0;
};
std::ostream& operator<<(std::ostream& out, const Cost& c) {
  return out << c.evaluations << " evaluations, " << c.solves << " solves";
}

/// Means per step, dt = 1 ms.
Cost costOf(const std::string& scheme, const std::string& sections, double t) {
  long solves = 0, steps = 0;
  Scene scene("scene", {.solver = std::make_unique<CountingSolver>(solves),
                        .text = modelWith(scheme, sections)});
  const long before = scene.system().evaluations();
  bool refused = false;
  scene.run(t, 1e-3, [&] {
    ++steps;
    refused = refused || !scene.report().refused.empty();
  });
  if (refused) return {};
  const auto n = static_cast<double>(steps);
  return {static_cast<double>(scene.system().evaluations() - before) / n,
          static_cast<double>(solves) / n};
}

/// Means per step, rounded up; 0: refused, or solved without an inclusion.
struct Bounds {
  const char* name;
  Cost sliding, pendulum;
};
constexpr Bounds kBounds[] = {
    {"MoreauMidpoint", {1, 1}, {1, 1}},
    {"HalfExplicitEuler", {1, 1}, {1, 1}},
    {"StewartTrinkle", {1, 1}, {1, 1}},
    {"AnitescuPotra", {1, 1}, {1, 1}},
    {"PaoliSchatzman", {5, 3}, {5, 3}},
    {"ThetaMethod", {4.1, 2.1}, {4, 2}},
    {"ThetaMethodOne", {4.1, 2.1}, {4, 2}},
    {"NonsmoothRattle", {6, 4}, {6, 4}},
    {"GeneralizedAlpha", {6.1, 4}, {4.1, 2}},
    {"HalfExplicitHeun", {6, 5}, {6, 4}},
    {"Ggl", {5, 4}, {5, 4}},
    {"AugmentedMoreau", {3, 3}, {3, 3}},
    {"AugmentedMoreauOne", {1, 1}, {1, 1}},
    {"StaggeredMoreau", {5.1, 2}, {5.1, 3}},
    {"EnergyMomentum", {5.1, 2}, {11.1, 0}},
    {"Index1", {0, 0}, {1, 1}},
    {"Index2", {0, 0}, {1, 1}},
    {"Index3", {0, 0}, {4, 3}},
};

class SchemeCost : public testing::TestWithParam<SchemeOrders> {};

TEST_P(SchemeCost, IsAsStated) {
  const Cost sliding = costOf(GetParam().xml, Bowl::sections(0.2), 0.4),
             pendulum = costOf(GetParam().xml, kRodPendulum, 1.0);
  for (const Bounds& b : kBounds)
    if (std::string(b.name) == GetParam().name) {
      EXPECT_LE(sliding.evaluations, b.sliding.evaluations) << sliding;
      EXPECT_LE(sliding.solves, b.sliding.solves) << sliding;
      EXPECT_LE(pendulum.evaluations, b.pendulum.evaluations) << pendulum;
      EXPECT_LE(pendulum.solves, b.pendulum.solves) << pendulum;
      return;
    }
  ADD_FAILURE() << "no bound for " << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(AllSchemes, SchemeCost, testing::ValuesIn(kAllSchemes),
                         [](const auto& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace dynamy::reference
