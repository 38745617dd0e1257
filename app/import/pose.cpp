#include "import/pose.hpp"

#include <Eigen/Geometry>

namespace dynamy::app {

Mat3 turned(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

Mat3 rollPitchYaw(const Vec3& angles) {
  return turned(Vec3::UnitZ(), angles.z()) * turned(Vec3::UnitY(), angles.y()) *
         turned(Vec3::UnitX(), angles.x());
}

Mat3 fromQuaternion(double w, double x, double y, double z) {
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

Mat3 zAlong(const Vec3& direction) {
  return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), direction).toRotationMatrix();
}

Eigen::Vector4d quaternionOf(const Mat3& A) {
  Eigen::Quaterniond p(A);
  p.normalize();
  const double sign = p.w() < 0.0 ? -1.0 : 1.0;
  return sign * Eigen::Vector4d(p.w(), p.x(), p.y(), p.z());
}

}  // namespace dynamy::app
