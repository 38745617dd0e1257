/// MirrorPlane: a plane of which elements may be their own mirror image. Where all elements of a model
/// and its start are, the motion stays in the plane (theory 39.10).
#pragma once
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/types.hpp>

namespace dynamy {

class Topology;

struct MirrorPlane {
  Vec3 n = Vec3::UnitY();  ///< unit normal
  double c = 0.0;          ///< n·r of its points [m]
  /// Of all bodies, before the model is built, for elements that name them; null: in axes of a body.
  Topology* topology = nullptr;

  /// The same plane in the axes K of a body with origin r_OB_I.
  MirrorPlane in(const Vec3& r_OB_I, const Mat3& A_IK) const {
    return {A_IK.transpose() * n, c - n.dot(r_OB_I)};
  }
  // Each of these takes the rounding of a few turns for zero, and nothing more.
  bool contains(const Vec3& r) const {
    return std::abs(n.dot(r) - c) <= kRounded * (r.norm() + std::abs(c));
  }
  bool isAlong(const Vec3& v) const { return std::abs(n.dot(v)) <= kRounded * v.norm(); }
  bool isNormal(const Vec3& v) const { return (v - n.dot(v) * n).norm() <= kRounded * v.norm(); }

 private:
  static constexpr double kRounded = 16.0 * kEpsilon;
};

}  // namespace dynamy
