// Newton steps of a stack ask for no memory, whichever contacts open and close.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/solver/proximal_newton.hpp>
#include <dynamy/testing/allocation_counter.hpp>

#include "support/contact_problems.hpp"
#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

TEST(ProximalNewton, AsksForNoMemoryWhenContactsOfAStackOpen) {
  if (!AllocationCounter::active()) GTEST_SKIP() << "allocations are not counted in this program";
  constexpr int kBoxes = 6;
  const UnilateralCoulomb law(0.0, 0.0, 0.6);
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(6, 6);
  M.bottomRightCorner(3, 3) /= 6.0;
  fixture::Inclusion scene(std::vector<Eigen::MatrixXd>(kBoxes, M));
  const Eigen::MatrixXd Wt = Eigen::MatrixXd(boxStack(kBoxes, 1.0, 0.6, 0.0).H).transpose();
  for (int i = 0; i < 4 * kBoxes; ++i) scene.contact(law, Wt.middleRows(3 * i, 3));
  // Gravity swings so far that the boxes are at the point of tipping about one edge or the other.
  Eigen::VectorXd v = Eigen::VectorXd::Zero(6 * kBoxes), c(12 * kBoxes);
  const auto load = [&](double phase) {
    for (int b = 0; b < kBoxes; ++b) {
      v[6 * b] = 9.81e-3 * 0.4 * std::sin(phase);
      v[6 * b + 1] = 9.81e-3 * 0.3 * std::cos(1.7 * phase);
      v[6 * b + 2] = -9.81e-3;
    }
    c.noalias() = Wt * v;
  };
  load(0.0);
  InclusionProblem& p = scene.pose(c);
  ProximalNewton solver({.tolerance = 1e-9});
  Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(12 * kBoxes);
  int open = 0, changes = 0;
  const auto run = [&](int steps) {
    for (int k = 0; k < steps; ++k) {
      load(0.1 * k);
      std::copy(c.data(), c.data() + c.size(), p.c.begin());
      solver.solve(p, view(Lambda));
      int now = 0;
      for (int i = 0; i < p.size(); ++i) now += Lambda[3 * i] == 0.0;
      changes += now != open;
      open = now;
    }
  };
  run(130);  // one swing: everything has its size
  changes = 0;
  const AllocationCounter counter;
  run(130);
  EXPECT_EQ(counter.count(), 0);
  EXPECT_GT(changes, 10) << "the test wants contacts that open and close";
}

}  // namespace
}  // namespace dynamy
