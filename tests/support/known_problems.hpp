/// Random contact problems whose solution is known, because it came first: velocities ξ and
/// percussions Λ that fulfil the laws are chosen, then W, then q = ξ − WΛ.
///
///   open      Λ = 0, ξ_N > 0               slips     ξ_N = 0, Λ_T = −μΛ_N ξ_T/|ξ_T|
///   grazing   Λ = 0, ξ_N = 0               sticks    ξ = 0, |Λ_T| < μΛ_N; on the edge |Λ_T| = μΛ_N
///
/// W = S M⁻¹ Sᵀ is positive semidefinite, of any rank. Two sorts are not, and have no known
/// solution: there nothing may crash, and nothing may be called solved that is not.
#pragma once
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <random>
#include <string_view>

namespace dynamy {

struct KnownProblem {
  FclibProblem problem;  ///< local
  Eigen::VectorXd r, u;  ///< a solution; empty: none is known
  bool known() const { return r.size() > 0 || problem.q.size() == 0; }
};

class KnownProblems {
 public:
  enum class Sort {
    regular,       ///< more bodies' velocities than rows
    deficient,     ///< fewer
    frictionless,  ///< μ = 0, or complementarity alone
    rigid,         ///< bodies at rest and in motion that touch at points
    patches,       ///< the same, each contact two to four times: redundant
    masses,        ///< rigid, masses over sixteen decades at most
    units,         ///< any sort above in other units: forces and velocities times 1e-8 … 1e8
    indefinite,
    unsymmetric
  };
  static constexpr int kSorts = 9;
  static std::string_view name(Sort sort) {
    constexpr std::array<std::string_view, kSorts> names{"regular", "deficient",  "frictionless",
                                                         "rigid",   "patches",    "masses",
                                                         "units",   "indefinite", "unsymmetric"};
    return names[static_cast<std::size_t>(sort)];
  }
  static Sort sortOf(unsigned seed) { return static_cast<Sort>(seed % kSorts); }

  /// 0 to 60 contacts; most problems are small.
  explicit KnownProblems(unsigned seed) : random_(seed), sort_(sortOf(seed)) {
    dim_ = whole(0, 2) == 0 ? 2 : 3;
    const double part = number(0.0, 1.0);
    contacts_ = static_cast<int>(60.999 * part * part);
    const Sort made = sort_ != Sort::units ? sort_ : static_cast<Sort>(whole(0, 5));
    if (made == Sort::rigid || made == Sort::patches || made == Sort::masses)
      rigid(made);
    else
      dense(made);
    pose(made);
  }
  KnownProblem take() { return std::move(out_); }

 private:
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;
  // Not the distributions of the library: their numbers differ between libraries.
  double number(double a, double b) {
    return a + (b - a) * static_cast<double>(random_()) / 4294967296.0;
  }
  int whole(int a, int b) {
    return a + static_cast<int>(random_() % static_cast<unsigned>(b - a + 1));
  }
  Vector numbers(int n) {
    Vector x(n);
    for (double& v : x) v = number(-1.0, 1.0);
    return x;
  }
  Matrix matrix(int rows, int columns) {
    Matrix A(rows, columns);
    for (double& v : A.reshaped()) v = number(-1.0, 1.0);
    return A;
  }
  Eigen::Vector3d direction() {
    for (;;) {
      Eigen::Vector3d d = numbers(3);
      if (dim_ == 2) d.z() = 0.0;
      if (d.norm() > 0.1 && d.norm() <= 1.0) return d.normalized();
    }
  }

