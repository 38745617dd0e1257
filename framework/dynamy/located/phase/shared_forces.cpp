#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/located/phase/force_bounds.hpp>
#include <dynamy/located/phase/shared_forces.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kMoves = 1e-9;    ///< of the largest entry of N: below it a force does not change
constexpr int kMostShifts = 20;    ///< widenings of all bounds on the way to forces within them
constexpr int kMostClimbs = 60;    ///< Newton steps for one of them
constexpr double kClimbed = 1e-9;  ///< Newton's decrement at the centre
constexpr double kPart = 0.25;     ///< of the expected rise: a step that rises less is too long
constexpr double kWiden = 1e-9;    ///< of the largest force: least room within widened bounds

}  // namespace

void SharedForces::open(const std::vector<Held>& held, const HeldRows& rows,
                        const Eigen::MatrixXd& N) {
  N_ = N;
  const Eigen::VectorXd size = N.rowwise().norm();
  const double least = size.size() > 0 ? kMoves * size.maxCoeff() : 0.0;
  shares_.assign(held.size(), 0);
  bool normal = false;  // of a contact whose parts come next
  for (std::size_t i = 0; i < held.size(); ++i) {
    bool moves = false;
    for (int r = rows.row0(i); r < rows.row0(i) + rows.dim(i); ++r)
      moves = moves || size[r] > least;
    if (held[i].first == 0) normal = moves;
    shares_[i] = moves || (held[i].first > 0 && normal) ? 1 : 0;
  }
}

void SharedForces::find(const std::vector<Held>& held, const HeldRows& rows,
                        const Eigen::VectorXd& lambda) {
  bounds_.clear();
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!shares(i)) continue;
    for (const ForceBound& f : forceBounds(held, rows, i)) {
      Bound b;
      b.constant = f.constant, b.normal.setZero(N_.cols());
      if (f.normal >= 0)
        b.constant += f.factor * lambda[f.normal], b.normal = f.factor * N_.row(f.normal);
      const Eigen::Index k = f.weights.size();
      b.size = f.weights.cwiseProduct(lambda.segment(f.first, k));
      b.tangent = f.weights.asDiagonal() * N_.middleRows(f.first, k);
      bounds_.push_back(std::move(b));
    }
  }
}

/// By how much a bound is exceeded at most, below 0: by how much all are kept at least [N].
double SharedForces::outside(const Eigen::VectorXd& z) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const Bound& b : bounds_)
    most = std::max(most, (b.size + b.tangent * z).norm() - b.constant - b.normal.dot(z));
  return most;
}

/// The sum that is maximised, with all bounds L wider by `shift`; −∞ outside of them.
double SharedForces::value(const Eigen::VectorXd& z, double shift) const {
  double sum = -0.5 * (forces_ + scaled_ * z).squaredNorm();
  for (const Bound& b : bounds_) {
    const double L = b.constant + b.normal.dot(z) + shift;
    const double Q = b.size.size() > 0 ? L * L - (b.size + b.tangent * z).squaredNorm() : L;
    if (!(L > 0.0) || !(Q > 0.0)) return -std::numeric_limits<double>::infinity();
    sum += std::log(Q);
  }
  return sum;
}

void SharedForces::derivatives(const Eigen::VectorXd& z, double shift, Eigen::VectorXd& gradient,
                               Eigen::MatrixXd& hessian) const {
  gradient = -scaled_.transpose() * (forces_ + scaled_ * z);
  hessian = -scaled_.transpose() * scaled_;
  for (const Bound& b : bounds_) {
    const double L = b.constant + b.normal.dot(z) + shift;
    if (b.size.size() == 0) {
      gradient += b.normal / L;
      hessian -= b.normal * b.normal.transpose() / (L * L);
      continue;
    }
    const Eigen::VectorXd T = b.size + b.tangent * z;
    const double Q = L * L - T.squaredNorm();
    const Eigen::VectorXd g = 2.0 / Q * (L * b.normal - b.tangent.transpose() * T);
    gradient += g;
    hessian += 2.0 / Q * (b.normal * b.normal.transpose() - b.tangent.transpose() * b.tangent) -
               g * g.transpose();
  }
}

/// Newton's method from z, where all bounds hold, to the maximum.
bool SharedForces::climb(double shift, Eigen::VectorXd& z) const {
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
  double at = value(z, shift);
  for (int k = 0; k < kMostClimbs; ++k) {
    derivatives(z, shift, gradient, hessian);
    const Eigen::VectorXd step = Lu(-hessian).solve(gradient);
    const double rise = gradient.dot(step);
    if (!(rise >= 0.0) || !step.allFinite()) return false;
    if (rise < kClimbed) return true;
    double part = 1.0, there = value(z + step, shift);
    for (; !(there >= at + kPart * part * rise) && part > 1e-12;
         there = value(z + part * step, shift))
      part *= 0.5;
    if (!(there > at)) return true;
    z += part * step, at = there;
  }
  return true;
}

bool SharedForces::centre(const std::vector<Held>& held, const HeldRows& rows,
                          Eigen::VectorXd& lambda) {
  find(held, rows, lambda);
  if (bounds_.empty() || N_.cols() == 0) return false;
  double largest = 0.0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (shares(i))
      largest =
          std::max(largest, lambda.segment(rows.row0(i), rows.dim(i)).lpNorm<Eigen::Infinity>());
  if (!(largest > 0.0)) return false;
  forces_ = lambda / largest, scaled_ = N_ / largest;
  for (Eigen::Index r = 0; r < lambda.size(); ++r)
    if (scaled_.row(r).isZero(0.0)) forces_[r] = 0.0;
  Eigen::VectorXd z = Eigen::VectorXd::Zero(N_.cols());
  double by = outside(z);
  for (int k = 0; k < kMostShifts && by >= 0.0; ++k) {
    if (!climb(2.0 * by + kWiden * largest, z)) return false;
    const double now = outside(z);
    if (!(now < by)) return false;
    by = now;
  }
  if (!(by < 0.0) || !climb(0.0, z)) return false;
  lambda += N_ * z;
  return true;
}

}  // namespace dynamy
