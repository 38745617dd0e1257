#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/gyroscopic.hpp>

namespace dynamy {
namespace {

/// Turn per step [rad] below which the velocity at which the gyroscopic term is taken does not
/// matter: the change is this share of a term that is itself Ω²Δt.
constexpr double kHardlyTurns = 1e-8;
constexpr int kMostParts = 100000;

/// Ω after J(Ω^E − Ω^A) = Δt (M − Ω̄ × JΩ̄), by Newton's method; false: no convergence.
bool turnedByMean(const Mat3& J, const Vec3& M, double dt, Vec3& Omega) {
  Vec3 mean = Omega;
  for (int turn = 0; turn < 12; ++turn) {
    const Vec3 L = J * mean;
    const Vec3 rest = J * (mean - Omega) - 0.5 * dt * (M - mean.cross(L));
    const Vec3 d = (J + 0.5 * dt * (skew(mean) * J - skew(L))).inverse() * rest;
    mean -= d;
    // Convergence is quadratic: the error after this correction is below rounding.
    if (!(d.squaredNorm() > 1e-18 * mean.squaredNorm())) {
      Omega = 2.0 * mean - Omega;
      return true;
    }
  }
  return false;
}

}  // namespace

void gyroscopicAtMean(const Mat3& J, const Vec3& Omega, double dt, double* h) {
  const double turn = dt * Omega.norm();
  if (!(turn > kHardlyTurns)) return;
  Eigen::Map<Vec3> moment(h);
  const Vec3 M = moment + Omega.cross(J * Omega);
  for (double parts = std::ceil(turn); parts <= kMostParts; parts *= 2.0) {
    Vec3 end = Omega;
    int done = 0;
    while (done < parts && turnedByMean(J, M, dt / parts, end)) ++done;
    if (done < parts) continue;
    moment = J * (end - Omega) / dt;
    return;
  }
}

}  // namespace dynamy
