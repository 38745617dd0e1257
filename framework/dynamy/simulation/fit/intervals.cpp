#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <dynamy/simulation/fit/intervals.hpp>

namespace dynamy {
namespace {

constexpr double kNormal = 1.959963984540054;  ///< quantile of 97.5 %
/// Part by which the rise of χ² at the ends may differ from that of a quadratic function; the ends
/// are off by half of it.
constexpr double kQuadratic = 0.04;
constexpr double kEnd = 0.01;     ///< the same for ends that are searched
constexpr double kBetter = 0.01;  ///< fall of χ² that is no rounding: a tenth of σ of one unknown
constexpr double kFar = 4.0, kFarthest = 1e3;  ///< factors of one try, of all, on the half width
constexpr int kSearches = 20;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

double quantile(bool estimated, int freedom) {
  if (!estimated) return kNormal;
  // In double: tables that boost fills in long double when the library is loaded end every program
  // under Valgrind, whose long double is one of 64 bits.
  using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  return boost::math::quantile(
      boost::math::students_t_distribution<double, InDouble>(std::max(freedom, 1)), 0.975);
}

Intervals::Intervals(FitProblem& problem, const Information& information, const Eigen::VectorXd& x,
                     double quantile)
    : problem_(problem),
      information_(information),
      x_(x),
      search_(problem.leastSquares()),
      quantile_(quantile),
      least_(problem.residuals(x).squaredNorm()),
      otherOrder_(problem.runs().size()) {
  for (RunResiduals& run : problem_.runs()) run.keepOrder();
  search_.sum = 0.1 * kEnd * quantile * quantile / std::max(least_, 1.0);
}

void Intervals::lookAtOrder() {
  for (std::size_t k = 0; k < otherOrder_.size(); ++k)
    otherOrder_[k] = otherOrder_[k] || !problem_.runs()[k].sameOrder();
}

/// The others move with this unknown as the covariance says, also those that cannot be told apart:
/// what they do together can.
Eigen::VectorXd Intervals::moved(int unknown, double by) const {
  const Eigen::MatrixXd& C = information_.inverse;
  return x_ + by / C(unknown, unknown) * C.col(unknown);
}

bool Intervals::inside(const Eigen::VectorXd& x) const {
  return (x.array() >= search_.lower.array()).all() && (x.array() <= search_.upper.array()).all();
}

/// With the inverse of the others' block of JᵀJ, which is C_oo − C_oi C_io/C_ii, and g = Jᵀr, a
/// linear step of the others lowers χ² by g_oᵀ C_oo g_o − (C_io g_o)²/C_ii.
double Intervals::rise(const Eigen::VectorXd& x, int unknown) {
  try {
    const Eigen::VectorXd r = problem_.residuals(x);
    lookAtOrder();
    const Eigen::MatrixXd& C = information_.inverse;
    Eigen::VectorXd g = information_.J.transpose() * r;
    g[unknown] = 0.0;
    const Eigen::VectorXd Cg = C * g;
    const double gain = g.dot(Cg) - Cg[unknown] * Cg[unknown] / C(unknown, unknown);
    return r.squaredNorm() - gain - least_;
  } catch (const ModelError&) {
    return kInfinite;
  }
}

bool Intervals::quadratic(int unknown, double half) {
  for (const double by : {-half, half}) {
    const Eigen::VectorXd x = moved(unknown, by);
    if (!inside(x)) return false;
    const double part = rise(x, unknown) / (quantile_ * quantile_);
    if (!(std::abs(part - 1.0) <= kQuadratic)) return false;
  }
  return true;
}

/// The rise of χ² with this unknown held and the others, from x on, at their best.
double Intervals::profile(int unknown, Eigen::VectorXd& x) {
  search_.fixed.assign(static_cast<std::size_t>(x.size()), 0);
  bool alone = true;
  for (std::size_t i = 0; i < search_.fixed.size(); ++i) {
    search_.fixed[i] = !information_.seen[i] || static_cast<int>(i) == unknown ? 1 : 0;
    alone = alone && search_.fixed[i];
  }
  try {
    problem_.residuals(x);
    if (!alone) minimise(search_, x);
    const double rise = problem_.residuals(x).squaredNorm() - least_;
    lookAtOrder();
    return rise;
  } catch (const ModelError&) {
    return kInfinite;
  }
}

std::optional<double> Intervals::end(int unknown, double half, Side side) {
  const double sign = side == Side::low ? -1.0 : 1.0;
  const double bound =
      std::abs((side == Side::low ? search_.lower : search_.upper)[unknown] - x_[unknown]);
  double inner = 0.0, outer = kInfinite;  // steps below and above the end
  double by = std::min(half, bound);
  Eigen::VectorXd x = moved(unknown, sign * by);
  for (int tries = 0; tries < kSearches; ++tries) {
    if (by == 0.0) return x_[unknown];
    x = x.cwiseMax(search_.lower).cwiseMin(search_.upper);
    x[unknown] = x_[unknown] + sign * by;
    const double rise = profile(unknown, x);
    if (rise < -kBetter) return better_ = x, std::nullopt;
    const double part = std::sqrt(std::max(rise, 0.0)) / quantile_;
    if (std::abs(part - 1.0) <= 0.5 * kEnd) return x[unknown];
    (part < 1.0 ? inner : outer) = by;
    if (part < 1.0 && by >= bound) return x[unknown];
    if (part < 1.0 && by >= kFarthest * half) return sign * kInfinite;
    if (std::isfinite(outer) && outer - inner <= 1e-4 * outer)
      return x_[unknown] + sign * inner;  // χ² jumps here
    // √rise grows in proportion to the step where χ² is quadratic.
    double next = std::isfinite(part) ? by * std::min(1.0 / part, kFar) : 0.5 * (inner + outer);
    if (!(next > inner && next < outer))
      next = std::isfinite(outer) ? 0.5 * (inner + outer) : kFar * by;
    next = std::min(next, bound);
    x = std::isfinite(part) ? Eigen::VectorXd(x_ + next / by * (x - x_))
                            : moved(unknown, sign * next);
    by = next;
  }
  return x_[unknown] + sign * inner;
}

bool Intervals::find(int unknown, FittedParameter& out) {
  out.value = x_[unknown];
  out.identifiable = information_.identifiable[static_cast<std::size_t>(unknown)];
  out.atBound = out.value == search_.lower[unknown] || out.value == search_.upper[unknown];
  if (!out.identifiable) {
    out.sigma = out.low = out.high = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  out.sigma = std::sqrt(information_.covariance(unknown, unknown));
  const double half = quantile_ * out.sigma;
  out.interval = FittedParameter::Interval::gaussian;
  out.low = out.value - half, out.high = out.value + half;
  if (!out.atBound && quadratic(unknown, half)) return true;
  out.interval = FittedParameter::Interval::profile;
  const std::optional<double> low = end(unknown, half, Side::low);
  if (!low) return false;
  const std::optional<double> high = end(unknown, half, Side::high);
  if (!high) return false;
  out.low = *low, out.high = *high;
  return true;
}

}  // namespace dynamy
