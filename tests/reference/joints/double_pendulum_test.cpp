/// Double pendulum of point masses on massless rods, released from the horizontal; angles from
/// straight down (S09: two runs in extended precision that agree to 4e-15).
#include <gtest/gtest.h>

#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

const Eigen::Vector4d kAtOneSecond(-0.6250876998063906, -1.0345850856800127, -3.922279572887974,
                                   -1.3030992486963329);

Eigen::Vector4d minimal(Scheme scheme, double dt) {
  Scene scene("double_pendulum", {.scheme = scheme});
  scene.run(1.0, dt);
  Eigen::Vector4d out;
  out << scene.q("minimal"), scene.u("minimal");
  return out - kAtOneSecond;
}

/// Angles and rates of the two rods from the places of the masses.
Eigen::Vector4d onRods(Scheme scheme, double dt) {
  Scene scene("double_pendulum", {.scheme = scheme});
  scene.run(1.0, dt);
  const Eigen::Vector2d r[2] = {scene.q("upper"), scene.q("lower") - scene.q("upper")};
  const Eigen::Vector2d v[2] = {scene.u("upper"), scene.u("lower") - scene.u("upper")};
  Eigen::Vector4d out;
  for (int i = 0; i < 2; ++i) {
    out[i] = std::atan2(r[i].x(), -r[i].y());
    out[2 + i] = (-v[i].x() * r[i].y() + v[i].y() * r[i].x()) / r[i].squaredNorm();
  }
  EXPECT_TRUE(scene.solved());
  return out - kAtOneSecond;
}

class DoublePendulum : public testing::TestWithParam<Scheme> {};

TEST_P(DoublePendulum, InMinimalCoordinatesIsOfOrderOneAndTendsToTheTruth) {
  const std::vector<double> dt = halvings(1e-3, 6);
  std::vector<double> size;
  std::vector<double> part[4];
  for (const double h : dt) {
    const Eigen::Vector4d error = minimal(GetParam(), h);
    size.push_back(error.norm());
    for (int i = 0; i < 4; ++i) part[i].push_back(error[i]);
  }
  // Second-order terms bend the line by a few per cent at Δt = 1e-3.
  EXPECT_NEAR(fitOrder(dt, size).order, 1.0, 0.1) << fitOrder(dt, size);
  for (auto& values : part) EXPECT_NEAR(richardson(values, 1, 1), 0.0, 1e-8);
}

TEST_P(DoublePendulum, OnRodsIsOfOrderOneAndTendsToTheTruth) {
  const std::vector<double> dt = halvings(1e-3, 6);
  std::vector<double> size;
  std::vector<double> part[4];
  for (const double h : dt) {
    const Eigen::Vector4d error = onRods(GetParam(), h);
    size.push_back(error.norm());
    for (int i = 0; i < 4; ++i) part[i].push_back(error[i]);
  }
  EXPECT_NEAR(fitOrder(dt, size).order, 1.0, 0.1) << fitOrder(dt, size);
  for (auto& values : part) EXPECT_NEAR(richardson(values, 1, 1), 0.0, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Schemes, DoublePendulum, testing::ValuesIn(kBothSchemes));

}  // namespace
}  // namespace dynamy::reference
