// G = Wᵀ(M⁻¹W) by its factors, and the contacts on each mass block.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <dynamy/solver/problem/factored_delassus.hpp>
#include <iostream>

#include "unit/solver/inclusion_fixture.hpp"
#include "unit/solver/laws.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kFactoredSeed = 5;
using fixture::kCoulomb;
using fixture::kUnilateral;

/// Blocks of 2, 3 and 1 velocities. Contact 0 acts on blocks 0 and 1, contact 1 on block 1; nothing
/// acts on block 2.
struct Chain {
  Chain() {
    std::cout << "seed " << kFactoredSeed << '\n';
    std::mt19937 random(kFactoredSeed);
    const std::vector<MatrixXd> masses{fixture::randomMass(random, 2),
                                       fixture::randomMass(random, 3),
                                       fixture::randomMass(random, 1)};
    scene = std::make_unique<fixture::Inclusion>(masses);
    MatrixXd M = MatrixXd::Zero(6, 6), Wt = MatrixXd::Zero(4, 6);
    M.topLeftCorner(2, 2) = masses[0], M.block(2, 2, 3, 3) = masses[1], M(5, 5) = masses[2](0, 0);
    Wt.topLeftCorner(3, 5) = fixture::randomMatrix(random, 3, 5);
    Wt.block(3, 2, 1, 3) = fixture::randomMatrix(random, 1, 3);
    scene->contact(kCoulomb, Wt.topRows(3)), scene->contact(kUnilateral, Wt.bottomRows(1));
    MinvW = M.inverse() * Wt.transpose(), G = Wt * MinvW;
    factors.factor(scene->contacts, scene->mass, diagonal);
  }
  std::unique_ptr<fixture::Inclusion> scene;
  MatrixXd MinvW, G;
  FactoredDelassus factors;
  DiagonalBlocks diagonal;
};

/// Sums of a few products, and inverses of condition up to 1e3.
constexpr double kTolerance = 1e-11;

TEST(ContactsOfBlocks, ListsSegmentsAndNeighbours) {
  const Chain x;
  ContactsOfBlocks links;
  links.link(x.scene->contacts, 3);
  ASSERT_EQ(links.blocks(), 3);
  EXPECT_EQ(links.segments(0).size(), 1u);
  ASSERT_EQ(links.segments(1).size(), 2u);
  EXPECT_EQ(links.contact(links.segments(1)[0]), 0);
  EXPECT_EQ(links.contact(links.segments(1)[1]), 1);
  EXPECT_TRUE(links.segments(2).empty());
  std::vector<int> near;
  links.neighbours(x.scene->contacts, 1, near);
  EXPECT_EQ(near, (std::vector<int>{0, 1}));
}

TEST(FactoredDelassus, FormsBlocksAndTheWholeMatrix) {
  const Chain x;
  const double tolerance = kTolerance * x.G.cwiseAbs().maxCoeff();
  EXPECT_EQ(x.factors.touchedVelocities(), 5);
  RowMatrix across(3, 1), whole = RowMatrix::Zero(4, 4);
  x.factors.block(0, 1, across.data());
  EXPECT_LE((across - x.G.block(0, 3, 3, 1)).norm(), tolerance);
  x.factors.addTo(whole.data());
  EXPECT_LE((whole - x.G).norm(), tolerance);
  EXPECT_LE((ConstBlock(x.diagonal.block(0), 3, 3) - x.G.topLeftCorner(3, 3)).norm(), tolerance);
  EXPECT_NEAR(x.diagonal.block(1)[0], x.G(3, 3), tolerance);
}

TEST(FactoredDelassus, HoldsTheVelocitiesOfASweep) {
  Chain x;
  const double tolerance = kTolerance * x.G.cwiseAbs().maxCoeff();
  VectorXd Lambda{{1.0, -0.5, 0.3, 2.0}}, y(4), u = VectorXd::Ones(6), row(1);
  x.factors.apply(Lambda.data(), y.data());
  EXPECT_LE((y - x.G * Lambda).norm(), tolerance);
  x.factors.addVelocity(Lambda.data(), view(u));
  EXPECT_LE((u - VectorXd::Ones(6) - x.MinvW * Lambda).norm(), tolerance);
  x.factors.begin(Lambda.data());
  const double delta = -0.7;
  x.factors.changed(1, &delta), Lambda[3] += delta;
  x.factors.row(1, row.data());
  EXPECT_NEAR(row[0], x.G.row(3).dot(Lambda), tolerance);
  EXPECT_LE((Eigen::Map<const VectorXd>(x.factors.velocities(), 6) - x.MinvW * Lambda).norm(),
            tolerance);
}

}  // namespace
}  // namespace dynamy
