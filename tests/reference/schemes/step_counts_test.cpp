// What a step of stacks and chains takes, in counts: they repeat on every machine, times do not.
// The figures are those of doc/performance.md.
#include <gtest/gtest.h>

#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

struct Counts {
  double newton = 0.0;       ///< Newton steps per step
  double evaluations = 0.0;  ///< of the mechanical system, per step
};

Counts counts(const std::string& model, double dt, int steps) {
  Scene scene(model);
  Counts out;
  for (int k = 0; k < steps; ++k) out.newton += scene.step(dt).solved.newton;
  EXPECT_TRUE(scene.solved()) << model;
  out.newton /= steps;
  out.evaluations = static_cast<double>(scene.system().evaluations()) / steps;
  return out;
}

TEST(StepCounts, AStackAtRestIsLeftAloneByTheSolver) {
  // A start within the tolerance is taken as it is: most steps need no Newton step at all.
  const Counts tower = counts("tower", 1e-3, 2000), ratio = counts("ratio_stack", 1e-3, 2000);
  EXPECT_LT(tower.newton, 0.1);
  EXPECT_LT(ratio.newton, 0.6);
  // One evaluation a step; the scheme looks for joints once.
  EXPECT_LE(tower.evaluations, 1.0 + 1.0 / 2000);
  EXPECT_LE(ratio.evaluations, 1.0 + 1.0 / 2000);
}

TEST(StepCounts, AStackUnderAChangingLoadTakesFewNewtonSteps) {
  // No contact changes its state: the inclusion is linear there, and solved with one factorisation
  // a step. One substitution does for equal masses, the ratio of 10 000 takes a second one; the
  // first load takes Newton's method some forty steps.
  EXPECT_LT(counts("tower_swung", 1e-3, 1000).newton, 1.3);
  EXPECT_LT(counts("ratio_stack_swung", 1e-3, 1000).newton, 2.1);
}

}  // namespace
}  // namespace dynamy::reference
