#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/solver/lcp/lemke.hpp>
#include <limits>
#include <utility>

namespace dynamy {
namespace {

/// Numbers of a column below this fraction of its largest one are rounding and never pivots.
constexpr double kPivot = 1e-11;
/// Ratios that differ by less than this part are equal.
constexpr double kTie = 1e-12;
constexpr int kPaths = 3;
constexpr double kGood = 1e-11;    ///< min(w, z) of a solution, with |M|, |q| of size 1
constexpr double kCovered = 1e-9;  ///< z₀ that is rounding of 0 in degenerate problems
constexpr int kMaxProof = 200;     ///< unknowns up to which a proof of its own follows a ray
constexpr int kFresh = 40;         ///< pivots after which the tableau is computed afresh
/// A proof of infeasibility may miss Mᵀh ≤ 0 by this, with |M|, |h| of size 1.
constexpr double kProof = 1e-12;

}  // namespace

void Lemke::scale(ConstBlock M, ConstVec q) {
  // S M S, S q with z = S z': one S for rows and columns, which keeps M copositive if it was.
  M_ = M, q_ = q;
  scale_.setOnes(n_);
  for (int pass = 0; pass < 2; ++pass)
    for (int k = 0; k < n_; ++k) {
      const double size =
          std::max(M_.row(k).lpNorm<Eigen::Infinity>(), M_.col(k).lpNorm<Eigen::Infinity>());
      if (!(size > 0.0)) continue;
      const double s = 1.0 / std::sqrt(size);
      M_.row(k) *= s, M_.col(k) *= s, scale_[k] *= s;
    }
  q_ = q_.cwiseProduct(scale_);
  qSize_ = q_.lpNorm<Eigen::Infinity>();
  q_ /= qSize_;
}

void Lemke::start() {
  basis_.resize(static_cast<std::size_t>(n_));
  for (int i = 0; i < n_; ++i) basis_[static_cast<std::size_t>(i)] = i;
  tableau_.resize(n_, 2 * n_ + 2);
  tableau_.leftCols(n_).setIdentity();
  tableau_.middleCols(n_, n_) = -M_;
  tableau_.col(2 * n_) = -cover_;
  tableau_.col(2 * n_ + 1) = q_;
}

void Lemke::rebuild() {
  basisMatrix_.resize(n_, n_);
  for (int i = 0; i < n_; ++i) {
    const int variable = basis_[static_cast<std::size_t>(i)];
    if (variable < n_)
      basisMatrix_.col(i).setZero(), basisMatrix_(variable, i) = 1.0;
    else if (variable < 2 * n_)
      basisMatrix_.col(i) = -M_.col(variable - n_);
    else
      basisMatrix_.col(i) = -cover_;
  }
  const Eigen::PartialPivLU<RowMatrix> lu(basisMatrix_);
  const std::vector<int> basis = basis_;
  start();
  basis_ = basis;
  const RowMatrix fresh = lu.solve(tableau_);
  if (fresh.allFinite()) tableau_ = fresh;
}

bool Lemke::lexicographicallyLess(int a, int b, int column) const {
  const double pa = tableau_(a, column), pb = tableau_(b, column);
  for (int k = 0; k < n_; ++k) {
    const double x = tableau_(a, k) / pa, y = tableau_(b, k) / pb;
    if (std::abs(x - y) > kTie * std::max(std::abs(x), std::abs(y))) return x < y;
  }
  return a > b;
}

int Lemke::leavingRow(int column, bool first) const {
  // First: the most negative right side leaves for z₀, whose column is −d. Later: the least ratio.
  const int right = 2 * n_ + 1;
  const double least = kPivot * tableau_.col(column).lpNorm<Eigen::Infinity>();
  int best = -1;
  double bestRatio = 0.0;
  for (int i = 0; i < n_; ++i) {
    const double p = tableau_(i, column);
    if (!first && !(p > least)) continue;
    const double ratio =
        first ? tableau_(i, right) / cover_[i] : std::max(tableau_(i, right), 0.0) / p;
    const double tie = kTie * std::max(1.0, std::abs(bestRatio));
    if (best >= 0 && ratio > bestRatio + tie) continue;
    if (best >= 0 && ratio >= bestRatio - tie) {
      // Equal ratios: z₀ leaves if it can, which solves the problem; else the lexicographic rule.
      if (basis_[static_cast<std::size_t>(best)] == 2 * n_) continue;
      const bool covering = basis_[static_cast<std::size_t>(i)] == 2 * n_;
      if (!covering && (first ? i < best : !lexicographicallyLess(i, best, column))) continue;
    }
    best = i, bestRatio = ratio;
  }
  return best;
}

void Lemke::pivot(int row, int column) {
  tableau_.row(row) /= tableau_(row, column);
  for (int i = 0; i < n_; ++i) {
    const double factor = tableau_(i, column);
    if (i == row || factor == 0.0) continue;
    tableau_.row(i) -= factor * tableau_.row(row);
    tableau_(i, column) = 0.0;
  }
  basis_[static_cast<std::size_t>(row)] = column;
  ++pivots_;
  if (pivots_ % kFresh == 0) rebuild();
}

double Lemke::violation(const Eigen::VectorXd& z) const {
  double worst = 0.0;
  for (int i = 0; i < n_; ++i) {
    const double w = M_.row(i).dot(z) + q_[i];
    worst = std::max(worst, std::abs(std::min(w, z[i])));
  }
  return worst;
}

void Lemke::result() {
  // z is read from the tableau and computed from M_aa z_a = −q_a of the basis a; the better one is
  // kept.
  trial_.setZero(n_);
  std::vector<int> a;
  for (int i = 0; i < n_; ++i) {
    const int variable = basis_[static_cast<std::size_t>(i)] - n_;
    if (variable < 0 || variable >= n_) continue;
    trial_[variable] = std::max(tableau_(i, 2 * n_ + 1), 0.0);
    a.push_back(variable);
  }
  if (!a.empty()) {
    const Lu lu(M_(a, a));
    Eigen::VectorXd za = lu.solve(-q_(a));
    residual_ = -q_(a) - M_(a, a) * za;
    za += lu.solve(residual_);
    Eigen::VectorXd other = Eigen::VectorXd::Zero(n_);
    other(a) = za.cwiseMax(0.0);
    if (other.allFinite() && violation(other) <= violation(trial_)) trial_ = other;
  }
}

LcpOutcome Lemke::ray(int entering) {
  direction_.setZero(n_);
  if (entering >= n_ && entering < 2 * n_) direction_[entering - n_] = 1.0;
  for (int i = 0; i < n_; ++i) {
    const int variable = basis_[static_cast<std::size_t>(i)] - n_;
    if (variable >= 0 && variable < n_)
      direction_[variable] = std::max(-tableau_(i, entering), 0.0);
  }
  const double size = direction_.lpNorm<Eigen::Infinity>();
  if (!(size > 0.0)) return LcpOutcome::ray;
  direction_ /= size;
  residual_ = M_.transpose() * direction_;
  const bool proof = residual_.maxCoeff() <= kProof && q_.dot(direction_) < -1e6 * kProof;
  direction_ = direction_.cwiseProduct(scale_);
  return proof ? LcpOutcome::infeasible : LcpOutcome::ray;
}

bool Lemke::provenInfeasible(const std::function<bool()>& enough) {
  // Is there any z ≥ 0 with Mz + q ≥ 0? These are the optimality conditions of a linear programme
  // with nothing to minimise. Their skew matrix makes every ray a proof: its part y is h.
  if (n_ > kMaxProof) return false;
  RowMatrix K = RowMatrix::Zero(2 * n_, 2 * n_);
  K.topRightCorner(n_, n_) = -M_.transpose();
  K.bottomLeftCorner(n_, n_) = M_;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n_);
  right.tail(n_) = q_;
  Lemke other;
  other.n_ = 2 * n_;
  other.scale({K.data(), 2 * n_, 2 * n_}, view(std::as_const(right)));
  other.cover_.setOnes(2 * n_);
  if (other.pivoting(10 * n_, enough) != LcpOutcome::infeasible) return false;
  direction_ = other.direction_.tail(n_).cwiseProduct(scale_);
  return true;
}

