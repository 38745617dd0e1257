// What looks along few directions say of two bodies, against points of their surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy_elements/contacts/pairs/seen_apart.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"

namespace dynamy {
namespace {

using testing::ball;

/// A shape and points of its surface in its own axes.
struct SampledBody {
  TouchingShape shape;
  std::vector<Vec3> points;
  Frame frame;
};

/// Points of the unit ball's surface, spread by the golden angle.
std::vector<Vec3> onUnitBall(int n) {
  std::vector<Vec3> out;
  for (int i = 0; i < n; ++i) {
    const double z = 1.0 - (2 * i + 1.0) / n, r = std::sqrt(1.0 - z * z), a = 2.39996323 * i;
    out.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  return out;
}

SampledBody sampledCapsule() {
  SampledBody b;
  for (const double z : {-0.4, 0.4}) {
    b.shape.features.push_back(ball(0.2, Vec3(0, 0, z)));
    for (const Vec3& p : onUnitBall(400)) b.points.push_back(Vec3(0, 0, z) + 0.2 * p);
  }
  return b;
}

SampledBody sampledBox() {
  SampledBody b;
  for (int k = 0; k < 8; ++k)
    b.shape.features.push_back(
        ball(0.0, Vec3(k & 1 ? 0.5 : -0.5, k & 2 ? 0.3 : -0.3, k & 4 ? 0.2 : -0.2)));
  for (const Vec3& p : onUnitBall(1000))
    b.points.push_back(Vec3(p.array() / p.cwiseAbs().maxCoeff() * Vec3(0.5, 0.3, 0.2).array()));
  for (const SupportFeature& f : b.shape.features) b.points.push_back(f.c_K);
  return b;
}

/// A cylinder, with a tube about its edges a torus' hull.
SampledBody sampledCylinder(double tube) {
  SampledBody b;
  for (const double z : {-0.3, 0.3}) {
    SupportFeature rim = ball(tube, Vec3(0, 0, z));
    rim.kind = SupportFeature::Kind::rim, rim.axis_K = Vec3::UnitZ(), rim.rho = 0.5;
    b.shape.features.push_back(rim);
    for (int i = 0; i < 100; ++i) {
      const double a = 2.0 * std::numbers::pi * i / 100;
      const Vec3 e(std::cos(a), std::sin(a), 0.0);
      for (int k = 0; k < 20; ++k) {
        const double t = 2.0 * std::numbers::pi * k / 20;
        b.points.push_back(Vec3(0, 0, z) + 0.5 * e +
                           tube * (std::cos(t) * e + std::sin(t) * Vec3::UnitZ()));
      }
    }
  }
  return b;
}

SampledBody sampledEllipsoid() {
  SampledBody b;
  const Vec3 D(0.6, 0.3, 0.2);
  SupportFeature f = ball(0.0, Vec3::Zero());
  f.kind = SupportFeature::Kind::ellipsoid, f.square_K = D.cwiseAbs2().asDiagonal();
  b.shape.features.push_back(f);
  for (const Vec3& p : onUnitBall(1000)) b.points.push_back(D.cwiseProduct(p));
  return b;
}

/// Of the sampled points: not less than the distance of the bodies.
double between(const SampledBody& a, const SampledBody& b) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<Vec3> all;
  for (const Vec3& p : b.points) all.push_back(b.frame.r_OS_I + b.frame.A_IK * p);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Vec3 x = a.frame.r_OS_I + a.frame.A_IK * a.points[i];
    for (const Vec3& y : all) least = std::min(least, (x - y).squaredNorm());
  }
  return std::sqrt(least);
}

TEST(SeenApart, NeverCallsNearBodiesApartAndSeesMostThatAre) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.5, 2.0);
  std::vector<SampledBody> bodies{sampledCapsule(), sampledBox(), sampledCylinder(0.0),
                                  sampledCylinder(0.1), sampledEllipsoid()};
  int wide = 0, seen = 0;
  for (int trial = 0; trial < 150; ++trial) {
    SampledBody a = bodies[static_cast<std::size_t>(trial % 5)];
    SampledBody b = bodies[static_cast<std::size_t>(trial / 5 % 5)];
    for (SampledBody* body : {&a, &b}) {
      const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
      body->frame.A_IK = q.normalized().toRotationMatrix();
      body->frame.r_OS_I.setZero();
    }
    b.frame.r_OS_I =
        uniform(random) * Vec3(normal(random), normal(random), normal(random)).normalized();
    const double distance = between(a, b);
    // The samples are nowhere nearer than the bodies: what is seen apart lies apart.
    for (const double reach : {0.0, 0.02, 0.1, 0.3, 1.0})
      if (seenApart(a.shape, b.shape, a.frame, b.frame, reach)) {
        EXPECT_GT(distance, reach) << trial;
      }
    if (distance < 0.25) continue;  // samples lie up to 0.1 apart
    ++wide;
    if (seenApart(a.shape, b.shape, a.frame, b.frame, 0.05)) ++seen;
  }
  EXPECT_GT(wide, 50);
  EXPECT_GE(seen, 0.95 * wide) << seen << " of " << wide;
}

TEST(SeenApart, IsExactForBallsAndSilentWithoutFeatures) {
  SampledBody a, b;
  a.shape.features.push_back(ball(0.3, Vec3::Zero()));
  b.shape.features.push_back(ball(0.2, Vec3::Zero()));
  a.frame.A_IK.setIdentity(), b.frame.A_IK.setIdentity();
  a.frame.r_OS_I.setZero(), b.frame.r_OS_I = Vec3(0.6, 0.0, 0.8);  // 1 − 0.5 = 0.5 apart
  EXPECT_TRUE(seenApart(a.shape, b.shape, a.frame, b.frame, 0.5 - 1e-12));
  EXPECT_FALSE(seenApart(a.shape, b.shape, a.frame, b.frame, 0.5 + 1e-12));
  b.frame.r_OS_I.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(seenApart(a.shape, b.shape, a.frame, b.frame, 0.0));
  EXPECT_FALSE(seenApart(a.shape, TouchingShape(), a.frame, b.frame, 0.0));
}

}  // namespace
}  // namespace dynamy
