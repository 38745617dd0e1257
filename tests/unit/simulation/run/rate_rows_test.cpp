/// Bilateral rows that are rates of no position, as an element of a user has them: a sleigh on one
/// edge below its centre of mass, which can turn and go along the edge but not across it.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/law/bilateral_rate.hpp>
#include <dynamy/schemes/energy_momentum.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/testing/check_element.hpp>

namespace dynamy {
namespace {

constexpr double kSpeed = 0.7, kTurn = 1.3;  // [m/s, rad/s]

class Sleigh final : public PartialMechanicalSystem {
 public:
  Blocks blocks() const override { return {.nq = 3, .nu = 3, .constantMass = true}; }
  void initialState(Vec q, Vec u) const override { q.setZero(), u << kSpeed, 0.0, kTurn; }
  void M(double, ConstVec, MassBlocks M) const override {
    M[0].setZero();
    M[0].diagonal() << 2.0, 2.0, 0.1;
  }
  void h(double, ConstVec, ConstVec, Vec h) const override { h.setZero(); }
};

template <class Law>
class Edge final : public NonSmoothElement {
 public:
  explicit Edge(bool position) : position_(position) {}
  void connect(Topology& topology) override { system_ = topology.system(0); }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    const double phi = k.q(system_)[2], g = position_ ? k.q(system_)[0] : 0.0;
    ContactRows rows = sink.add(0, g, law_, 1);
    Block W = rows.segment(system_);
    W(0, 0) = -std::sin(phi), W(0, 1) = std::cos(phi);
    if (!rows.wantsBias()) return;
    const ConstVec u = k.u(system_);
    rows.bias(0) = -u[2] * (std::cos(phi) * u[0] + std::sin(phi) * u[1]);
  }

 private:
  bool position_;
  Law law_;
  SystemHandle system_;
};

template <class Law>
Model sleigh(double step = 1e-2, bool position = false) {
  Model m;
  m.add(std::make_unique<Sleigh>());
  m.add(std::make_unique<Edge<Law>>(position));
  m.simulation.until = 2.0, m.simulation.step = step;
  m.build();
  return m;
}

/// Distance of the end from the circle's: speed and rate of turning stay, so that the centre goes
/// round with radius v/ω.
double errorWith(double step) {
  Model m = sleigh<BilateralRate>(step);
  Simulation s(m);
  EXPECT_EQ(s.run().ended, RunReport::Ended::finished);
  const double phi = kTurn * 2.0, R = kSpeed / kTurn;
  return std::hypot(s.state().q[0] - R * std::sin(phi), s.state().q[1] - R * (1.0 - std::cos(phi)));
}

TEST(RateRows, ASleighGoesRoundInACircle) {
  // Second order: a factor of four per halving, up to the share of the next term, 1e-2.
  const double coarse = errorWith(1e-2), fine = errorWith(5e-3);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

TEST(RateRows, AJointWithoutAPositionIsRefusedWithTheCause) {
  Model m = sleigh<Bilateral>();
  m.scheme(std::make_unique<EnergyMomentum>());
  Simulation s(m);
  const RunReport& report = s.run();
  EXPECT_TRUE(report.refused);
  EXPECT_NE(report.reason.find("has none: write its position, or give it a BilateralRate"),
            std::string::npos)
      << report.reason;
}

TEST(RateRows, TheCheckOfElementsTellsPositionsThatDoNotFollow) {
  Model none = sleigh<Bilateral>(), wrong = sleigh<Bilateral>(1e-2, true),
        right = sleigh<BilateralRate>();
  EXPECT_NE(checkModel(none).message().find("its position changes by 0 m/s"), std::string::npos);
  EXPECT_NE(checkModel(wrong).message().find("but its position changes by"), std::string::npos);
  EXPECT_TRUE(checkModel(right)) << checkModel(right);
}

}  // namespace
}  // namespace dynamy
