// Tangents of a contact: a frame, and the same one a rounding later. Matrices of quaternions.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <random>

namespace dynamy {
namespace {

constexpr unsigned kSeed = 11;

TEST(Tangents, CompleteTheNormalToARightHandedFrame) {
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int k = 0; k < 1000; ++k) {
    // Every other one next to where the formula changes, the least favourable place.
    Vec3 n(uniform(random), uniform(random), uniform(random));
    if (k % 2 == 0) n.z() = -std::hypot(n.x(), n.y()) * 0.9 / std::sqrt(1.0 - 0.81);
    n.normalize();
    Vec3 t1, t2;
    tangents(n, t1, t2);
    Mat3 A;
    A << n, t1, t2;
    // n is a unit vector to ε; a = 1/(1 + n_z) ≤ 10 magnifies that, and A Aᵀ doubles it: 20 ε, and
    // as much for the products.
    EXPECT_LE((A.transpose() * A - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-14)
        << "seed " << kSeed;
    EXPECT_GT(A.determinant(), 0.0);
  }
}

TEST(Tangents, OfBallsInOneLayerDoNotJumpWithARounding) {
  // Balls on a floor have normals with n_z = ± a rounding, one after the other in the same contact:
  // impulses of the step before are in the axes of tangents.
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.3 + 0.5 * k, off = 1e-15;
    Vec3 up1, up2, down1, down2;
    tangents(Vec3(std::cos(angle), std::sin(angle), off), up1, up2);
    tangents(Vec3(std::cos(angle), std::sin(angle), -off), down1, down2);
    // The formula's derivative by n_z is at most 2 there.
    EXPECT_LE((up1 - down1).norm(), 4.0 * off + 1e-15);
    EXPECT_LE((up2 - down2).norm(), 4.0 * off + 1e-15);
  }
}

TEST(RotationMatrix, IsARotationForQuaternionsOfAnyNorm) {
  // As they occur at the stages of a step; it is that of the unit quaternion along them.
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const double norm : {1.0, 1.0 + 1e-15, 1.0 - 1e-9, 1.0 + 1e-6, 1.001, 0.3, 2.0}) {
    Eigen::Vector4d p(uniform(random), uniform(random), uniform(random), uniform(random));
    p.normalize();
    const Mat3 ofUnit = rotationMatrix(p.data());
    p *= norm;
    const Mat3 A = rotationMatrix(p.data());
    // Sums of four products of parts up to 1, and 2/|p|².
    EXPECT_LE((A.transpose() * A - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-14) << norm;
    EXPECT_LE((A - ofUnit).cwiseAbs().maxCoeff(), 1e-14) << norm;
  }
  // That of a body that is not there, as an absent grain.
  const Eigen::Vector4d none = Eigen::Vector4d::Zero();
  EXPECT_EQ(rotationMatrix(none.data()), Mat3::Identity());
}

}  // namespace
}  // namespace dynamy
