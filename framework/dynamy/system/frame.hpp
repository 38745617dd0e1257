/// Frame: a point S with axes K on a mechanical system, its velocities and Jacobians.
///
///   v_S = J_S u + ν_S,   Ω = J_R u + ν_R,   v̇_S = J_S u̇ + β_S,   Ω̇ = J_R u̇ + β_R
///
/// All components are given in the axes of I.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

struct Frame {
  Vec3 r_OS_I = Vec3::Zero();    ///< position of S [m]
  Mat3 A_IK = Mat3::Identity();  ///< v_I = A_IK v_K
  Vec3 v_S_I = Vec3::Zero();     ///< velocity of S [m/s]
  Vec3 Omega_I = Vec3::Zero();   ///< angular velocity of K [rad/s]
  Vec3 nu_S_I = Vec3::Zero();    ///< part of v_S not from u: driven frames, ∂r/∂t
  Vec3 nu_R_I = Vec3::Zero();    ///< part of Ω not from u
  Vec3 bias_S_I = Vec3::Zero();  ///< β_S = J̇_S u + ν̇_S [m/s²]
  Vec3 bias_R_I = Vec3::Zero();  ///< β_R = J̇_R u + ν̇_R [rad/s²]
  Mat3X J_S_I{nullptr, 3,
              0};  ///< 3 × nu of the block; memory belongs to the workspace; zero at first
  Mat3X J_R_I{nullptr, 3, 0};  ///< 3 × nu
  /// The centre of mass of a free body with its own axes: J_S = (I, 0), J_R = (0, A_IK).
  bool central = false;
  bool absent = false;   ///< the body takes no part at present: nothing touches it
  bool outside = false;  ///< the system is left out of this evaluation (SystemSubset)
  int block = -1;        ///< mass block the frame moves with, −1: none (ground)
  int u0 = 0;            ///< first velocity of that block in u

  /// True: the body rests while others move. Its place is known, and what moves may touch it.
  bool rests() const { return outside && !absent; }
  int nu() const { return static_cast<int>(J_S_I.cols()); }
  /// Velocity of the body point at lever arm rho_I from S.
  Vec3 velocity(const Vec3& rho_I) const { return v_S_I + Omega_I.cross(rho_I); }
};

}  // namespace dynamy