  // S and ξ of contacts between any velocities; ξ need not be in the range of S.
  void dense(Sort made) {
    if (made == Sort::frictionless && whole(0, 1) == 0) dim_ = 1;
    const int rows = dim_ * contacts_;
    const int rank = made == Sort::regular ? rows + whole(1, 10) : whole(1, std::max(1, rows));
    S_ = matrix(rows, rank) / std::sqrt(static_cast<double>(rank));
    inverseMass_ = Vector::Ones(rank);
    u_ = Vector::Zero(rows);
    mu_ = Vector::Zero(contacts_);
    for (int i = 0; i < contacts_; ++i) {
      if (made != Sort::frictionless) mu_[i] = friction();
      const int state = whole(0, 3);  // open, grazing or pressed
      if (dim_ > 1 && state != 3) u_.segment(dim_ * i + 1, dim_ - 1) = numbers(dim_ - 1);
      if (state == 0) u_[dim_ * i] = number(0.0, 1.0);
    }
  }
  double friction() { return whole(0, 9) == 0 ? 0.0 : number(0.05, 1.2); }

  // Bodies with velocities v; frames of the contacts are such that the laws allow ξ = S v.
  void rigid(Sort made) {
    const int each = dim_ == 2 ? 3 : 6, bodies = whole(1, 8);
    const double decades = made == Sort::masses ? number(0.0, 8.0) : 0.5;
    std::vector<Eigen::Vector3d> centre;
    Vector v(each * bodies);
    inverseMass_.resize(each * bodies);
    for (int b = 0; b < bodies; ++b) {
      const double m = std::pow(10.0, number(-decades, decades));
      const int linear = dim_ == 2 ? 2 : 3;
      inverseMass_.segment(each * b, linear).setConstant(1.0 / m);
      for (int k = linear; k < each; ++k)
        inverseMass_[each * b + k] = 1.0 / (m * number(0.03, 0.3));
      centre.emplace_back(3.0 * direction());
      v.segment(each * b, each) = whole(0, 1) == 0 ? Vector::Zero(each) : numbers(each);
    }
    std::vector<Eigen::RowVectorXd> rows;
    std::vector<double> mu;
    while (static_cast<int>(mu.size()) < contacts_) {
      const int on = whole(0, bodies - 1), by = whole(-1, bodies - 1);
      if (by == on) continue;
      const int copies = made == Sort::patches ? whole(2, 4) : 1;
      const double friction = this->friction();
      const Eigen::Vector3d point = centre[static_cast<std::size_t>(on)] + 0.5 * direction();
      const Eigen::Vector3d apart = velocity(v, centre, on, by, point, each);
      const Frame frame = frameFor(apart);
      for (int c = 0; c < copies && static_cast<int>(mu.size()) < contacts_; ++c) {
        // Of bodies at rest the corners of a face; else at one place, with equal rows.
        const Eigen::Vector3d at = apart.isZero(0.0) && copies > 1
                                       ? Eigen::Vector3d(point + ((c & 1) ? 0.3 : -0.3) * frame[1] +
                                                         ((c & 2) ? 0.3 : -0.3) * frame[2])
                                       : point;
        for (int k = 0; k < dim_; ++k) {
          Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(each * bodies);
          addRow(row, each * on, centre[static_cast<std::size_t>(on)], at, frame[k], 1.0);
          if (by >= 0)
            addRow(row, each * by, centre[static_cast<std::size_t>(by)], at, frame[k], -1.0);
          rows.push_back(row);
        }
        mu.push_back(friction);
      }
    }
    S_.resize(dim_ * contacts_, each * bodies);
    mu_.resize(contacts_);
    for (int r = 0; r < dim_ * contacts_; ++r) S_.row(r) = rows[static_cast<std::size_t>(r)];
    for (int i = 0; i < contacts_; ++i) mu_[i] = mu[static_cast<std::size_t>(i)];
    u_ = S_ * v;
  }
  using Frame = std::array<Eigen::Vector3d, 3>;
  Eigen::Vector3d velocity(const Vector& v, const std::vector<Eigen::Vector3d>& centre, int on,
                           int by, const Eigen::Vector3d& point, int each) const {
    Eigen::Vector3d out = Eigen::Vector3d::Zero();
    for (const auto& [b, sign] : {std::pair{on, 1.0}, std::pair{by, -1.0}}) {
      if (b < 0) continue;
      const Eigen::Vector3d a = point - centre[static_cast<std::size_t>(b)];
      Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
      linear.head(dim_) = v.segment(each * b, dim_);
      if (dim_ == 2)
        angular.z() = v[each * b + 2];
      else
        angular = v.segment(each * b + 3, 3);
      out += sign * (linear + angular.cross(a));
    }
    return out;
  }
  /// Normal across the velocity (slips), or with it (open); any if there is none (sticks).
  Frame frameFor(const Eigen::Vector3d& velocity) {
    Eigen::Vector3d n = direction();
    const double speed = velocity.norm();
    if (speed > 0.0) {
      const Eigen::Vector3d t = velocity / speed;
      if (whole(0, 2) == 0) {
        if (n.dot(t) < 0.0) n = -n;
      } else if (dim_ == 2) {
        n = Eigen::Vector3d(-t.y(), t.x(), 0.0) * (whole(0, 1) == 0 ? 1.0 : -1.0);
      } else {
        n = t.cross(direction());
        while (n.norm() < 0.1) n = t.cross(direction());
        n.normalize();
      }
    }
    if (dim_ == 2) return {n, Eigen::Vector3d(-n.y(), n.x(), 0.0), Eigen::Vector3d::Zero()};
    const Eigen::Vector3d t1 = n.unitOrthogonal();
    return {n, t1, n.cross(t1)};
  }
  void addRow(Eigen::RowVectorXd& row, int at, const Eigen::Vector3d& centre,
              const Eigen::Vector3d& point, const Eigen::Vector3d& d, double sign) const {
    const Eigen::Vector3d turn = (point - centre).cross(d);
    row.segment(at, dim_) += sign * d.head(dim_).transpose();
    if (dim_ == 2)
      row[at + 2] += sign * turn.z();
    else
      row.segment(at + 3, 3) += sign * turn.transpose();
  }

