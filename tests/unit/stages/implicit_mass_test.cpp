// M̂ = M − b Δt D − a Δt² K and Ĝ = WᵀM̂⁻¹W against plain algebra, and the forces of a step.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <dynamy/stages/implicit_mass.hpp>

#include <tuple>
#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDt = 0.1, kTolerance = 1e-13;  // a dozen roundings
const Unilateral kUnilateral;

/// Masses 1, 2 and 3 kg on a line. A declared spring of 40 N/m and a damper of 5 N s/m join masses 0
/// and 2; a spring of 30 N/m that steps do not resolve holds mass 0.
struct Line {
  Line() {
    stiffness.entries = {{0, 0, -40.0, -5.0},
                         {0, 2, 40.0, 5.0},
                         {2, 0, 40.0, 5.0},
                         {2, 2, -40.0, -5.0},
                         {0, 0, -30.0, 0.0}};
    stiffness.declared = 4, stiffness.kept = 5;
    stiffness.ofDeclared = kImplicitMidpoint;
    MatrixXd K = MatrixXd::Zero(3, 3), D = K;
    K(0, 0) = K(2, 2) = -40.0, K(0, 2) = K(2, 0) = 40.0;
    D(0, 0) = D(2, 2) = -5.0, D(0, 2) = D(2, 0) = 5.0;
    Mhat.diagonal() << 1.0, 2.0, 3.0;
    Mhat -= 0.5 * kDt * D + 0.25 * kDt * kDt * K;
    Mhat(0, 0) += kDt * kDt * 30.0;
    mass.resize(3);
    mass.factor(scene.mass, kDt, stiffness);
  }
  fixture::Inclusion scene{{MatrixXd{{1.0}}, MatrixXd{{2.0}}, MatrixXd{{3.0}}}};
  WeightedStiffness stiffness;
  MatrixXd Mhat = MatrixXd::Zero(3, 3);
  ImplicitMass mass;
};

TEST(ImplicitMass, InvertsWhatStiffElementsCoupleAndKeepsTheRest) {
  Line x;
  const VectorXd in{{1.0, 2.0, 3.0}};
  VectorXd out(3);
  x.mass.applyInverse(x.scene.mass, in, out);
  EXPECT_LE((x.Mhat * out - in).norm(), kTolerance);
}

TEST(ImplicitMass, FormsTheDelassusOperatorAndVelocitiesOfPercussions) {
  Line x;
  const MatrixXd Wt{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, -1.0, 1.0}};
  for (int i = 0; i < 3; ++i) x.scene.contact(kUnilateral, Wt.row(i));
  x.mass.delassus(x.scene.contacts, x.scene.mass, x.scene.G);
  EXPECT_LE((x.scene.dense() - Wt * x.Mhat.inverse() * Wt.transpose()).norm(), kTolerance);
  const VectorXd Lambda{{0.5, 1.0, -2.0}};
  VectorXd u = VectorXd::Ones(3);
  x.mass.addVelocity(x.scene.contacts, x.scene.mass, Lambda.data(), u);
  EXPECT_LE((x.Mhat * (u - VectorXd::Ones(3)) - Wt.transpose() * Lambda).norm(), kTolerance);
}

TEST(ImplicitMass, CountsItsWork) {
  // Twenty masses in a chain of springs: one group of 20, 20³/4000 for its factors. Two contacts: 2 · 20²/300,
  // rounded up.
  constexpr int n = 20;
  fixture::Inclusion scene(std::vector<MatrixXd>(n, MatrixXd{{1.0}}));
  WeightedStiffness chain;
  for (int i = 0; i + 1 < n; ++i)
    for (const auto& [a, b, K] : {std::tuple{i, i, -1.0}, std::tuple{i, i + 1, 1.0},
                                  std::tuple{i + 1, i, 1.0}, std::tuple{i + 1, i + 1, -1.0}})
      chain.entries.push_back({a, b, K, 0.0});
  chain.kept = chain.entries.size();
  ImplicitMass mass;
  mass.resize(n);
  mass.factor(scene.mass, kDt, chain);
  EXPECT_EQ(mass.work(), 2.0);
  for (const int i : {0, n - 1}) {
    MatrixXd row = MatrixXd::Zero(1, n);
    row(0, i) = 1.0;
    scene.contact(kUnilateral, row);
  }
  mass.delassus(scene.contacts, scene.mass, scene.G);
  EXPECT_EQ(mass.work(), 2.0 + 3.0);
}

TEST(WeightedStiffness, GivesTheForceThatAStepUsed) {
  // h of the start at u^A, and with the change of u: M̂ (u^E − u^A) = Δt (h + Δt s K u^A).
  const Line x;
  const VectorXd uA{{1.0, 0.0, 0.0}}, h0{{2.0, 0.0, 1.0}};
  VectorXd start = kDt * h0, h = h0, hNonPotential = VectorXd::Zero(3);
  x.stiffness.addStart(kDt, uA, start);
  EXPECT_NEAR(start[0], kDt * 2.0 - kDt * kDt * 30.0, kTolerance);  // s = 0 for the declared spring
  const VectorXd uE = uA + x.Mhat.partialPivLu().solve(start);
  x.stiffness.addUsedForce(kDt, uA, uE, h, hNonPotential);
  const VectorXd M{{1.0, 2.0, 3.0}};
  EXPECT_LE((M.cwiseProduct(uE - uA) - kDt * h).norm(), kTolerance);
  EXPECT_NEAR(hNonPotential.sum(), 0.0, kTolerance);  // the damper acts between two masses
  EXPECT_NE(hNonPotential[0], 0.0);
}

}  // namespace
}  // namespace dynamy