double Lemke::coveringValue() const {
  for (int i = 0; i < n_; ++i)
    if (basis_[static_cast<std::size_t>(i)] == 2 * n_) return tableau_(i, 2 * n_ + 1);
  return 0.0;
}

LcpOutcome Lemke::pivoting(int maxPivots, const std::function<bool()>& enough) {
  start();
  int entering = 2 * n_;
  for (bool first = true;; first = false) {
    const int row = leavingRow(entering, first);
    if (row < 0) return coveringValue() <= kCovered ? LcpOutcome::solved : ray(entering);
    const int leaving = basis_[static_cast<std::size_t>(row)];
    pivot(row, entering);
    if (!tableau_.allFinite()) return LcpOutcome::notFinite;
    if (leaving == 2 * n_) return LcpOutcome::solved;
    if (pivots_ >= maxPivots || (enough && enough())) return LcpOutcome::pivotLimit;
    entering = leaving < n_ ? leaving + n_ : leaving - n_;
  }
}

LcpOutcome Lemke::solve(ConstBlock M, ConstVec q, Vec z, int maxPivots,
                        const std::function<bool()>& enough) {
  n_ = static_cast<int>(q.size());
  pivots_ = 0;
  if (!M.allFinite() || !q.allFinite()) return LcpOutcome::notFinite;
  if (n_ == 0 || q.minCoeff() >= 0.0) {
    z.setZero();
    return LcpOutcome::solved;
  }
  scale(M, q);
  // Another covering vector gives another path if rounding or a ray has spoilt the first one.
  constexpr double kGolden = 0.6180339887498949;
  double best = std::numeric_limits<double>::infinity();
  LcpOutcome outcome = LcpOutcome::ray;
  for (int path = 0; path < kPaths && pivots_ < maxPivots && !(path > 0 && enough && enough());
       ++path) {
    cover_.setOnes(n_);
    for (int i = 0; i < n_ && path > 0; ++i)
      cover_[i] += 3.0 * std::fmod(path * kGolden * (i + 1), 1.0);
    const LcpOutcome found = pivoting(maxPivots, enough);
    if (found == LcpOutcome::infeasible) return found;
    if (found == LcpOutcome::solved) {
      result();
      const double error = violation(trial_);
      if (error < best && error <= kCovered) best = error, z = qSize_ * trial_.cwiseProduct(scale_);
      if (best <= kGood) return found;
    }
    if (path == 0) outcome = found == LcpOutcome::solved ? LcpOutcome::ray : found;
  }
  if (std::isfinite(best)) return LcpOutcome::solved;
  return outcome == LcpOutcome::ray && provenInfeasible(enough) ? LcpOutcome::infeasible : outcome;
}

}  // namespace dynamy
