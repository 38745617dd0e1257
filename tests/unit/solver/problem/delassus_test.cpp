// G = WᵀM⁻¹W: assembled against matrix-free against plain dense algebra.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <iostream>

#include "unit/solver/inclusion_fixture.hpp"
#include "unit/solver/laws.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kDelassusSeed = 7;
using fixture::kCoulomb;

/// Five blocks of 1 … 6 velocities; 14 contacts of 1 … 3 rows that share them by two and three. Or
/// five free bodies, one with a diagonal mass, and three rows a contact.
struct Random {
  explicit Random(bool freeBodies = false) : random(kDelassusSeed) {
    std::cout << "seed " << kDelassusSeed << '\n';
    std::vector<MatrixXd> masses;
    int nu = 0;
    for (int n : {1, 3, 6, 2, 6}) {
      if (freeBodies) n = 6;
      masses.push_back(fixture::randomMass(random, n)), nu += n;
    }
    if (freeBodies) masses[1] = VectorXd::LinSpaced(6, 1.0, 3.0).asDiagonal();
    M = MatrixXd::Zero(nu, nu);
    int at = 0;
    for (const MatrixXd& block : masses) {
      M.block(at, at, block.rows(), block.rows()) = block;
      at += static_cast<int>(block.rows());
    }
    problem = std::make_unique<fixture::Inclusion>(masses);
    for (int i = 0; i < 14; ++i) {
      MatrixXd Wt = fixture::randomMatrix(random, freeBodies ? 3 : 1 + i % 3, nu);
      for (int b = 0; b < problem->mass.blocks(); ++b)
        if ((i + b) % 5 > 1 + i % 2)
          Wt.middleCols(problem->mass.u0(b), problem->mass.nu(b)).setZero();
      W.conservativeResize(nu, W.cols() + Wt.rows());
      W.rightCols(Wt.rows()) = Wt.transpose();
      problem->contact(kCoulomb, Wt);
    }
    G = W.transpose() * M.inverse() * W;
  }
  std::mt19937 random;
  MatrixXd M, W{0, 0}, G;
  std::unique_ptr<fixture::Inclusion> problem;
};

/// Sums of up to 18 products and one inversion of condition up to 1e3: 18 · 1e3 ε.
double tolerance(const MatrixXd& G) { return 4e-12 * G.cwiseAbs().maxCoeff(); }

TEST(Delassus, IsTheSameAssembledMatrixFreeAndDense) {
  for (const bool freeBodies : {false, true}) {
    Random r(freeBodies);
    for (const auto form : {Delassus::Form::assembled, Delassus::Form::matrixFree}) {
      r.problem->pose(VectorXd::Ones(r.G.rows()), 1.0, form);
      EXPECT_EQ(r.problem->G.dense() != nullptr, form == Delassus::Form::assembled);
      EXPECT_LE((r.problem->dense() - r.G).cwiseAbs().maxCoeff(), tolerance(r.G));
    }
  }
}

TEST(ContactSet, GivesRelativeVelocitiesOfAllKindsOfBlocks) {
  for (const bool freeBodies : {false, true}) {
    Random r(freeBodies);
    const VectorXd u = fixture::randomMatrix(r.random, static_cast<int>(r.M.rows()), 1);
    VectorXd gamma(r.W.cols()), sum = VectorXd::Ones(r.W.cols());
    r.problem->contacts.chi[2] = 0.5;
    r.problem->contacts.gamma(view(u), view(gamma));
    r.problem->contacts.addAbsolute({u.data(), u.size()}, sum.data());
    VectorXd expected = r.W.transpose() * u;
    expected[2] += 0.5;
    // 30 products of numbers of order one: a few hundred roundings at most.
    EXPECT_LE((gamma - expected).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LE(
        (sum - VectorXd::Ones(r.W.cols()) - r.W.cwiseAbs().transpose() * u).cwiseAbs().maxCoeff(),
        1e-13);
  }
}

TEST(Delassus, GivesBlocksRowSumsAndNeighbours) {
  Random r;
  r.problem->pose(VectorXd::Ones(r.G.rows()));
  const ContactSet& c = r.problem->contacts;
  std::vector<int> near;
  VectorXd sums(r.G.rows());
  r.problem->G.rowSums(sums.data());
  EXPECT_LE((sums - r.G.cwiseAbs().rowwise().sum()).cwiseAbs().maxCoeff(), 31 * tolerance(r.G));
  for (int i = 0; i < c.size(); ++i) {
    r.problem->G.neighbours(i, near);
    for (int j = 0; j < c.size(); ++j) {
      const auto ri = c.row0[static_cast<std::size_t>(i)], rj = c.row0[static_cast<std::size_t>(j)];
      RowMatrix block(c.dim(i), c.dim(j));
      r.problem->G.block(i, j, block.data());
      const MatrixXd expected = r.G.block(ri, rj, c.dim(i), c.dim(j));
      EXPECT_LE((block - expected).cwiseAbs().maxCoeff(), tolerance(r.G));
      const bool coupled = std::find(near.begin(), near.end(), j) != near.end();
      EXPECT_EQ(coupled, !block.isZero(0.0)) << i << ' ' << j;
    }
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
  }
}

TEST(Delassus, FollowsChangesOfASweep) {
  Random r;
  for (const auto form : {Delassus::Form::assembled, Delassus::Form::matrixFree}) {
    r.problem->pose(VectorXd::Ones(r.G.rows()), 1.0, form);
    Delassus& G = r.problem->G;
    VectorXd Lambda = fixture::randomMatrix(r.random, G.rows(), 1);
    G.begin(Lambda.data());
    for (int i = 0; i < r.problem->contacts.size(); ++i) {
      const int first = r.problem->contacts.row0[static_cast<std::size_t>(i)],
                dim = r.problem->contacts.dim(i);
      const VectorXd delta = fixture::randomMatrix(r.random, dim, 1);
      Lambda.segment(first, dim) += delta;
      G.changed(i, delta.data());
      VectorXd row(dim);
      G.row(i, Lambda.data(), row.data());
      const VectorXd expected = (r.G * Lambda).segment(first, dim);
      EXPECT_LE((row - expected).norm(), 31 * Lambda.norm() * tolerance(r.G));
    }
  }
}

TEST(Delassus, BoundsItsOwnRounding) {
  Random r;
  const VectorXd x = fixture::randomMatrix(r.random, static_cast<int>(r.G.rows()), 1);
  const VectorXd least = r.G.cwiseAbs() * x.cwiseAbs();
  for (const auto form : {Delassus::Form::assembled, Delassus::Form::matrixFree}) {
    r.problem->pose(VectorXd::Ones(r.G.rows()), 1.0, form);
    VectorXd y(x.size());
    r.problem->G.applyAbsolute(x.data(), y.data());
    EXPECT_TRUE((y.array() >= least.array() * (1.0 - 1e-9)).all());  // rounding of `least` itself
  }
}

TEST(Delassus, AddsTheVelocityOfPercussions) {
  Random r;
  r.problem->pose(VectorXd::Ones(r.G.rows()));
  const VectorXd Lambda = fixture::randomMatrix(r.random, static_cast<int>(r.G.rows()), 1);
  VectorXd u = VectorXd::Ones(r.M.rows());
  r.problem->G.addVelocity(Lambda.data(), view(u));
  const VectorXd expected = VectorXd::Ones(r.M.rows()) + r.M.inverse() * (r.W * Lambda);
  EXPECT_LE((u - expected).norm(), 1e-12 * 31 * expected.norm());  // as above, norm of a sum of 31
}

}  // namespace
}  // namespace dynamy
