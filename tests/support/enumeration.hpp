/// All solutions of small problems by trying every state of every contact: no iteration, no line
/// shared with the solvers. What it does not find does not exist.
///
///   LCP:     w = M z + q, 0 ≤ w ⊥ z ≥ 0;  each i has w_i = 0, z_i = 0, or both
///   Coulomb: ξ = G Λ + c, rows (N, T);    each contact is open, sticks, slips forward or backward
#pragma once
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace dynamy::enumeration {

struct Solutions {
  bool decided = true;  ///< false: a state has infinitely many candidates, not looked at
  std::vector<Eigen::VectorXd> all;  ///< z or Λ; vertices of the solution set
};

constexpr double kRankOf = 1e-10;  ///< of matrices with entries of size 1
constexpr double kSlack = 1e-9;  ///< an inequality may be missed by this part of the numbers in it

/// All vertices of the solution set. If there are none, there is no solution: a solution is a
/// non-negative combination of columns of [I −M], so also one of linearly independent ones.
inline Solutions lcp(const Eigen::MatrixXd& M, const Eigen::VectorXd& q) {
  const int n = static_cast<int>(q.size());
  Solutions out;
  const auto accept = [&](const std::vector<int>& a, const Eigen::VectorXd& za) {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
    for (std::size_t k = 0; k < a.size(); ++k) z[a[k]] = za[static_cast<Eigen::Index>(k)];
    const Eigen::VectorXd w = M * z + q, size = M.cwiseAbs() * z.cwiseAbs() + q.cwiseAbs();
    const double large = z.lpNorm<Eigen::Infinity>();
    for (int i = 0; i < n; ++i) {
      if (w[i] < -kSlack * size[i] || z[i] < -kSlack * large) return;
      if (z[i] > kSlack * large && w[i] > kSlack * size[i]) return;
    }
    out.all.push_back(z);
  };
  for (int set = 0; set < (1 << n); ++set) {
    std::vector<int> a, rest;
    for (int i = 0; i < n; ++i) ((set >> i & 1) ? a : rest).push_back(i);
    if (a.empty()) {
      accept(a, Eigen::VectorXd());
      continue;
    }
    Eigen::FullPivLU<Eigen::MatrixXd> lu(M(a, a));
    lu.setThreshold(kRankOf);
    if (lu.isInvertible()) {
      accept(a, lu.solve(-q(a)));
      continue;
    }
    // w_i = z_i = 0 for some more i, so that the columns of a become independent.
    for (int more = 1; more < (1 << rest.size()); ++more) {
      std::vector<int> rows = a;
      for (std::size_t k = 0; k < rest.size(); ++k)
        if (more >> k & 1) rows.push_back(rest[k]);
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
      qr.setThreshold(kRankOf);
      qr.compute(M(rows, a));
      if (qr.rank() == static_cast<Eigen::Index>(a.size())) accept(a, qr.solve(-q(rows)));
    }
  }
  return out;
}

/// Planar Coulomb contacts; rows 2i normal, 2i + 1 tangent.
inline Solutions coulomb(const Eigen::MatrixXd& G, const Eigen::VectorXd& c,
                         const Eigen::VectorXd& mu) {
  enum { open, stick, forward, backward, states };
  const int n = static_cast<int>(mu.size());
  Solutions out;
  for (int code = 0; code < (1 << (2 * n)); ++code) {
    // Λ = P x; the rows `zero` of ξ vanish.
    std::vector<int> zero;
    std::vector<Eigen::VectorXd> columns;
    for (int i = 0; i < n; ++i) {
      const int state = code >> (2 * i) & 3;
      if (state == open) continue;
      zero.push_back(2 * i);
      Eigen::VectorXd N = Eigen::VectorXd::Unit(2 * n, 2 * i);
      if (state == forward) N[2 * i + 1] = -mu[i];
      if (state == backward) N[2 * i + 1] = mu[i];
      columns.push_back(N);
      if (state != stick) continue;
      zero.push_back(2 * i + 1);
      columns.push_back(Eigen::VectorXd::Unit(2 * n, 2 * i + 1));
    }
    Eigen::MatrixXd P(2 * n, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
      P.col(static_cast<Eigen::Index>(k)) = columns[k];
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(2 * n);
    if (!zero.empty()) {
      const Eigen::MatrixXd A = G(zero, Eigen::all) * P;
      Eigen::FullPivLU<Eigen::MatrixXd> lu(A);
      lu.setThreshold(kRankOf);
      const Eigen::VectorXd x = lu.solve(-c(zero));
      if (!lu.isInvertible()) {
        // No candidate, or infinitely many.
        if ((A * x + c(zero)).norm() > 1e-8 * c.norm()) continue;
        out.decided = false;
      }
      Lambda = P * x;
    }
    const Eigen::VectorXd xi = G * Lambda + c;
    const Eigen::VectorXd size = kSlack * (G.cwiseAbs() * Lambda.cwiseAbs() + c.cwiseAbs());
    const double large = kSlack * Lambda.lpNorm<Eigen::Infinity>();
    bool good = true;
    for (int i = 0; i < n && good; ++i) {
      const int N = 2 * i, T = N + 1, state = code >> (2 * i) & 3;
      good = state == open ? xi[N] >= -size[N] : Lambda[N] >= -large;
      if (state == stick) good = good && std::abs(Lambda[T]) <= mu[i] * Lambda[N] + large;
      if (state == forward) good = good && xi[T] >= -size[T];
      if (state == backward) good = good && xi[T] <= size[T];
    }
    if (good) out.all.push_back(Lambda);
  }
  return out;
}

/// The book's complementarity problem of planar friction [glocker_studer2005]: unknowns Λ_N, Λ_R,
/// ξ_L; a third way to write the same laws.
inline void rightLeft(const Eigen::MatrixXd& G, const Eigen::VectorXd& c, const Eigen::VectorXd& mu,
                      Eigen::MatrixXd& M, Eigen::VectorXd& q) {
  const auto n = mu.size();
  const Eigen::VectorXi N = Eigen::VectorXi::LinSpaced(n, 0, static_cast<int>(2 * n - 2)),
                        T = N.array() + 1;
  const Eigen::MatrixXd NN = G(N, N), NT = G(N, T), TN = G(T, N), TT = G(T, T),
                        Mu = mu.asDiagonal(), I = Eigen::MatrixXd::Identity(n, n);
  M.setZero(3 * n, 3 * n), q.setZero(3 * n);
  M.topRows(n) << NN - NT * Mu, NT, 0.0 * I;
  M.middleRows(n, n) << TN - TT * Mu, TT, I;
  M.bottomRows(n) << 2.0 * Mu, -I, 0.0 * I;
  q << c(N), c(T), Eigen::VectorXd::Zero(n);
}
/// Λ of its solution.
inline Eigen::VectorXd ofRightLeft(const Eigen::VectorXd& z, const Eigen::VectorXd& mu) {
  const auto n = mu.size();
  Eigen::VectorXd Lambda(2 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    Lambda[2 * i] = z[i], Lambda[2 * i + 1] = z[n + i] - mu[i] * z[i];
  return Lambda;
}

/// How far (Λ, ξ) misses the laws: largest of the gaps of normal and friction law, over the size of
/// the numbers.
inline double coulombError(const Eigen::MatrixXd& G, const Eigen::VectorXd& c,
                           const Eigen::VectorXd& mu, const Eigen::VectorXd& Lambda) {
  const Eigen::VectorXd xi = G * Lambda + c;
  double worst = 0.0;
  for (Eigen::Index i = 0; i < mu.size(); ++i) {
    const double N = Lambda[2 * i], T = Lambda[2 * i + 1], v = xi[2 * i + 1];
    worst = std::max(worst, std::abs(std::min(N, xi[2 * i])));
    worst = std::max(worst, std::abs(T) - mu[i] * std::max(N, 0.0));
    // Slip: the friction that is missing to the limit, or the velocity.
    worst = std::max(worst, std::min(std::abs(v), mu[i] * N + (v > 0.0 ? T : -T)));
  }
  return worst;
}

}  // namespace dynamy::enumeration
