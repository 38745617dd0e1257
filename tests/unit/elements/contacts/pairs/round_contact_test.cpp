// Contacts of capsules and cylinders against alternating projections, and their rates against
// differences.
#include <dynamy_elements/contacts/pairs/round_contact.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <functional>
#include <random>
#include <unit/elements/contacts/pairs/pair_shapes.hpp>

namespace dynamy {
namespace {

using testing::capsule;
using testing::Mover;
using testing::turned;

TouchingShape solid(TouchingShape::Kind kind, const Vec3& half) {
  TouchingShape s;
  s.kind = kind, s.half = half, s.thickness = half.minCoeff(), s.bound = half.norm();
  return s;
}

/// Contacts of B on A at given frames.
using BoxPair = std::function<std::vector<BoxContact>(const Frame& A, const Frame& B)>;
/// Nearest point of a convex core of a body to p.
using Nearest = std::function<Vec3(const Frame& f, const Vec3& p)>;

std::vector<BoxContact> listed(const RoundContacts& out, int n) {
  return {out.begin(), out.begin() + n};
}

Nearest onSegment(double half) {
  return [=](const Frame& f, const Vec3& p) {
    const Vec3 e = f.A_IK.col(2);
    return Vec3(f.r_OS_I + std::clamp(e.dot(p - f.r_OS_I), -half, half) * e);
  };
}
Nearest onBox(const Vec3& half) {
  return [=](const Frame& f, const Vec3& p) {
    const Vec3 x = f.A_IK.transpose() * (p - f.r_OS_I);
    return Vec3(f.r_OS_I + f.A_IK * x.cwiseMax(-half).cwiseMin(half));
  };
}
Nearest onCylinder(double R, double half) {
  return [=](const Frame& f, const Vec3& p) {
    Vec3 x = f.A_IK.transpose() * (p - f.r_OS_I);
    const double r = x.head<2>().norm();
    if (r > R) x.head<2>() *= R / r;
    x.z() = std::clamp(x.z(), -half, half);
    return Vec3(f.r_OS_I + f.A_IK * x);
  };
}
Nearest onPoint() {
  return [](const Frame& f, const Vec3&) { return f.r_OS_I; };
}

/// Smallest gap = distance of the cores − radii; no gap is smaller; rates are those of the motion.
void expectExact(const BoxPair& pair, const Nearest& coreA, const Nearest& coreB, double radii) {
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vec = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  int met = 0, compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Mover A(0.1 * vec(), turned(2.0 * vec()), vec(), vec());
    const Mover B(vec().normalized() * (1.2 + 0.5 * uniform(random)), turned(2.0 * vec()), vec(),
                  vec());
    Vec3 a = A.frame.r_OS_I, b = B.frame.r_OS_I;
    for (int i = 0; i < 20000; ++i) b = coreB(B.frame, a), a = coreA(A.frame, b);
    const double distance = (b - a).norm();
    if (distance < 0.05) continue;
    const std::vector<BoxContact> here = pair(A.frame, B.frame);
    double smallest = 1e300;
    for (const BoxContact& c : here) smallest = std::min(smallest, c.at.g);
    ++met;
    // Alternating projections stop at steps of 1e-16, which leaves about 1e-12 on flat ways.
    EXPECT_NEAR(smallest, distance - radii, 1e-10) << "trial " << trial << ", seed " << kSeed;

    constexpr double s = 1e-5;
    // Central differences: s² times third derivatives of up to (speed/distance)³, rounding over s.
    constexpr double kTolerance = 1e-6;
    const auto before = pair(A.after(-s).frame, B.after(-s).frame),
               after = pair(A.after(s).frame, B.after(s).frame);
    for (const BoxContact& c : here) {
      const auto same = [&](const BoxContact& o) { return o.id == c.id; };
      const auto p = std::find_if(before.begin(), before.end(), same);
      const auto q = std::find_if(after.begin(), after.end(), same);
      if (p == before.end() || q == after.end()) continue;
      // Crossings of nearly parallel lines run along them faster than differences can tell.
      if (c.at.Pdot.norm() > 10.0) continue;
      ++compared;
      const Vec3 v =
          B.frame.velocity(c.at.P - B.frame.r_OS_I) - A.frame.velocity(c.at.P - A.frame.r_OS_I);
      EXPECT_NEAR(c.at.d[0].dot(v), (q->at.g - p->at.g) / (2.0 * s), kTolerance) << c.id;
      EXPECT_LT((c.at.Pdot - (q->at.P - p->at.P) / (2.0 * s)).norm(), 100.0 * kTolerance) << c.id;
      for (int k = 0; k < 3; ++k)
        EXPECT_LT((c.at.ddot[k] - (q->at.d[k] - p->at.d[k]) / (2.0 * s)).norm(), 100.0 * kTolerance)
            << c.id << ", direction " << k;
      EXPECT_NEAR(c.at.d[0].cross(c.at.d[1]).dot(c.at.d[2]), 1.0, 1e-14);
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(compared, 200);
}

TEST(RoundContact, OfTwoCapsulesIsTheirDistance) {
  const TouchingShape a = capsule(0.2, 0.7), b = capsule(0.1, 0.5);
  expectExact(
      [&](const Frame& A, const Frame& B) {
        RoundContacts out;
        return listed(out, betweenCapsules(A, a, B, b, Vec3::Zero(), out));
      },
      onSegment(0.7), onSegment(0.5), 0.3);
}

TEST(RoundContact, OfABallOnACapsuleIsTheirDistance) {
  const TouchingShape a = capsule(0.2, 0.7);
  expectExact(
      [&](const Frame& A, const Frame& B) {
        return std::vector<BoxContact>{
            {0, ballOnCapsule(A, a, B, {Vec3::Zero(), 0.3}, Vec3::Zero())}};
      },
      onSegment(0.7), onPoint(), 0.5);
}

TEST(RoundContact, OfABallOnACylinderIsTheirDistance) {
  const TouchingShape a = solid(TouchingShape::Kind::cylinder, {0.5, 0.5, 0.6});
  expectExact(
      [&](const Frame& A, const Frame& B) {
        return std::vector<BoxContact>{{0, ballOnCylinder(A, a, B, {Vec3::Zero(), 0.3})}};
      },
      onCylinder(0.5, 0.6), onPoint(), 0.3);
}

TEST(RoundContact, OfACapsuleOnABoxIsTheirDistance) {
  const TouchingShape a = solid(TouchingShape::Kind::box, {0.3, 0.5, 0.7}), b = capsule(0.1, 0.6);
  expectExact(
      [&](const Frame& A, const Frame& B) {
        RoundContacts out;
        return listed(out, capsuleOnBox(A, a, B, b, out));
      },
      onBox({0.3, 0.5, 0.7}), onSegment(0.6), 0.1);
}

TEST(RoundContact, OfParallelCapsulesAreTwo) {
  const TouchingShape a = capsule(0.2, 0.7), b = capsule(0.1, 0.5);
  const Mover A(Vec3::Zero(), Mat3::Identity(), Vec3::Zero(), Vec3::Zero());
  const Mover B(Vec3(0.3, 0.0, 0.4), Mat3::Identity(), Vec3::Zero(), Vec3::Zero());
  RoundContacts out;
  const auto found = listed(out, betweenCapsules(A.frame, a, B.frame, b, Vec3::Zero(), out));
  // One end of B over A, one end of A over B; B's other end is beyond A's.
  int touching = 0;
  for (const BoxContact& c : found) touching += std::abs(c.at.g) < 1e-15;
  EXPECT_EQ(touching, 2);
}

TEST(RoundContact, OfABallInsideOfACylinderIsTheNearestFace) {
  const TouchingShape a = solid(TouchingShape::Kind::cylinder, {0.5, 0.5, 0.6});
  const Mover A(Vec3::Zero(), Mat3::Identity(), Vec3::Zero(), Vec3::Zero());
  const auto gap = [&](const Vec3& at) {
    const Mover B(at, Mat3::Identity(), Vec3::Zero(), Vec3::Zero());
    return ballOnCylinder(A.frame, a, B.frame, {Vec3::Zero(), 0.1}).g;
  };
  EXPECT_NEAR(gap({0.4, 0.0, 0.3}), -0.1 - 0.1, 1e-15);
  EXPECT_NEAR(gap({0.1, 0.0, -0.55}), -0.05 - 0.1, 1e-15);
  EXPECT_NEAR(gap({0.0, 0.0, 0.0}), -0.5 - 0.1, 1e-15);
}

}  // namespace
}  // namespace dynamy
