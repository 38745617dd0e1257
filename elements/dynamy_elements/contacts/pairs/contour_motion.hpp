/// Velocity of the point of contact over the surface of a body, by the angular velocities.
#pragma once
#include <cmath>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

/// The velocity of the point of contact over the body B has the components c_i·(Ω_B − Ω_A) along
/// the tangents t_i. With H = ∇²h of B's feature, n of the half space A and K = A_B H A_Bᵀ
///
///   ẋ = K ((Ω_B − Ω_A) × n)   ⇒   c_i = n × K t_i
struct ContourMotion {
  Vec3 c[2], cdot[2];
  /// `rates`: fills ċ.
  ContourMotion(const SupportFeature& feature, const Frame& A, const Frame& B,
                const ContactPoint& at, bool rates) {
    const Vec3 &n = at.d[0], d_B = -(B.A_IK.transpose() * n);
    const Mat3 H = feature.pointDerivative(d_B), K = B.A_IK * H * B.A_IK.transpose();
    for (int i = 0; i < 2; ++i) c[i] = n.cross(K * at.d[1 + i]);
    if (!rates) return;
    const Vec3 turn = A.Omega_I - B.Omega_I, ddot_B = -(B.A_IK.transpose() * turn.cross(n));
    const Mat3 Hdot = curvatureRate(feature, d_B, ddot_B);
    for (int i = 0; i < 2; ++i) {
      // d/dt (A_B H A_Bᵀ t)
      const Vec3& t = at.d[1 + i];
      const Vec3 tdot_B = B.A_IK.transpose() * (at.ddot[1 + i] - B.Omega_I.cross(t));
      const Vec3 rate =
          B.Omega_I.cross(K * t) + B.A_IK * (Hdot * (B.A_IK.transpose() * t) + H * tdot_B);
      cdot[i] = at.ddot[0].cross(K * t) + n.cross(rate);
    }
  }
  /// Ḣ by finite differences of fourth order; their error is 1e-12 of its size.
  static Mat3 curvatureRate(const SupportFeature& feature, const Vec3& d, const Vec3& ddot) {
    constexpr double kStep = 2e-4;  // [rad]
    const double speed = ddot.norm();
    if (!(speed > 0.0)) return Mat3::Zero();
    const auto at = [&](double angle) {
      return feature.pointDerivative((std::cos(angle) * d + std::sin(angle) / speed * ddot));
    };
    return speed / (12.0 * kStep) *
           (8.0 * (at(kStep) - at(-kStep)) - (at(2.0 * kStep) - at(-2.0 * kStep)));
  }
};

}  // namespace dynamy
