#include <gtest/gtest.h>

#include <dynamy/contact/contact_sink.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/stages/position_aim.hpp>
#include <limits>

namespace dynamy {
namespace {

const UnilateralCoulomb kDryFriction(0.0, 0.0, 0.5);
constexpr double kAimedStep = 2e-3, kAimedCap = 1.0;

/// Velocity [m/s] with which a rough step separates two bodies without forces that overlap by
/// `depth` and have the normal velocity gammaA.
double separating(double depth, double gammaA, double pushOutIn = 0.0) {
  ContactSet set;
  set.clear();
  ContactSink sink(set, {});
  sink.add(1, -depth, kDryFriction, 3).segment(BlockPlace{0, 0, 6}).setZero();
  InclusionProblem p;
  p.contacts = &set, p.dt = kAimedStep;
  p.gammaA = {gammaA, 0.0, 0.0}, p.gammaFree = {gammaA, 0.0, 0.0};
  const PositionAim aim{.dead = -std::numeric_limits<double>::infinity(), .cap = kAimedCap};
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(6);
  std::vector<ContactKey> arriving;
  addAim({aim, 1e-12, pushOutIn}, u, u, p, arriving);
  return gammaA - p.gammaFree[0];
}

TEST(PositionAim, PushesBodiesOutOfAnOverlapInTheStep) {
  EXPECT_DOUBLE_EQ(separating(1e-3, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(separating(1e-3, 0.0, 2.0 * kAimedStep), 0.25);
}

TEST(PositionAim, PushesBodiesOutNoFasterThanTheyMetOrTheCap) {
  EXPECT_EQ(separating(0.25, 0.0), kAimedCap);
  EXPECT_EQ(separating(0.25, 0.25), kAimedCap);
  EXPECT_EQ(separating(0.25, -16.0), 16.0);
}

}  // namespace
}  // namespace dynamy
