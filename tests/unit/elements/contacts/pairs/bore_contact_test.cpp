// Cylinders in bores against samples of rims and edges, at random places.
#include <dynamy_elements/contacts/pairs/bore_contact.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <unit/elements/contacts/faceted_bodies.hpp>

namespace dynamy {
namespace {

TouchingShape about(TouchingShape::Kind kind, double radius, double half) {
  TouchingShape s;
  s.kind = kind, s.half = {radius, radius, half};
  return s;
}

/// Least of R − |y| over the rims of the cylinder in the bore, and of |y| − r over the edges of the
/// bore along the cylinder, from samples.
double sampled(const Frame& A, const TouchingShape& bore, const Frame& B,
               const TouchingShape& cylinder) {
  constexpr int kSamples = 2000;
  double least = std::numeric_limits<double>::infinity();
  const auto circle = [&](const Frame& of, const TouchingShape& s, const Frame& in,
                          const TouchingShape& t, double sign) {
    for (const double z : {-s.half.z(), s.half.z()})
      for (int i = 0; i < kSamples; ++i) {
        const double phi = 2.0 * 3.14159265358979323846 * i / kSamples;
        const Vec3 x =
            of.r_OS_I + of.A_IK * Vec3(s.half.x() * std::cos(phi), s.half.x() * std::sin(phi), z);
        const Vec3 y = in.A_IK.transpose() * (x - in.r_OS_I);
        if (std::abs(y.z()) <= t.half.z())
          least = std::min(least, sign * (t.half.x() - y.head<2>().norm()));
      }
  };
  circle(B, cylinder, A, bore, 1.0);
  circle(A, bore, B, cylinder, -1.0);
  return least;
}

TEST(BoreContact, IsTheLeastGapOfRimsAndEdges) {
  std::mt19937 random(1);  // the seed
  std::uniform_real_distribution<double> in(-1.0, 1.0);
  for (int i = 0; i < 40; ++i) {
    Frame A, B;
    A.A_IK = B.A_IK = Mat3::Identity();
    A.A_IK = testing::turned(Vec3(in(random), in(random), in(random)));
    A.r_OS_I = Vec3(in(random), in(random), in(random));
    // Journals with little tilt, shorter and longer than their bores; some of them deep inside
    // of the wall.
    B.A_IK = A.A_IK * testing::turned(0.1 * Vec3(in(random), in(random), in(random)));
    B.r_OS_I = A.r_OS_I + A.A_IK * (0.1 * Vec3(in(random), in(random), in(random)));
    const TouchingShape bore = about(TouchingShape::Kind::bore, 1.0, 0.5);
    const TouchingShape shaft = about(TouchingShape::Kind::cylinder, 0.9, i % 2 == 0 ? 0.3 : 1.0);
    BoreContacts contacts;
    const int n = cylinderInBore(A, bore, B, shaft, contacts);
    ASSERT_EQ(n, 2) << i;
    const double least = std::min(contacts[0].at.g, contacts[1].at.g);
    // Samples are off by half the square of half their spacing, 1.6e-3, times a curvature of 1.
    EXPECT_NEAR(least, sampled(A, bore, B, shaft), 2e-6) << i;
  }
}

TEST(BoreContact, HasTwoPointsOfEachRimForACylinderAcross) {
  Frame A, B;
  A.A_IK = B.A_IK = Mat3::Identity();
  B.A_IK = testing::turned(Vec3(1.5, 0.0, 0.0));
  B.r_OS_I = Vec3(0.02, 0.01, 0.0);
  const TouchingShape bore = about(TouchingShape::Kind::bore, 1.0, 5.0);
  const TouchingShape rod = about(TouchingShape::Kind::cylinder, 0.3, 0.95);
  BoreContacts contacts;
  const int n = cylinderInBore(A, bore, B, rod, contacts);
  ASSERT_EQ(n, 4);
  double least = 1.0;
  for (const NumberedContact& c : contacts) {
    least = std::min(least, c.at.g);
    // All are points of a rim that lie furthest from the axis on their side.
    EXPECT_LT(c.at.g, 0.06);
  }
  EXPECT_NEAR(least, sampled(A, bore, B, rod), 2e-6);
  EXPECT_GT((contacts[0].at.P - contacts[1].at.P).norm(), 0.3);
}

TEST(BoreContact, OfABallAtTheEndIsThatOfTheEdge) {
  Frame A, B;
  A.A_IK = B.A_IK = Mat3::Identity();
  const TouchingShape bore = about(TouchingShape::Kind::bore, 1.0, 0.5);
  RoundFeature ball;
  ball.radius = 0.4;
  ContactPoint at;
  B.r_OS_I = Vec3(0.5, 0.0, 0.4);
  ASSERT_TRUE(ballInBore(A, bore, B, ball, Vec3::Zero(), at));
  EXPECT_NEAR(at.g, 0.1, 1e-15);
  B.r_OS_I = Vec3(0.5, 0.0, 0.7);
  ASSERT_TRUE(ballInBore(A, bore, B, ball, Vec3::Zero(), at));
  EXPECT_NEAR(at.g, std::hypot(0.5, 0.2) - 0.4, 1e-15);
  B.r_OS_I = Vec3(1.2, 0.0, 0.7);
  EXPECT_FALSE(ballInBore(A, bore, B, ball, Vec3::Zero(), at));
}

}  // namespace
}  // namespace dynamy
