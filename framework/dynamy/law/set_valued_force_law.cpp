// Defaults of the force laws, and the projection onto a reservoir that is known by its support
// function alone:
//   prox: Λ_N = max(0, z_N),   Λ_T = argmin { (z_T − x)ᵀ R⁻¹ (z_T − x) : x ∈ Λ_N B },   z = Λ − R ξ
//   dual: min ½ νᵀRν + N S_B(ν) − zᵀν,   x = z − R ν
// The dual is smooth away from ν = 0 and needs neither a parametrisation nor a distance of B. A
// projection by successive support points (Frank–Wolfe) was rejected: it converges like 1/k.
#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {
namespace {

/// Least part of a Newton step. On a hyperbola with axes in the ratio s a step overshoots by s³, so that
/// 1/s² of it is right.
constexpr double kLeastStep = 1e-14;

constexpr int kMaxReservoir = kMostRows - 1;

using ReservoirVec = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxReservoir, 1>;
using ReservoirMat = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor,
                                   kMaxReservoir, kMaxReservoir>;

/// f(ν) = ½ νᵀRν + N S_B(ν) − zᵀν with gradient and Newton step.
struct Dual {
  const NormalTimesReservoir& law;
  const LawInput& in;
  double N;
  const ReservoirVec& R;
  const ReservoirVec& z;
  ReservoirVec residual = z;  ///< Rν + N ∇S_B − z

  double S(const ReservoirVec& nu) const { return law.support(in, size(), nu.data()); }
  double value(const ReservoirVec& nu) const {
    return 0.5 * nu.dot(R.cwiseProduct(nu)) + N * S(nu) - z.dot(nu);
  }
  ReservoirVec newtonStep(const ReservoirVec& nu) {
    ReservoirVec gradient(size());
    ReservoirMat A(size(), size());
    law.support(in, size(), nu.data(), gradient.data(), A.data());
    A *= N;
    A.diagonal() += R;
    residual = R.cwiseProduct(nu) + N * gradient - z;
    return -A.partialPivLu().solve(residual);
  }
  /// Newton's step for R + N²/t ∇²(½ S_B²), t = N S_B(ν): the majorant ½ (t + N² S_B²/t) of N S_B touches it
  /// at ν, and is quadratic for an ellipsoid. Called after newtonStep(ν).
  ReservoirVec majorantStep(const ReservoirVec& nu) const {
    ReservoirVec gradient(size());
    ReservoirMat A(size(), size());
    const double S = law.support(in, size(), nu.data(), gradient.data(), A.data());
    A = N * A + N / S * gradient * gradient.transpose();
    A.diagonal() += R;
    return -A.partialPivLu().solve(residual);
  }
  /// Turns ν until it separates z from N B, zᵀν > N S_B(ν); false: there is no such ν, z ∈ N B.
  /// Newton's method for the convex problem min ½ (N S_B(ν))² on the plane zᵀν = 1. The square of an
  /// ellipsoid's support is quadratic: one step, however different its axes are. S_B itself is a
  /// hyperbola there, on which steps overshoot by the square of their distance from the minimum.
  bool separate(ReservoirVec& nu) const {
    // A point outside by less than this part of its length counts as inside: rounding.
    constexpr double kMargin = 1e-13;
    ReservoirVec g(size());
    ReservoirMat A(size(), size());
    nu /= z.dot(nu);
    for (int step = 0; step < 50; ++step) {
      const double NS = N * law.support(in, size(), nu.data(), g.data(), A.data());
      if (NS < 1.0 - kMargin) return true;
      A = N * NS * A + N * N * g * g.transpose();
      g *= N * NS;
      const Eigen::PartialPivLU<ReservoirMat> lu(A);
      const ReservoirVec Ag = lu.solve(g), Az = lu.solve(z);
      const ReservoirVec delta = Az * (z.dot(Ag) / z.dot(Az)) - Ag;
      const double slope = g.dot(delta), least = NS * NS;
      if (!(slope < -1e-15 * least)) return false;
      const auto square = [&](double theta) {
        const double at = N * S(nu + theta * delta);
        return at * at;
      };
      double theta = 1.0;
      while (theta > kLeastStep && !(square(theta) < least + 2e-4 * theta * slope)) theta *= 0.5;
      if (theta <= kLeastStep) return false;
      nu += theta * delta;
    }
    return false;
  }
  int size() const { return static_cast<int>(z.size()); }
};

}  // namespace

std::string_view statusText(Status status) {
  switch (status) {
    case Status::open:
      return "open";
    case Status::separating:
      return "separating";
    case Status::stick:
      return "stick";
    case Status::slip:
      return "slip";
    case Status::lower:
      return "lower";
    case Status::upper:
      return "upper";
    case Status::locked:
      return "locked";
  }
  return "unknown";
}

namespace {

/// Projection onto N·B. If squares of its numbers would overflow or vanish, the numbers are divided
/// by the largest, which is admissible because the cone is the same in every unit.
void projectAnySize(const NormalTimesReservoir& law, const LawInput& in, double N, const double* r,
                    int k, double* x) {
  constexpr double kSmall = 1e-140, kLarge = 1e140;
  double unit = N;
  for (int i = 0; i < k; ++i) unit = std::max(unit, std::abs(x[i]));
  if ((unit >= kSmall && unit <= kLarge) || !(unit > 0.0) || !std::isfinite(unit))
    return law.project(in, N, r, k, x);
  for (int i = 0; i < k; ++i) x[i] /= unit;
  law.project(in, N / unit, r, k, x);
  for (int i = 0; i < k; ++i) x[i] *= unit;
}

}  // namespace

void SetValuedForceLaw::epsilon(int dim, double* epsilon) const {
  std::fill(epsilon, epsilon + dim, 0.0);
}

