/// The measure of the FCLIB collection, written down from its definition: no line is shared with
/// the solvers, W is never formed.
///
///   v = M⁻¹ (H r + f),  u = Hᵀ v + w      (global)        u = W r + q      (local)
///   û_c = u_c + μ_c |u_T,c| e_n,   F_c = r_c − P_K(r_c − û_c),   √(Σ|F_c|²) / |q|
#pragma once
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <dynamy/io/fclib/fclib_file.hpp>

namespace dynamy {

/// Nearest point of K = {|x_T| ≤ μ x_n}, by the three cases of the cone, its polar and between.
inline Eigen::VectorXd nearestOfCone(double mu, const Eigen::VectorXd& x) {
  const double n = x[0], t = x.tail(x.size() - 1).norm();
  if (t <= mu * n) return x;
  Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
  if (n <= -mu * t) return y;
  // Foot on the ray (1, μ)/√(1 + μ²) in the half plane of x.
  const double along = (n + mu * t) / std::sqrt(1.0 + mu * mu);
  y[0] = along / std::sqrt(1.0 + mu * mu);
  y.tail(x.size() - 1) = x.tail(x.size() - 1) * (mu * y[0] / t);
  return y;
}

/// Nearest point of {|x_T| ≤ μ x_n, |x_M| ≤ μ_r x_n}, rows n, t1, t2, m1, m2: the distance is
/// convex in x_n; golden section would do, bisection on its derivative is sharper.
inline Eigen::VectorXd nearestOfRollingCone(double mu, double muRolling, const Eigen::VectorXd& x) {
  const double t = x.segment(1, 2).norm(), m = x.segment(3, 2).norm();
  const auto slope = [&](double n) {
    return n - x[0] - mu * std::max(0.0, t - mu * n) - muRolling * std::max(0.0, m - muRolling * n);
  };
  Eigen::VectorXd y = Eigen::VectorXd::Zero(5);
  if (slope(0.0) >= 0.0) return y;
  double low = 0.0, high = std::abs(x[0]) + mu * t + muRolling * m;
  for (int k = 0; k < 200; ++k) (slope(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
  y[0] = high;
  y.segment(1, 2) = x.segment(1, 2) * (t > mu * high ? mu * high / t : 1.0);
  y.segment(3, 2) = x.segment(3, 2) * (m > muRolling * high ? muRolling * high / m : 1.0);
  return y;
}

inline double fclibResidual(const FclibProblem& p, const Eigen::VectorXd& r) {
  Eigen::VectorXd u, q;
  if (p.global) {
    Eigen::SparseMatrix<double> M = p.M;
    M.makeCompressed();
    Eigen::SparseLU<Eigen::SparseMatrix<double>> inverse(M);
    const Eigen::VectorXd Hr = p.H * r, load = Hr + p.f, v = inverse.solve(load),
                          vFree = inverse.solve(p.f);
    u = p.H.transpose() * v + p.w;
    q = p.H.transpose() * vFree + p.w;
  } else {
    u = p.W * r + p.q;
    q = p.q;
  }
  double sum = 0.0;
  for (int c = 0; c < p.contacts(); ++c) {
    const Eigen::VectorXd rc = r.segment(c * p.dim, p.dim);
    Eigen::VectorXd shifted = u.segment(c * p.dim, p.dim);
    if (p.dim == 5) {
      shifted[0] +=
          p.mu[c] * shifted.segment(1, 2).norm() + p.muRolling[c] * shifted.segment(3, 2).norm();
      sum += (rc - nearestOfRollingCone(p.mu[c], p.muRolling[c], rc - shifted)).squaredNorm();
      continue;
    }
    shifted[0] += p.mu[c] * shifted.tail(p.dim - 1).norm();
    sum += (rc - nearestOfCone(p.mu[c], rc - shifted)).squaredNorm();
  }
  return std::sqrt(sum) / q.norm();
}

}  // namespace dynamy
