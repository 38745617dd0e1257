#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/located/phase/force_bounds.hpp>
#include <dynamy/simulation/linear/widest_forces.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRedundant = 1e-10;  ///< pivots below this share belong to redundant rows
constexpr double kGap = 1e-13;        ///< relative distance from the widest margin at the end
constexpr double kSharper = 8.0;      ///< growth of the weight of s from one centre to the next
constexpr int kMostCentring = 50;     ///< steps of Newton's method for one centre
constexpr double kCentred = 1e-6;     ///< decrement at which a centre is near enough
constexpr double kFlat = 1e-12;       ///< curvature that holds unknowns without bounds
/// With more unknowns the forces of the phase are kept: a step would cost seconds.
constexpr Eigen::Index kMostUnknowns = 1500;
/// Margins are bounded by this many of the largest forces: between two walls they could grow for ever.
constexpr double kWidest = 1.0;

/// α − s ≥ |β| of the unknowns of one contact: α = a·π + b, β = B π + β₀.
struct Bound {
  Eigen::VectorXd a, beta0;
  Eigen::MatrixXd B;
  double b = 0.0;
};

/// The unknowns of one contact with their bounds, in units of the largest force.
struct Block {
  Eigen::Index first = 0, size = 0;
  std::vector<Bound> bounds;
  Eigen::MatrixXd H;     ///< ∂²/∂π²
  Eigen::VectorXd g, c;  ///< ∂/∂π; ∂²/∂π∂s
};

class Barrier {
 public:
  Barrier(const FrozenPhase& phase, const Eigen::VectorXd& lambda) : phase_(phase) {
    directions_.find(phase.held, phase.rows());
    const Eigen::Index n = directions_.unknowns();
    unit_ = std::max(phase.forceScale(), std::numeric_limits<double>::min());
    P_ = directions_.P();
    pi_.resize(n);
    for (Eigen::Index k = 0; k < n; ++k)
      pi_[k] = lambda[directions_.kept[static_cast<std::size_t>(k)]] / unit_;
    for (std::size_t i = 0; i < phase.held.size(); ++i) {
      if (phase.held[i].first == 0) begin(i);
      if (!blocks_.empty()) bound(i);
    }
  }
  /// True: forces can be shared, some have a bound, and they are not too many.
  bool open() {
    if (pi_.size() == 0 || pi_.size() > kMostUnknowns) return false;
    D_ = nullSpace(phase_.rows().W() * P_, kRedundant);
    return D_.cols() > 0 && std::any_of(blocks_.begin(), blocks_.end(),
                                        [](const Block& b) { return !b.bounds.empty(); });
  }
  Eigen::VectorXd widen() {
    s_ = kWidest;
    double parameter = 1.0;
    for (const Block& k : blocks_)
      for (const Bound& c : k.bounds) {
        s_ = std::min(s_, margin(c, k, pi_));
        parameter += c.B.rows() > 0 ? 2.0 : 1.0;
      }
    s_ -= 0.5;
    for (double tau = 1.0; tau < parameter / kGap; tau *= kSharper)
      for (int i = 0; i < kMostCentring && step(tau); ++i) {
      }
    return unit_ * (P_ * pi_) + directions_.p0;
  }

 private:
  static double alpha(const Bound& c, const Block& k, const Eigen::VectorXd& pi) {
    return c.a.dot(pi.segment(k.first, k.size)) + c.b;
  }
  static Eigen::VectorXd beta(const Bound& c, const Block& k, const Eigen::VectorXd& pi) {
    return c.B * pi.segment(k.first, k.size) + c.beta0;
  }
  static double margin(const Bound& c, const Block& k, const Eigen::VectorXd& pi) {
    return alpha(c, k, pi) - beta(c, k, pi).norm();
  }

  /// The contact whose first part is held[i].
  void begin(std::size_t i) {
    std::size_t end = i + 1;
    while (end < phase_.held.size() && phase_.held[end].first > 0) ++end;
    const int row0 = phase_.rows().row0(i),
              row1 = phase_.rows().row0(end - 1) + phase_.rows().dim(end - 1);
    Block k;
    const auto at = std::lower_bound(directions_.kept.begin(), directions_.kept.end(), row0);
    k.first = at - directions_.kept.begin();
    k.size = std::lower_bound(at, directions_.kept.end(), row1) - at;
    blocks_.push_back(std::move(k));
  }

  /// The bounds of held[i], all narrower by s.
  void bound(std::size_t i) {
    Block& k = blocks_.back();
    if (k.size == 0) return;
    for (const ForceBound& f : forceBounds(phase_.held, phase_.rows(), i)) {
      Bound c;
      c.b = f.constant / unit_, c.a.setZero(k.size);
      if (f.normal >= 0) {
        c.a = f.factor * P_.row(f.normal).segment(k.first, k.size).transpose();
        c.b += f.factor * directions_.p0[f.normal] / unit_;
      }
      c.B.resize(f.weights.size(), k.size), c.beta0.resize(f.weights.size());
      for (Eigen::Index r = 0; r < f.weights.size(); ++r) {
        c.B.row(r) = f.weights[r] * P_.row(f.first + r).segment(k.first, k.size);
        c.beta0[r] = f.weights[r] * directions_.p0[f.first + r] / unit_;
      }
      k.bounds.push_back(std::move(c));
    }
  }