void SetValuedForceLaw::naturalMap(const LawInput& in, double rho, const double* xi,
                                   const double* Lambda, double* e) const {
  assert(in.dim <= kMostRows);
  double r[kMostRows], p[kMostRows];
  std::fill(r, r + in.dim, rho);
  std::copy(Lambda, Lambda + in.dim, p);
  prox(in, r, xi, p);
  for (int i = 0; i < in.dim; ++i) e[i] = Lambda[i] - p[i];
}

bool SetValuedForceLaw::proxDerivative(const LawInput&, double, const double*, const double*,
                                       double*, double*) const {
  return false;
}

void NormalTimesReservoir::prox(const LawInput& in, const double* r, const double* xi,
                                double* Lambda) const {
  for (int i = 0; i < in.dim; ++i) Lambda[i] -= r[i] * xi[i];
  Lambda[0] = std::max(Lambda[0], 0.0);
  if (in.dim > 1) projectAnySize(*this, in, Lambda[0], r + 1, in.dim - 1, Lambda + 1);
}

Status NormalTimesReservoir::status(const LawInput& in, const double* argument) const {
  if (!(argument[0] > 0.0)) return Status::separating;
  if (in.dim == 1) return Status::slip;
  double unit[kMostRows], x[kMostRows];
  const int k = in.dim - 1;
  std::fill(unit, unit + k, 1.0);
  std::copy(argument + 1, argument + 1 + k, x);
  project(in, argument[0], unit, k, x);
  return std::equal(x, x + k, argument + 1) ? Status::stick : Status::slip;
}

void NormalTimesReservoir::project(const LawInput& in, double N, const double* r, int k,
                                   double* x) const {
  assert(k <= kMaxReservoir);
  Eigen::Map<Eigen::VectorXd> out(x, k);
  if (!(N > 0.0)) {
    out.setZero();
    return;
  }
  const ReservoirVec z = out, R = Eigen::Map<const Eigen::VectorXd>(r, k);
  if (!(z.norm() > 0.0)) return;  // 0 lies in every reservoir
  Dual dual{*this, in, N, R, z};
  ReservoirVec nu = z.cwiseQuotient(R);
  if (!dual.separate(nu)) return;  // inside

  // Each step must reduce f: a Newton step that reduces it as its slope promises, or else a step to the
  // minimum of a majorant, doubled as long as that helps.
  constexpr int kMaxSteps = 100;
  constexpr double kNear = 1e-7, kSolved = 1e-15, kPromised = 0.1;
  nu *= (z.dot(nu) - N * dual.S(nu)) / nu.dot(R.cwiseProduct(nu));
  double value = dual.value(nu);
  for (int step = 0; step < kMaxSteps; ++step) {
    ReservoirVec delta = dual.newtonStep(nu);
    if (dual.residual.norm() <= kNear * z.norm()) break;
    double theta = 1.0, next = dual.value(nu + delta);
    if (!(next < value + kPromised * dual.residual.dot(delta))) {
      delta = dual.majorantStep(nu);
      next = dual.value(nu + delta);
      while (theta > kLeastStep && !(next < value))
        theta *= 0.5, next = dual.value(nu + theta * delta);
      if (theta <= kLeastStep) break;
      for (double more = 0.0; theta >= 1.0; theta *= 2.0, next = more) {
        more = dual.value(nu + 2.0 * theta * delta);
        if (!(more < next)) break;
      }
    }
    nu += theta * delta, value = next;
  }

  // Full Newton steps near the solution: f no longer resolves the last half of the digits, but its
  // gradient does.
  for (int step = 0; step < 4; ++step) {
    const ReservoirVec trial = nu + dual.newtonStep(nu);
    const double before = dual.residual.norm();
    if (before <= kSolved * z.norm()) break;
    dual.newtonStep(trial);
    if (!(dual.residual.norm() < before)) break;
    nu = trial;
  }
  out = z - R.cwiseProduct(nu);
}

bool NormalTimesReservoir::proxDerivative(const LawInput& in, double rho, const double* xi,
                                          const double* Lambda, double* A, double* B) const {
  const int n = in.dim, k = n - 1;
  Eigen::Map<RowMatrix> a(A, n, n), b(B, n, n);
  a.setIdentity();
  b.setZero();
  double z[kMostRows], x[kMostRows], r[kMostRows];
  for (int i = 0; i < n; ++i) z[i] = x[i] = Lambda[i] - rho * xi[i];
  std::fill(r, r + n, rho);
  if (!(z[0] > 0.0)) return true;
  // P = ∂p/∂z, A = I − P, B = ρ P.
  a(0, 0) = 0.0, b(0, 0) = rho;
  if (k == 0) return true;
  project(in, z[0], r, k, x + 1);
  ReservoirVec nu(k), gradient(k);
  for (int i = 0; i < k; ++i) nu[i] = (z[1 + i] - x[1 + i]) / rho;
  if (!(nu.norm() > 0.0)) {
    a.bottomRightCorner(k, k).setZero();
    b.bottomRightCorner(k, k).diagonal().setConstant(rho);
    return true;
  }
  ReservoirMat hessian(k, k);
  support(in, k, nu.data(), gradient.data(), hessian.data());
  ReservoirMat M = z[0] * hessian;
  M.diagonal().array() += rho;
  const ReservoirMat RA = rho * M.partialPivLu().inverse();
  const ReservoirVec size = RA * gradient;
  a.bottomRightCorner(k, k) = RA;
  b.bottomRightCorner(k, k) = rho * (ReservoirMat::Identity(k, k) - RA);
  a.bottomLeftCorner(k, 1) = -size;
  b.bottomLeftCorner(k, 1) = rho * size;
  return true;
}

}  // namespace dynamy