  /// Λ to u_, W, and q = u − W Λ.
  void pose(Sort made) {
    const int rows = dim_ * contacts_;
    Matrix W = S_ * inverseMass_.asDiagonal() * S_.transpose();
    W = 0.5 * (W + W.transpose()).eval();
    // ξ_N of a contact that slides or sticks is a rounding of zero: it is meant to be zero.
    Vector r = Vector::Zero(rows);
    for (int i = 0; i < contacts_; ++i) percussion(W, i, r);
    FclibProblem& p = out_.problem;
    p.dim = dim_, p.title = std::string(name(sort_));
    p.mu = mu_;
    if (dim_ == 1) p.mu.resize(0);
    p.q = u_ - W * r;
    if (made == Sort::indefinite || made == Sort::unsymmetric) {
      const Matrix A = matrix(rows, rows);
      if (made == Sort::indefinite)
        W += number(0.0, 1.0) * (A + A.transpose());
      else
        W += number(0.0, 0.5) * (A - A.transpose());
      r.resize(0), u_.resize(0);
    }
    if (sort_ == Sort::units) {
      const double force = std::pow(10.0, whole(-8, 8)), velocity = std::pow(10.0, whole(-8, 8));
      W *= velocity / force, p.q *= velocity, u_ *= velocity, r *= force;
    }
    p.W = W.sparseView();
    out_.r = r, out_.u = u_;
  }
  void percussion(const Matrix& W, int i, Vector& r) {
    const int first = dim_ * i;
    const double size = W.block(first, first, dim_, dim_).diagonal().maxCoeff();
    double& normal = u_[first];
    if (std::abs(normal) <= 1e-12) normal = 0.0;
    if (normal > 0.0 || whole(0, 4) == 0 || !(size > 0.0)) return;
    const double N = number(0.0, 1.0) / size;
    r[first] = N;
    if (dim_ == 1) return;
    const Vector slip = u_.segment(first + 1, dim_ - 1);
    Vector T = numbers(dim_ - 1);
    if (slip.norm() > 1e-12)
      T = -mu_[i] * N * slip.normalized();
    else if (T.norm() > 1.0 || whole(0, 4) == 0)
      T *= mu_[i] * N / T.norm();
    else
      T *= mu_[i] * N;
    r.segment(first + 1, dim_ - 1) = T;
  }

