/// Small contact problems in the layout of FCLIB, made from bodies: numbers that this project may
/// keep in its tree, of the kinds that the collection has.
#pragma once
#include <Eigen/LU>
#include <cmath>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <map>
#include <random>
#include <string>

namespace dynamy {

/// Wᵀ of a body (linear and angular velocity) at the point `a` for the normal z: rows n, t1, t2.
inline Eigen::Matrix<double, 3, 6> contactRows(const Eigen::Vector3d& a, double sign) {
  const Eigen::Vector3d direction[3] = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(),
                                        Eigen::Vector3d::UnitY()};
  Eigen::Matrix<double, 3, 6> out;
  for (int k = 0; k < 3; ++k) {
    out.row(k).head<3>() = sign * direction[k];
    out.row(k).tail<3>() = sign * a.cross(direction[k]);
  }
  return out;
}

/// n unit cubes on each other, four contacts each (rank deficient), mass 1 times `ratio` a storey
/// upward; gravity 9.81 down and `pull` 9.81 along x, over a step of 1 ms. Global form.
inline FclibProblem boxStack(int n, double ratio, double mu, double pull) {
  FclibProblem p;
  p.global = true, p.dim = 3, p.title = "stack of cubes";
  p.description = "own scene, from formulas";
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(6 * n, 6 * n),
                  Ht = Eigen::MatrixXd::Zero(12 * n, 6 * n);
  p.f.setZero(6 * n);
  double mass = 1.0;
  for (int b = 0; b < n; ++b, mass *= ratio) {
    M.block(6 * b, 6 * b, 3, 3).diagonal().setConstant(mass);
    M.block(6 * b + 3, 6 * b + 3, 3, 3).diagonal().setConstant(mass / 6.0);
    p.f[6 * b + 2] = -9.81e-3 * mass;
    p.f[6 * b] = 9.81e-3 * pull * mass;
    for (int c = 0; c < 4; ++c) {
      const double x = (c & 1) ? 0.5 : -0.5, y = (c & 2) ? 0.5 : -0.5;
      const int row = 12 * b + 3 * c;
      Ht.block<3, 6>(row, 6 * b) = contactRows({x, y, -0.5}, 1.0);
      if (b > 0) Ht.block<3, 6>(row, 6 * (b - 1)) = contactRows({x, y, 0.5}, -1.0);
    }
  }
  p.M = M.sparseView();
  p.H = Eigen::MatrixXd(Ht.transpose()).sparseView();
  p.w.setZero(12 * n);
  p.mu.setConstant(4 * n, mu);
  return p;
}

/// W = L Lᵀ + `skew` · (unsymmetric part) from a seed: n contacts of `dim` rows that feel their
/// `rank` common velocities, most of them closing.
inline FclibProblem randomProblem(int dim, int n, int rank, double mu, double skew, unsigned seed) {
  std::mt19937 random(seed);
  // Not std::normal_distribution: its numbers differ between libraries.
  const auto number = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  FclibProblem p;
  p.dim = dim, p.title = "random contacts";
  p.description = "own numbers, from a seed";
  Eigen::MatrixXd S(dim * n, rank), A(dim * n, dim * n);
  for (double& x : S.reshaped()) x = number();
  for (double& x : A.reshaped()) x = number();
  Eigen::MatrixXd W = S * S.transpose() / rank;
  W += skew * (A - A.transpose()).cwiseProduct(W);
  p.W = W.sparseView();
  // c in the range of W, as a motion of the bodies gives it.
  Eigen::VectorXd v(rank);
  for (double& x : v) x = number();
  p.q = S * v;
  for (int i = 0; i < n; ++i)
    if (i % 4 != 0) p.q[dim * i] = -std::abs(p.q[dim * i]);
  p.mu.setConstant(n, mu);
  return p;
}

/// The problems kept in tests/data/fclib, by file name.
inline std::map<std::string, FclibProblem> keptProblems() {
  std::map<std::string, FclibProblem> out;
  out["stack_3_global"] = boxStack(3, 1.0, 0.5, 0.0);
  out["stack_2_sliding_global"] = boxStack(2, 1.0, 0.3, 0.4);
  out["stack_4_heavy_on_top"] = condensed(boxStack(4, 10.0, 0.5, 0.1));
  out["planar_8"] = randomProblem(2, 8, 20, 0.4, 0.0, 1);
  out["spatial_6_unsymmetric"] = randomProblem(3, 6, 24, 0.5, 1e-4, 2);
  out["one_contact"] = randomProblem(3, 1, 6, 0.7, 0.0, 3);
  return out;
}

}  // namespace dynamy
