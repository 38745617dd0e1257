#include <algorithm>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/simulation/linear/extrapolated_derivative.hpp>
#include <dynamy/simulation/linear/steady_search.hpp>
#include <dynamy/stages/error_norm.hpp>

namespace dynamy {
namespace {

/// Largest accelerations of a steady motion, as a share of those by the forces alone.
constexpr double kSteady = 1e-10;
constexpr int kMostSearchSteps = 40;        ///< of Newton's method
constexpr double kLongestCorrection = 0.3;  ///< of its steps [m, rad]
/// Roundings of a place on the way to a force: of the coordinates, of points on bodies, of lengths.
constexpr double kRoundings = 8.0;

}  // namespace

SteadySearch::SteadySearch(Model& model, HeldMotion& motion)
    : motion_(motion), nu_(model.topology().nu()) {
  // Steps of the differences by unit: lengths scale with the scene.
  Eigen::VectorXd positions;
  unitScales(model.topology(), std::min(1.0, model.length()), positions, step_);
  step_ *= kStep;
}

double SteadySearch::allowed() const {
  return kSteady * std::max(1.0, motion_.freeAcceleration()) + rounding_;
}

void SteadySearch::noteRounding(const State& x, const Eigen::MatrixXd& tangent, Eigen::Index rows) {
  const Eigen::Index places = std::min(nu_, tangent.cols());
  const Eigen::MatrixXd stiffness = tangent.bottomRows(rows).topLeftCorner(nu_, places).cwiseAbs();
  rounding_ = kRoundings * kEpsilon * maxAbs(x.q) * stiffness.rowwise().sum().maxCoeff();
}

std::vector<double> SteadySearch::laterTimes(const State& x) {
  const double fastest = maxAbs(x.u);
  if (fastest == 0.0) return {};
  return {0.7 / fastest, 1.9 / fastest};
}

bool SteadySearch::staysSteady(const State& x) {
  const std::vector<double> later = laterTimes(x);
  return std::all_of(later.begin(), later.end(), [&](double tau) {
    return maxAbs(motion_.at(motion_.movedOn(x, tau)).a) <= kDrift * allowed();
  });
}

double SteadySearch::seek(State& x) {
  double way = correct(x, {});
  // A moving damper may carry a force now and none later: then the motion is to be steady later, too.
  if (!staysSteady(x)) way += correct(x, laterTimes(x));
  return way;
}

/// Newton's method for zero accelerations and held constraints, now and, in the steady motion from
/// here, after each of the `later` times [s].
double SteadySearch::correct(State& x, const std::vector<double>& later) {
  const bool rest = maxAbs(x.u) == 0.0;
  const Eigen::Index free = rest ? nu_ : 2 * nu_;
  double way = 0.0;
  for (int i = 0; i < kMostSearchSteps; ++i) {
    const Eigen::VectorXd y = residual(x, later);
    if (maxAbs(y) <= 1e-3 * allowed()) return way;
    PseudoInverse inverse(kRankOfStates);
    const Eigen::MatrixXd J = tangent(x, later, free);
    noteRounding(x, J, J.rows() / static_cast<Eigen::Index>(later.size() + 1));
    inverse.compute(J);
    Eigen::VectorXd change;
    inverse.solve(y, change);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(2 * nu_);
    z.head(free) = -change;
    const double length = z.norm(),
                 part = std::min(1.0, kLongestCorrection / std::max(length, 1e-300));
    if (part == 1.0 && length < 1e-15) return way;
    x = motion_.displaced(x, part * z.head(nu_));
    x.u += part * z.tail(nu_);
    way += part * length;
  }
  return way;
}

/// Accelerations, velocities and positions of the held rows at x and after the `later` times.
Eigen::VectorXd SteadySearch::residual(const State& x, const std::vector<double>& later) {
  Eigen::VectorXd y;
  const auto append = [&](const MotionSample& m) {
    const Eigen::Index first = y.size(), rows = m.gamma.size();
    y.conservativeResize(first + nu_ + 2 * rows);
    y.tail(nu_ + 2 * rows) << m.a, m.gamma, m.position;
  };
  for (const double tau : later) append(motion_.at(motion_.movedOn(x, tau)));
  append(motion_.at(x));  // last, so that the forces of the motion are those at x
  return y;
}

/// ∂residual/∂z for the first `free` ones of z: displacements, velocities.
Eigen::MatrixXd SteadySearch::tangent(const State& x, const std::vector<double>& later,
                                      Eigen::Index free) {
  Eigen::MatrixXd J;
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(nu_);
  double error = 0.0;
  for (Eigen::Index i = 0; i < free; ++i) {
    const Eigen::Index k = i % nu_;
    direction.setZero(), direction[k] = 1.0;
    const auto f = [&](double s) {
      State moved = i < nu_ ? motion_.displaced(x, s * direction) : x;
      if (i >= nu_) moved.u[k] += s;
      return residual(moved, later);
    };
    const Eigen::VectorXd D = extrapolatedDerivative(f, i < nu_ ? step_[k] : kStep, error);
    if (J.size() == 0) J.resize(D.size(), free);
    J.col(i) = D;
  }
  return J;
}

}  // namespace dynamy
