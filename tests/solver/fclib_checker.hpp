/// The measure of the FCLIB collection, written down from its definition: no line is shared with
/// the solvers, W is never formed.
///
///   v = M⁻¹ (H r + f),  u = Hᵀ v + w      (global)        u = W r + q      (local)
///   û_c = u_c + μ_c |u_T,c| e_n,   F_c = r_c − P_K(r_c − û_c),   √(Σ|F_c|²) / |q|
#pragma once
#include <Eigen/SparseLU>
#include <cmath>
#include <dynamy/io/fclib_file.hpp>

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
    shifted[0] += p.mu[c] * shifted.tail(p.dim - 1).norm();
    sum += (rc - nearestOfCone(p.mu[c], rc - shifted)).squaredNorm();
  }
  return std::sqrt(sum) / q.norm();
}

}  // namespace dynamy
