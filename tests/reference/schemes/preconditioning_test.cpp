/// Preconditioning shown by its effect: the matrix that a step's Newton iteration solves keeps its
/// condition at every step size, because its unknowns are velocities and percussions. The same
/// equations in (q, λ) or (u, λ), for comparison, lose four or one decades per decade of Δt.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <dynamy/schemes/joints/joint_newton.hpp>
#include <reference/schemes/scheme_table.hpp>

namespace dynamy::reference {
namespace {

using Eigen::MatrixXd;

double condition(const MatrixXd& A) {
  const Eigen::VectorXd s = A.jacobiSvd().singularValues();
  return s[0] / s[s.size() - 1];
}

/// A double pendulum on two rods, 1 and 2 kg, with a stiff damped spring from its end to the world.
const char* const kDouble =
    "<systems><PointMass name=\"a\" plane=\"xz\" position=\"1 0 0\" mass=\"1\"/><PointMass "
    "name=\"b\" plane=\"xz\" position=\"1.6 0 0.8\" mass=\"2\"/><Ground name=\"world\"/></systems>"
    "<forces><Gravity/><SpringDamper between=\"world b\" stiffness=\"1e4\" damping=\"10\" "
    "length=\"1.5\" stiff=\"true\"/></forces><elements><Distance between=\"world a\"/><Distance "
    "between=\"a b\"/></elements>";
constexpr double kSteps[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};

/// W of the problem just solved, nu × rows.
MatrixXd directions(const Scene& scene, const MechanicalSystem& system) {
  const ContactSet& c = *system.problem().contacts;
  MatrixXd W = MatrixXd::Zero(scene.state().u.size(), c.rows());
  for (int i = 0; i < c.size(); ++i)
    for (int k = c.segment0[static_cast<std::size_t>(i)];
         k < c.segment0[static_cast<std::size_t>(i) + 1]; ++k) {
      const Segment& s = c.segment[static_cast<std::size_t>(k)];
      for (int r = 0; r < c.dim(i); ++r)
        for (int j = 0; j < s.nu; ++j)
          W(s.u0 + j, c.row0[static_cast<std::size_t>(i)] + r) =
              c.W[static_cast<std::size_t>(s.w + r * s.nu + j)];
    }
  return W;
}
/// M̂ of that problem, from M̂⁻¹ applied to unit vectors.
MatrixXd implicitMass(const MechanicalSystem& system, Eigen::Index nu) {
  MatrixXd inverse(nu, nu);
  Eigen::VectorXd column(nu);
  for (Eigen::Index j = 0; j < nu; ++j) {
    system.problem().applyInverseMass(Eigen::VectorXd::Unit(nu, j), column);
    inverse.col(j) = column;
  }
  return inverse.inverse();
}
/// [A, −b W; Wᵀ, 0].
MatrixXd saddle(const MatrixXd& A, const MatrixXd& W, double b = 1.0) {
  const Eigen::Index n = A.rows(), m = W.cols();
  MatrixXd out = MatrixXd::Zero(n + m, n + m);
  out.topLeftCorner(n, n) = A;
  out.topRightCorner(n, m) = -b * W;
  out.bottomLeftCorner(m, n) = W.transpose();
  return out;
}

class Preconditioning : public testing::TestWithParam<SchemeOrders> {};

TEST_P(Preconditioning, KeepsTheConditionOfTheIterationMatrix) {
  // In (u, Λ): [M̂, −W; Wᵀ, 0]. M̂ differs from M by Δt D + Δt² K, 1.1 at most at 1e-2; M has the
  // condition 2, the rods stand at 53° to each other.
  double finest = 0.0;
  for (const double dt : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    Scene scene("double", {.text = modelWith(GetParam().xml, kDouble)});
    scene.step(dt);
    if (!scene.report().refused.empty()) GTEST_SKIP() << scene.report().refused;
    ASSERT_TRUE(scene.solved()) << dt;
    const MatrixXd W = directions(scene, scene.system());
    ASSERT_EQ(W.cols(), 2);
    const double now = condition(saddle(implicitMass(scene.system(), 4), W));
    EXPECT_LT(now, 10.0) << dt;
    if (finest == 0.0) finest = now;
    // The configuration turns by Δt γ̇ and M̂ changes with Δt: a part of 30 Δt at most.
    EXPECT_NEAR(now / finest, 1.0, 1e-6 + 100.0 * dt) << dt;
  }
}

INSTANTIATE_TEST_SUITE_P(AllSchemes, Preconditioning, testing::ValuesIn(kAllSchemes),
                         [](const auto& p) { return std::string(p.param.name); });

TEST(Preconditioning, HoldsForTheTangentOfTheImplicitMidpoint) {
  // JointNewton's K in (v, Λ) of EnergyMomentum, from K⁻¹ applied to unit vectors.
  double finest = 0.0;
  for (const double dt : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    Scene scene("double", {.text = modelWith("EnergyMomentum", kDouble)});
    JointNewton newton;
    ASSERT_TRUE(newton.equations.begin(scene.system(), scene.state(), dt));
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(4);
    newton.equations.evaluate(scene.system(), none);
    ASSERT_TRUE(newton.linearise(scene.system(), none));
    MatrixXd inverse = MatrixXd::Identity(newton.unknowns(), newton.unknowns());
    for (int j = 0; j < newton.unknowns(); ++j) newton.solve(inverse.col(j).data());
    const double now = condition(inverse);
    EXPECT_LT(now, 20.0) << dt;
    if (finest == 0.0) finest = now;
    // K is differenced: rounding leaves 1e-8 of it.
    EXPECT_NEAR(now / finest, 1.0, 1e-4 + 100.0 * dt) << dt;
  }
}

TEST(Preconditioning, IsWhatTheRawUnknownsLack) {
  // Index 3 in (q, λ): [M/Δt², −W; Wᵀ, 0], condition Δt⁻⁴; index 2 in (u, λ): [M, −ΔtW; Wᵀ, 0],
  // condition Δt⁻¹.
  Scene scene("double", {.text = modelWith("ConstraintIndex index=\"3\"", kDouble)});
  scene.step(1e-8);
  const MatrixXd W = directions(scene, scene.system()),
                 M = Eigen::Vector4d(1.0, 1.0, 2.0, 2.0).asDiagonal();
  // Where Δt⁻² outweighs W, and before the condition exceeds what 16 digits can show.
  const std::vector<double> dt{3e-3, 1e-3, 3e-4};
  std::vector<double> three, two;
  for (const double h : dt) {
    three.push_back(condition(saddle(M / (h * h), W)));
    two.push_back(condition(saddle(M, W, h)));
  }
  EXPECT_NEAR(fitOrder(dt, three).order, -4.0, 0.05);
  EXPECT_NEAR(fitOrder(dt, two).order, -1.0, 0.05);
  EXPECT_GT(three.front(), 1e8);
}

TEST(Preconditioning, LetsTheRodsKeepTheirLengthsAtEveryStepSize) {
  // Without scaling a solve at 1e-8 would leave nothing of 16 digits. Newton ends at a tenth of
  // g_tol = 1e-12 of the scene's length of 1.8 m.
  for (const char* scheme : {"ConstraintIndex index=\"3\"", "Ggl", "EnergyMomentum"})
    for (const double dt : kSteps) {
      Scene scene("double", {.text = modelWith(scheme, kDouble)});
      scene.run(10.0 * dt, dt);
      ASSERT_TRUE(scene.solved()) << scheme << dt;
      EXPECT_NEAR(scene.q("a").norm(), 1.0, 1e-12) << scheme << dt;
      EXPECT_NEAR((scene.q("b") - scene.q("a")).norm(), 1.0, 1e-12) << scheme << dt;
    }
}

}  // namespace
}  // namespace dynamy::reference
