// The equations of a Newton step in percussions and in velocities against a dense LU of
// (A + B (G + diag(a))) ΔΛ = −F.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/solver/newton/newton_system.hpp>
#include <dynamy/solver/proximal_newton.hpp>

#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Bodies in a row with contacts of all kinds, and the blocks of a Newton step at a random point.
class Step {
 public:
  Step(int nu, int bodies, unsigned seed) : random_(seed) {
    std::vector<MatrixXd> masses;
    for (int b = 0; b < bodies; ++b) masses.push_back(fixture::randomMass(random_, nu));
    scene = std::make_unique<fixture::Inclusion>(masses);
    const SetValuedForceLaw* laws[] = {&coulomb_, &unilateral_, &rolling_, &coulomb_, &bilateral_};
    const int dims[] = {3, 1, 5, 2, 3};
    for (int i = 0; i < 4 * bodies; ++i) {
      MatrixXd Wt = MatrixXd::Zero(dims[i % 5], nu * bodies);
      Wt.middleCols(nu * (i / 4), nu) = fixture::randomMatrix(random_, dims[i % 5], nu);
      if (i % 3 == 0 && i >= 4)
        Wt.middleCols(nu * (i / 4 - 1), nu) = fixture::randomMatrix(random_, dims[i % 5], nu);
      scene->contact(*laws[i % 5], Wt);
    }
    rows = scene->contacts.rows();
    scene->pose(fixture::randomMatrix(random_, rows, 1), 1.0, Delassus::Form::matrixFree);
    evaluate();
  }
  /// (A + B (G + diag(a))) ΔΛ + F relative to |F|.
  double residual(const VectorXd& dLambda) const {
    return (K * dLambda + view(blocks.F)).norm() / view(blocks.F).norm();
  }
  static Eigen::Map<const VectorXd> view(const std::vector<double>& x) {
    return {x.data(), static_cast<Eigen::Index>(x.size())};
  }

  std::unique_ptr<fixture::Inclusion> scene;
  NewtonBlocks blocks;
  MatrixXd K;
  int rows = 0;

 private:
  void evaluate() {
    const InclusionProblem& p = scene->problem;
    const MatrixXd G = scene->dense();
    const VectorXd Lambda = fixture::randomMatrix(random_, rows, 1);
    const VectorXd xi = fixture::randomMatrix(random_, rows, 1);
    blocks.F.assign(static_cast<std::size_t>(rows), 0.0);
    for (double& F : blocks.F) F = std::normal_distribution<double>()(random_);
    K.setZero(rows, rows);
    for (int i = 0; i < p.size(); ++i) {
      const int d = p.dim(i), first = p.row0(i);
      RowMatrix A(d, d), B(d, d);
      EXPECT_TRUE(p.law(i).proxDerivative(p.input(i), 0.3, xi.data() + first, Lambda.data() + first,
                                          A.data(), B.data()));
      blocks.block0.push_back(static_cast<std::ptrdiff_t>(blocks.A.size()));
      blocks.A.insert(blocks.A.end(), A.data(), A.data() + d * d);
      blocks.B.insert(blocks.B.end(), B.data(), B.data() + d * d);
      blocks.a.push_back(1e-2 * G(first, first));
      K.middleRows(first, d) += B * G.middleRows(first, d);
      K.block(first, first, d, d) += A + blocks.a.back() * B;
    }
  }
  std::mt19937 random_;
  UnilateralCoulomb coulomb_{0.0, 0.0, 0.4};
  Unilateral unilateral_;
  UnilateralRolling rolling_{0.4, 0.1};
  Bilateral bilateral_;
};

TEST(NewtonSystem, GivesTheSameStepInBothForms) {
  for (const int nu : {2, 3, 5, 6, 9})  // padded, full and dense blocks
    for (unsigned seed = 1; seed <= 5; ++seed) {
      Step step(nu, 6, seed);
      for (const auto& system : {NewtonSystem::inPercussions(5), NewtonSystem::inVelocities(nu)}) {
        ASSERT_TRUE(system->prepare(step.scene->problem));
        std::vector<double> dLambda(static_cast<std::size_t>(step.rows));
        ASSERT_TRUE(system->solve(step.scene->problem, step.blocks, dLambda)) << nu << ' ' << seed;
        // Masses from 0.2 to 30 and a = 1e-2 λ: condition numbers up to 1e5, times a few hundred ε.
        EXPECT_LT(step.residual(Step::view(dLambda)), 1e-9) << "nu " << nu << ", seed " << seed;
      }
    }
}

TEST(NewtonSystem, SolvesShiftedEquationsInBothForms) {
  for (const int nu : {2, 6, 9}) {
    Step step(nu, 5, 7);
    const MatrixXd G = step.scene->dense();
    const VectorXd r = VectorXd::LinSpaced(step.rows, -1.0, 2.0);
    const std::vector<double> a(static_cast<std::size_t>(step.scene->problem.size()), 0.5);
    const VectorXd expected =
        (G + 0.5 * MatrixXd::Identity(step.rows, step.rows)).partialPivLu().solve(r);
    for (const auto& system : {NewtonSystem::inPercussions(5), NewtonSystem::inVelocities(nu)}) {
      ASSERT_TRUE(system->prepare(step.scene->problem));
      ASSERT_TRUE(system->factorShifted(step.scene->problem, a));
      std::vector<double> x(static_cast<std::size_t>(step.rows));
      for (int repeat = 0; repeat < 2; ++repeat) {
        ASSERT_TRUE(system->solveShifted(step.scene->problem, r.data(), x));
        // |G| up to 1e3 over a shift of 0.5: condition 1e4, times a few hundred ε.
        EXPECT_LT((Step::view(x) - expected).norm(), 1e-9 * expected.norm()) << "nu " << nu;
      }
    }
  }
}

TEST(NewtonSystem, InVelocitiesIsAnalysedOncePerSetOfContacts) {
  Step step(6, 5, 3);
  const auto system = NewtonSystem::inVelocities(6);
  std::vector<double> dLambda(static_cast<std::size_t>(step.rows));
  for (int repeat = 0; repeat < 3; ++repeat) {
    ASSERT_TRUE(system->prepare(step.scene->problem));
    ASSERT_TRUE(system->solve(step.scene->problem, step.blocks, dLambda));
    // Another contact opens: B = 0, A = I.
    const std::ptrdiff_t at = step.blocks.block0[repeat], size = step.scene->contacts.dim(repeat);
    std::fill_n(step.blocks.B.begin() + at, size * size, 0.0);
    std::fill_n(step.blocks.A.begin() + at, size * size, 0.0);
    for (int k = 0; k < size; ++k) step.blocks.A[at + k * (size + 1)] = 1.0;
  }
  EXPECT_EQ(system->analyses(), 1);
}

TEST(NewtonSystem, CountsVelocitiesThatContactsActOn) {
  fixture::Inclusion scene({MatrixXd::Identity(6, 6), MatrixXd::Identity(2, 2)});
  const Unilateral law;
  scene.contact(law, VectorXd::Unit(8, 7).transpose());
  scene.pose(VectorXd::Constant(1, -1.0));
  std::vector<char> seen;
  const TouchedVelocities v = touchedVelocities(scene.problem, seen);
  EXPECT_EQ(v.count, 2);
  EXPECT_EQ(v.largest, 2);
}

}  // namespace
}  // namespace dynamy