  /// −τ s − Σ log((α − s)² − |β|²) − log(s_max − s) + ½ ε |π|²
  double value(const Eigen::VectorXd& pi, double s, double tau) const {
    if (!(s < kWidest)) return kInfinity;
    double f = -tau * s - std::log(kWidest - s) + 0.5 * kFlat * pi.squaredNorm();
    for (const Block& k : blocks_)
      for (const Bound& c : k.bounds) {
        const double at = alpha(c, k, pi) - s, norm = beta(c, k, pi).norm();
        if (!(at > norm)) return kInfinity;
        f -= std::log(at - norm) + (c.B.rows() > 0 ? std::log(at + norm) : 0.0);
      }
    return f;
  }

  /// Gradient and curvature of the value: those of each block; ∂/∂s, ∂²/∂s².
  void differentiate(double tau, double& gs, double& hs) {
    gs = -tau + 1.0 / (kWidest - s_), hs = 1.0 / ((kWidest - s_) * (kWidest - s_));
    for (Block& k : blocks_) {
      k.H = kFlat * Eigen::MatrixXd::Identity(k.size, k.size);
      k.g = kFlat * pi_.segment(k.first, k.size), k.c.setZero(k.size);
      for (const Bound& c : k.bounds) {
        const double at = alpha(c, k, pi_) - s_;
        if (c.B.rows() == 0) {
          k.g -= c.a / at, gs += 1.0 / at;
          k.H += c.a * c.a.transpose() / (at * at), k.c -= c.a / (at * at), hs += 1.0 / (at * at);
          continue;
        }
        const Eigen::VectorXd b = beta(c, k, pi_), dG = 2.0 * (at * c.a - c.B.transpose() * b);
        const double G = (at - b.norm()) * (at + b.norm()), dGs = -2.0 * at;
        k.g -= dG / G, gs -= dGs / G;
        k.H += dG * dG.transpose() / (G * G) -
               2.0 / G * (c.a * c.a.transpose() - c.B.transpose() * c.B);
        k.c += dG * dGs / (G * G) + 2.0 / G * c.a, hs += dGs * dGs / (G * G) - 2.0 / G;
      }
    }
  }

  /// A step of Newton's method for (z, s). False: near enough to the centre.
  bool step(double tau) {
    double gs = 0.0, hs = 0.0;
    differentiate(tau, gs, hs);
    const Eigen::Index k = D_.cols();
    Eigen::MatrixXd HD(D_.rows(), k), H(k + 1, k + 1);
    Eigen::VectorXd g(D_.rows()), c(D_.rows()), gradient(k + 1), step(k + 1);
    for (const Block& b : blocks_) {
      HD.middleRows(b.first, b.size).noalias() = b.H * D_.middleRows(b.first, b.size);
      g.segment(b.first, b.size) = b.g, c.segment(b.first, b.size) = b.c;
    }
    H.topLeftCorner(k, k).noalias() = D_.transpose() * HD;
    H.topRightCorner(k, 1).noalias() = D_.transpose() * c;
    H.bottomLeftCorner(1, k) = H.topRightCorner(k, 1).transpose(), H(k, k) = hs;
    gradient.head(k).noalias() = D_.transpose() * g, gradient[k] = gs;
    Lu(H).solve(gradient, step);
    const double decrement = gradient.dot(step);
    if (!(decrement > kCentred)) return false;
    const Eigen::VectorXd way = -(D_ * step.head(k));
    const double ds = -step[k], before = value(pi_, s_, tau);
    double part = 1.0;
    while (part > 1e-12 &&
           !(value(pi_ + part * way, s_ + part * ds, tau) <= before - 0.1 * part * decrement))
      part *= 0.5;
    if (part <= 1e-12) return false;
    pi_ += part * way, s_ += part * ds;
    return true;
  }

  const FrozenPhase& phase_;
  ForceDirections directions_;
  std::vector<Block> blocks_;
  Eigen::MatrixXd P_, D_;  // D: forces that redundant rows may share, W P D = 0
  Eigen::VectorXd pi_;
  double unit_ = 1.0, s_ = 0.0;
};

}  // namespace

WidestForces::WidestForces(const FrozenPhase& phase) : phase_(phase), lambda_(phase.lambda()) {
  if (lambda_.size() == 0) return;
  Barrier barrier(phase, lambda_);
  if (barrier.open()) lambda_ = barrier.widen();
}

bool WidestForces::margin(std::size_t i, double& value) const {
  const HeldRows& rows = phase_.rows();
  return rows.set(i).margin(
      phase_.held[i].slips, {lambda_.data() + rows.row0(i), static_cast<std::size_t>(rows.dim(i))},
      lambda_[normalRow(phase_.held, rows, i)], rows.gamma().data() + rows.row0(i), value);
}

}  // namespace dynamy
