// The inclusion where no contact changes its state, against what it says: ξ = 0 where a contact
// holds, Λ = 0 where it is open.
#include <gtest/gtest.h>

#include <dynamy/solver/newton/held_states.hpp>

#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Two bodies of six velocities, masses 1 and 10⁴, under eight contacts of three rows each: of 48
/// rows 12 are independent. Λ₀ presses all of them but the last one, ξ(Λ₀) = 0; then the load
/// changes by 1e-3 of it, within the range of G as it must.
class Pressed {
 public:
  Pressed()
      : scene_({fixture::randomMass(random_, 6), 1e4 * fixture::randomMass(random_, 6)}),
        law_(0.0, 0.0, 0.5) {
    for (int i = 0; i < 16; ++i) {
      MatrixXd Wt = MatrixXd::Zero(3, 12);
      Wt.rightCols(6) = fixture::randomMatrix(random_, 3, 6);
      if (i < 8) Wt.leftCols(6) = fixture::randomMatrix(random_, 3, 6);
      scene_.contact(law_, Wt);
    }
    Lambda = VectorXd::Zero(48);
    for (int i = 0; i < 15; ++i) Lambda[3 * i] = 1.0 + 0.1 * i, Lambda[3 * i + 1] = 0.1;
    scene_.pose(VectorXd::Zero(48), 1.0, Delassus::Form::matrixFree);
    const MatrixXd G = scene_.dense();
    c = -G * Lambda + 1e-3 * G * fixture::randomMatrix(random_, 48, 1).cwiseProduct(Lambda);
    c[45] += 10.0;  // the last contact leaves
  }
  InclusionProblem& problem() { return scene_.pose(c, 1.0, Delassus::Form::matrixFree); }
  bool solve(VectorXd& x, SolveReport& report) {
    InclusionProblem& p = problem();
    std::vector<double> scratch;
    report.residuals = residuals(p, {x.data(), x.size()}, scratch);
    return HeldStates().solve(p, scratch.data(), 1e-10, view(x), report);
  }
  VectorXd Lambda, c;

 private:
  std::mt19937 random_{3};
  fixture::Inclusion scene_;
  UnilateralCoulomb law_;
};

TEST(HeldStates, SolvesByOneFactorisationWhatIsLinear) {
  Pressed pressed;
  VectorXd x = pressed.Lambda;
  SolveReport report;
  EXPECT_TRUE(pressed.solve(x, report));
  EXPECT_GE(report.newton, 1);
  EXPECT_LE(report.newton, 4);
  EXPECT_TRUE(x.tail(3).isZero(0.0));
  InclusionProblem& p = pressed.problem();
  VectorXd xi(48);
  p.G->apply(x.data(), xi.data());
  xi += pressed.c;
  // E_u = 1e-10 of u_ref, and no contact's natural map is larger than its ξ over two.
  EXPECT_LT(xi.head(45).lpNorm<Eigen::Infinity>(), 4e-10 * p.uRef);
  std::vector<double> scratch;
  EXPECT_LE(residuals(p, {x.data(), x.size()}, scratch).largest(), 1e-10);
}

TEST(HeldStates, LeavesContactsThatSlipOrOpenToNewtonsMethod) {
  for (const int row : {0, 1}) {  // pulled off, and driven along its plane
    Pressed pressed;
    pressed.c[row] += 1e3 * pressed.c.lpNorm<Eigen::Infinity>();
    VectorXd x = pressed.Lambda;
    SolveReport report;
    EXPECT_FALSE(pressed.solve(x, report));
    EXPECT_EQ(report.newton, 0);
    EXPECT_EQ(x, pressed.Lambda);
  }
}

}  // namespace
}  // namespace dynamy
