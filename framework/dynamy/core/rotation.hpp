/// Rotations: unit quaternions p = (w, x, y, z) ↔ matrices A_IK; advance by the exact rotation.
///
///   p ← p ∘ exp(½ Δt K_Ω)        (body-fixed rate Ω constant over Δt)
///
/// Adding Δt ṗ and normalising was rejected: it loses an order. Renormalising the
/// product against rounding is allowed.
#pragma once
#include <cmath>
#include <dynamy/core/types.hpp>
#include <limits>

namespace dynamy {

/// sin(x)/x with the series near zero.
inline double sinc(double x) {
  const double x2 = x * x;
  return x2 < 1e-6 ? 1.0 - x2 / 6.0 + x2 * x2 / 120.0 : std::sin(x) / x;
}

/// Cross-product matrix: skew(a) b = a × b.
inline Mat3 skew(const Vec3& a) {
  Mat3 S;
  S << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return S;
}

/// Quaternions whose squared norm is this near to 1 are unit ones: rounding of their products.
inline constexpr double kUnitNorm = 4.0 * std::numeric_limits<double>::epsilon();

/// Matrix A_IK of the quaternion p (w, x, y, z): v_I = A_IK v_K. It is a rotation for every p ≠ 0:
/// stages of a step have quaternions whose norm is 1 up to the error of the step. p = 0: identity.
inline Mat3 rotationMatrix(const double* p) {
  const double w = p[0], x = p[1], y = p[2], z = p[3];
  const double square = w * w + x * x + y * y + z * z;
  const bool unit = std::abs(square - 1.0) < kUnitNorm || square == 0.0;
  const double k = unit ? 2.0 : 2.0 / square;
  Mat3 A;
  A << 1 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y),  //
      k * (x * y + w * z), 1 - k * (x * x + z * z), k * (y * z - w * x),   //
      k * (x * z - w * y), k * (y * z + w * x), 1 - k * (x * x + y * y);
  return A;
}

/// p ← p ∘ exp(½ theta_K), theta_K the rotation vector in body components [rad]; unit norm is kept
/// to rounding.
inline void rotate(double* p, const Vec3& theta_K) {
  const double half = 0.5 * theta_K.norm();
  const Vec3 v = 0.5 * sinc(half) * theta_K;
  const double c = std::cos(half), w = p[0], x = p[1], y = p[2], z = p[3];
  p[0] = w * c - x * v.x() - y * v.y() - z * v.z();
  p[1] = w * v.x() + x * c + y * v.z() - z * v.y();
  p[2] = w * v.y() - x * v.z() + y * c + z * v.x();
  p[3] = w * v.z() + x * v.y() - y * v.x() + z * c;
  const double scale = 1.0 / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]);
  for (int i = 0; i < 4; ++i) p[i] *= scale;
}

/// Tangent T of the exponential map: exp(θ + δ) = exp(θ) exp(T δ) to first order in δ,
/// T = I − (1 − cos θ)/θ² θ~ + (θ − sin θ)/θ³ θ~².
inline Mat3 rotationTangent(const Vec3& theta) {
  const double square = theta.squaredNorm(), half = 0.5 * std::sqrt(square), s = sinc(half);
  const Mat3 S = skew(theta);
  // (θ − sin θ)/θ³. For small θ the difference cancels; the series to θ⁴ is then good to 1e-11.
  const double c = square < 1e-2 ? (1.0 - square / 20.0 * (1.0 - square / 42.0)) / 6.0
                                 : (1.0 - sinc(2.0 * half)) / square;
  return Mat3::Identity() - 0.5 * s * s * S + c * S * S;
}

/// ṗ = ½ p ∘ (0, K_Ω).
inline void quaternionRate(const double* p, const Vec3& Omega_K, double* pdot) {
  const double w = p[0], x = p[1], y = p[2], z = p[3];
  const double a = Omega_K.x(), b = Omega_K.y(), c = Omega_K.z();
  pdot[0] = 0.5 * (-x * a - y * b - z * c);
  pdot[1] = 0.5 * (w * a + y * c - z * b);
  pdot[2] = 0.5 * (w * b - x * c + z * a);
  pdot[3] = 0.5 * (w * c + x * b - y * a);
}

/// The sign s in the formula of tangents(). The tangents jump where s changes, so that impulses of
/// the step before no longer fit. This is far from n.z = 0, the normals between balls of one layer.
inline double tangentSide(const Vec3& n) { return n.z() > -0.9 ? 1.0 : -1.0; }

/// Two unit vectors t1, t2 that complete the unit normal n to a right-handed frame (n, t1, t2);
/// continuous in n except at n.z = −0.9.
inline void tangents(const Vec3& n, Vec3& t1, Vec3& t2) {
  const double s = tangentSide(n), a = -1.0 / (s + n.z()), b = n.x() * n.y() * a;
  t1 = Vec3(1.0 + s * n.x() * n.x() * a, s * b, -s * n.x());
  t2 = Vec3(b, s + n.y() * n.y() * a, -n.y());
}

/// Unit quaternion of a rotation about `axis` (any length, not zero) by `angle` [rad].
inline void axisQuaternion(const Vec3& axis, double angle, double* p) {
  const Vec3 v = std::sin(0.5 * angle) * axis.normalized();
  p[0] = std::cos(0.5 * angle), p[1] = v.x(), p[2] = v.y(), p[3] = v.z();
}

/// p ∘ r: first r, then p.
inline void quaternionProduct(const double* p, const double* r, double* out) {
  const double w = p[0] * r[0] - p[1] * r[1] - p[2] * r[2] - p[3] * r[3];
  const double x = p[0] * r[1] + p[1] * r[0] + p[2] * r[3] - p[3] * r[2];
  const double y = p[0] * r[2] - p[1] * r[3] + p[2] * r[0] + p[3] * r[1];
  const double z = p[0] * r[3] + p[1] * r[2] - p[2] * r[1] + p[3] * r[0];
  out[0] = w, out[1] = x, out[2] = y, out[3] = z;
}

}  // namespace dynamy
