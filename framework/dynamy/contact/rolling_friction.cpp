// Two discs over one normal force. Projection x of z onto K: with n = x_N,
//   min ½ (n − z_N)² + ½ Σ_b max(0, |z_b| − μ_b n)²,   n ≥ 0
// whose derivative n − z_N − Σ_{b outside} μ_b (|z_b| − μ_b n) is monotone and piecewise linear.
#include <algorithm>
#include <cmath>
#include <dynamy/contact/rolling_friction.hpp>

namespace dynamy {
namespace {

constexpr int kRows = 5;
int first(int disc) { return 1 + 2 * disc; }

/// x ← nearest point of the disc; returns |x| before.
double projectDisc(double radius, double* x) {
  const double length = std::hypot(x[0], x[1]);
  if (length > radius) {
    const double q = radius / length;
    x[0] *= q, x[1] *= q;
  }
  return length;
}

void projectCone(const double* mu, double* z) {
  const double length[2] = {std::hypot(z[1], z[2]), std::hypot(z[3], z[4])};
  // n for every choice of discs that z leaves; the right one confirms its choice.
  double n = z[0];
  for (int choice = 0; choice < 4; ++choice) {
    double weight = 1.0, sum = z[0];
    for (int b = 0; b < 2; ++b)
      if (choice & (1 << b)) weight += mu[b] * mu[b], sum += mu[b] * length[b];
    const double trial = sum / weight;
    bool right = true;
    for (int b = 0; b < 2; ++b)
      right = right && ((choice & (1 << b)) != 0) == (length[b] > mu[b] * trial);
    if (right) n = trial;
  }
  z[0] = std::max(0.0, n);
  for (int b = 0; b < 2; ++b) projectDisc(mu[b] * z[0], z + first(b));
}

}  // namespace

void UnilateralRolling::project(const LawInput&, double N, const double*, int, double* x) const {
  for (int b = 0; b < 2; ++b) projectDisc(mu_[b] * std::max(N, 0.0), x + 2 * b);
}

double UnilateralRolling::support(const LawInput&, int k, const double* y, double* gradient,
                                  double* hessian) const {
  if (hessian) std::fill(hessian, hessian + k * k, 0.0);
  double S = 0.0;
  for (int b = 0; b < 2; ++b) {
    const double *v = y + 2 * b, length = std::hypot(v[0], v[1]);
    S += mu_[b] * length;
    const double e[2] = {length > 0.0 ? v[0] / length : 0.0, length > 0.0 ? v[1] / length : 0.0};
    for (int i = 0; i < 2; ++i) {
      if (gradient) gradient[2 * b + i] = mu_[b] * e[i];
      for (int j = 0; hessian && length > 0.0 && j < 2; ++j)
        hessian[(2 * b + i) * k + 2 * b + j] =
            mu_[b] / length * ((i == j ? 1.0 : 0.0) - e[i] * e[j]);
    }
  }
  return S;
}

void UnilateralRolling::naturalMap(const LawInput&, double rho, const double* xi,
                                   const double* Lambda, double* e) const {
  double z[kRows];
  const double shift = mu_[0] * std::hypot(xi[1], xi[2]) + mu_[1] * std::hypot(xi[3], xi[4]);
  for (int i = 0; i < kRows; ++i) z[i] = Lambda[i] - rho * (xi[i] + (i == 0 ? shift : 0.0));
  projectCone(mu_, z);
  for (int i = 0; i < kRows; ++i) e[i] = Lambda[i] - z[i];
}

bool UnilateralRolling::proxDerivative(const LawInput&, double rho, const double* xi,
                                       const double* Lambda, double* A, double* B) const {
  Eigen::Map<Eigen::Matrix<double, kRows, kRows, Eigen::RowMajor>> a(A), b(B);
  double z[kRows];
  for (int i = 0; i < kRows; ++i) z[i] = Lambda[i] - rho * xi[i];
  a.setIdentity(), b.setZero();
  if (!(z[0] > 0.0)) return true;
  // P = ∂p/∂z into b, then A = I − P and B = ρ P.
  b(0, 0) = 1.0;
  for (int d = 0; d < 2; ++d) {
    const int k = first(d);
    const double radius = mu_[d] * z[0], length = std::hypot(z[k], z[k + 1]);
    if (length <= radius) {
      b(k, k) = b(k + 1, k + 1) = 1.0;
      continue;
    }
    const Eigen::Vector2d e(z[k] / length, z[k + 1] / length);
    b.block<2, 2>(k, k) = radius / length * (Eigen::Matrix2d::Identity() - e * e.transpose());
    b.block<2, 1>(k, 0) = mu_[d] * e;
  }
  a -= b;
  b *= rho;
  return true;
}

}  // namespace dynamy
