// M⁻¹ of blocks against closed forms and plain algebra.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <dynamy/system/mass_matrix.hpp>
#include <iostream>
#include <random>

namespace dynamy {
namespace {

constexpr unsigned kSeed = 11;

/// `capacity` blocks whose M is given by a function of q[0] of each block.
class Masses final : public PartialMechanicalSystem {
 public:
  Masses(std::vector<Eigen::MatrixXd> M, bool constant) : M_(std::move(M)), constant_(constant) {}
  Blocks blocks() const override {
    const int n = static_cast<int>(M_.front().rows());
    return {.nq = n, .nu = n, .capacity = static_cast<int>(M_.size()), .constantMass = constant_};
  }
  void initialState(Vec q, Vec u) const override { q.setOnes(), u.setZero(); }
  void M(double t, ConstVec, MassBlocks M) const override {
    ++calls;
    for (int b = 0; b < M.capacity(); ++b) M[b] = (1.0 + t) * M_[static_cast<std::size_t>(b)];
  }
  void h(double, ConstVec, ConstVec, Vec h) const override { h.setZero(); }
  mutable int calls = 0;

 private:
  std::vector<Eigen::MatrixXd> M_;
  bool constant_;
};

struct Evaluated {
  explicit Evaluated(const std::vector<const PartialMechanicalSystem*>& systems)
      : topology(systems), q(Eigen::VectorXd::Ones(topology.nq())) {
    mass.resize(topology);
  }
  int at(double t) { return mass.evaluate(topology, t, {q.data(), q.size()}); }
  Topology topology;
  Eigen::VectorXd q;
  MassMatrix mass;
};

TEST(MassMatrix, InvertsATwoByTwoBlockExactly) {
  // [2 1; 1 1]⁻¹ = [1 −1; −1 2].
  const Masses system({Eigen::MatrixXd{{2.0, 1.0}, {1.0, 1.0}}}, true);
  Evaluated x({&system});
  EXPECT_EQ(x.at(0.0), -1);
  const Eigen::MatrixXd expected{{1.0, -1.0}, {-1.0, 2.0}};
  EXPECT_LE((x.mass.inverse(0) - expected).norm(), 1e-14);  // condition 7 times a few ε
}

TEST(MassMatrix, InvertsRandomBlocksOfAllSizes) {
  std::mt19937 random(kSeed);
  std::cout << "seed " << kSeed << '\n';
  std::normal_distribution<double> normal;
  for (int n = 1; n <= 9; ++n) {
    Eigen::MatrixXd A(n, n);
    for (double& v : A.reshaped()) v = normal(random);
    const Eigen::MatrixXd M = A * A.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
    const Masses system({M}, true);
    Evaluated x({&system});
    EXPECT_EQ(x.at(0.0), -1);
    // |M M⁻¹ − I| ≤ c n² ε cond; cond ≤ 4n²/0.1 for these.
    EXPECT_LE((M * x.mass.inverse(0) - Eigen::MatrixXd::Identity(n, n)).norm(),
              1e-14 * 40 * n * n * n);
    EXPECT_EQ(x.mass.inverse(0), Eigen::MatrixXd(x.mass.inverse(0).transpose()));
  }
}

TEST(MassMatrix, AppliesBlocksToTheirOwnSlices) {
  const Masses a({Eigen::MatrixXd{{2.0}}, Eigen::MatrixXd{{4.0}}}, true),
      b({Eigen::MatrixXd{{2.0, 1.0}, {1.0, 1.0}}}, true);
  Evaluated x({&a, &b});
  x.at(0.0);
  const Eigen::VectorXd in{{2.0, 2.0, 1.0, 1.0}};
  Eigen::VectorXd out(4);
  x.mass.applyInverse({in.data(), 4}, {out.data(), 4});
  EXPECT_LE((out - Eigen::VectorXd{{1.0, 0.5, 0.0, 1.0}}).norm(), 1e-15);
  x.mass.apply({in.data(), 4}, {out.data(), 4});
  EXPECT_LE((out - Eigen::VectorXd{{4.0, 8.0, 3.0, 2.0}}).norm(), 1e-15);
  EXPECT_NEAR(x.mass.kineticEnergy({in.data(), 4}), 0.5 * (8.0 + 16.0 + 5.0), 1e-14);
}

TEST(MassMatrix, KnowsWhichBlocksAreDiagonal) {
  const Masses a({Eigen::MatrixXd{{2.0, 0.0}, {0.0, 4.0}}}, true),
      b({Eigen::MatrixXd{{2.0, 1.0}, {1.0, 1.0}}}, true);
  Evaluated x({&a, &b});
  x.at(0.0);
  ASSERT_NE(x.mass.inverseDiagonal(0), nullptr);
  EXPECT_EQ(x.mass.inverseDiagonal(1), nullptr);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(x.mass.inverseDiagonal(0)[i], x.mass.inverse(0)(i, i));
  const Eigen::VectorXd in{{3.0, 5.0, 0.0, 0.0}};
  Eigen::VectorXd out(4);
  x.mass.applyInverse({in.data(), 4}, {out.data(), 4});
  // 1/√M squared: a few ε.
  EXPECT_DOUBLE_EQ(out[0], 1.5);
  EXPECT_DOUBLE_EQ(out[1], 1.25);
}

TEST(MassMatrix, EvaluatesConstantMassesOnce) {
  const Masses constant({Eigen::MatrixXd{{2.0}}}, true), varying({Eigen::MatrixXd{{2.0}}}, false);
  Evaluated x({&constant, &varying});
  x.at(0.0), x.at(1.0);
  EXPECT_EQ(constant.calls, 1);
  EXPECT_EQ(varying.calls, 2);
  EXPECT_NEAR(x.mass.inverse(1)(0, 0), 0.25, 1e-16);  // M = (1 + t) 2
}

TEST(MassMatrix, NamesTheFirstSystemThatIsNotPositiveDefinite) {
  const Masses good({Eigen::MatrixXd{{1.0}}}, true),
      bad({Eigen::MatrixXd{{1.0, 2.0}, {2.0, 1.0}}}, true), zero({Eigen::MatrixXd{{0.0}}}, true),
      nan({Eigen::MatrixXd{{std::nan("")}}}, true);
  EXPECT_EQ(Evaluated({&good, &bad, &zero}).at(0.0), 1);
  EXPECT_EQ(Evaluated({&good, &zero}).at(0.0), 1);
  EXPECT_EQ(Evaluated({&nan}).at(0.0), 0);
}

}  // namespace
}  // namespace dynamy