  std::mt19937 random_;
  Sort sort_;
  int dim_ = 3, contacts_ = 0;
  Matrix S_;
  Vector inverseMass_, u_, mu_;
  KnownProblem out_;
};

/// How far (Λ, ξ = WΛ + q) misses the laws, written down without a line of the solvers: in every
/// contact the distance of (Λ, ξ) to the graph of the law, as a velocity,
///
///   e = λ |Λ − P_K(Λ − ξ^/λ)|,   ξ^ = ξ + μ|ξ_T| e_N,   λ: largest row sum of |W_ii|,
///
/// over the largest |q_i| of the contacts that close (of all, if none does). Sums in long double.
struct Missed {
  double error = 0.0;  ///< the largest e over the largest |q_i|
  /// What 64-bit numbers leave of it: 4ε Σ(|W||Λ| + |q|) of the contact, μ times more in ξ^.
  double rounding = 0.0;
};
inline Missed missed(const FclibProblem& p, const Eigen::VectorXd& Lambda) {
  using Real = long double;
  const Eigen::MatrixXd W = p.W;
  const int dim = p.dim, n = p.contacts();
  Real scale = 0.0L, all = 0.0L, worst = 0.0L, noise = 0.0L;
  for (int i = 0; i < n; ++i) {
    Real square = 0.0L;
    for (int k = 0; k < dim; ++k) square += static_cast<Real>(p.q[dim * i + k]) * p.q[dim * i + k];
    all = std::max(all, std::sqrt(square));
    if (p.q[dim * i] < 0.0) scale = std::max(scale, std::sqrt(square));
  }
  if (scale == 0.0L) scale = all;
  if (scale == 0.0L) scale = 1.0L;
  for (int i = 0; i < n; ++i) {
    Real xi[5] = {}, z[5] = {}, y[5] = {}, lambda = 0.0L, slip = 0.0L, rounding = 0.0L;
    for (int k = 0; k < dim; ++k) {
      Real sum = p.q[dim * i + k], size = std::abs(sum), row = 0.0L;
      for (int j = 0; j < W.cols(); ++j) {
        const Real part = static_cast<Real>(W(dim * i + k, j)) * Lambda[j];
        sum += part, size += std::abs(part);
      }
      for (int m = 0; m < dim; ++m) row += std::abs(W(dim * i + k, dim * i + m));
      xi[k] = sum, lambda = std::max(lambda, row);
      rounding += 4.0L * std::numeric_limits<double>::epsilon() * size;
      if (k > 0) slip += sum * sum;
    }
    if (lambda == 0.0L)
      lambda = W.size() > 0 && W.cwiseAbs().maxCoeff() > 0.0 ? W.cwiseAbs().maxCoeff() : 1.0L;
    const Real mu = dim > 1 ? p.mu[i] : 0.0;
    Real tangent = 0.0L, e2 = 0.0L;
    xi[0] += mu * std::sqrt(slip);
    for (int k = 0; k < dim; ++k) z[k] = Lambda[dim * i + k] - xi[k] / lambda;
    for (int k = 1; k < dim; ++k) tangent += z[k] * z[k];
    tangent = std::sqrt(tangent);
    if (z[0] >= 0.0L && tangent <= mu * z[0]) {
      std::copy(z, z + dim, y);
    } else if (z[0] > -mu * tangent) {
      y[0] = (z[0] + mu * tangent) / (1.0L + mu * mu);
      for (int k = 1; k < dim && tangent > 0.0L; ++k) y[k] = z[k] * (mu * y[0] / tangent);
    }
    for (int k = 0; k < dim; ++k) e2 += (Lambda[dim * i + k] - y[k]) * (Lambda[dim * i + k] - y[k]);
    const Real e = lambda * std::sqrt(e2);
    if (!(e <= worst)) worst = e;  // keeps what is not a number
    noise = std::max(noise, (1.0L + mu) * rounding);
  }
  return {static_cast<double>(worst / scale), static_cast<double>(noise / scale)};
}

}  // namespace dynamy
