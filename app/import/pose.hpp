/// Pose of a frame K in a frame P, as files of machines state it: r_PK in axes of P, and A_PK.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy::app {

struct Pose {
  Vec3 r = Vec3::Zero();      ///< origin [m]
  Mat3 A = Mat3::Identity();  ///< axes

  Vec3 point(const Vec3& p) const { return r + A * p; }
  Pose operator*(const Pose& next) const { return {point(next.r), A * next.A}; }
  Pose inverse() const { return {-(A.transpose() * r), A.transpose()}; }
};

/// Rotation about the unit vector `axis` by `angle` [rad].
Mat3 turned(const Vec3& axis, double angle);

/// Rotation by angles about the fixed axes x, then y, then z [rad]: "rpy" of URDF and SDF.
Mat3 rollPitchYaw(const Vec3& angles);

/// Rotation of the quaternion w x y z, normalised here; \pre it is not zero.
Mat3 fromQuaternion(double w, double x, double y, double z);

/// The smallest rotation that turns the unit vector z into `direction`; \pre that is not zero.
Mat3 zAlong(const Vec3& direction);

/// Quaternion w x y z of a rotation, w >= 0.
Eigen::Vector4d quaternionOf(const Mat3& A);

}  // namespace dynamy::app
