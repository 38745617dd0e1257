#include <algorithm>
#include <cmath>
#include <dynamy/simulation/fit/intervals.hpp>

namespace dynamy {
namespace {

/// Rounds in which standard deviations, and unknowns on which something depends, are found.
constexpr int kRounds = 20;
constexpr double kSameWeights = 1e-3;  ///< relative change of them
constexpr int kRestarts = 4;           ///< where an interval led to a better fit

/// Moves x to the minimum, with standard deviations of the residuals where there are no others.
/// Unknowns on which nothing depends keep their values: rounding would carry them anywhere.
LeastSquaresEnd search(FitProblem& problem, Eigen::VectorXd& x, int& iterations) {
  LeastSquaresEnd end;
  LeastSquares squares = problem.leastSquares();
  std::vector<char> seen = seenUnknowns(problem, x, problem.jacobian(x));
  for (int round = 0; round < kRounds; ++round) {
    squares.fixed = seen;
    for (char& fixed : squares.fixed) fixed = fixed != 0 ? 0 : 1;
    end = minimise(squares, x);
    iterations += end.iterations;
    const bool same =
        !problem.estimates() || problem.estimateSigma(x, problem.size()) < kSameWeights;
    std::vector<char> now = seenUnknowns(problem, x, problem.jacobian(x));
    if (same && now == seen) break;
    seen = std::move(now);
  }
  return end;
}

std::vector<FittedPoint> points(FitProblem& problem, const Eigen::VectorXd& r) {
  std::vector<FittedPoint> out;
  int row = 0, run = 0;
  for (const RunResiduals& of : problem.runs()) {
    for (const MeasuredValue& m : of.run().data) {
      FittedPoint& p = out.emplace_back();
      p.run = run, p.measured = m, p.measured.sigma = problem.sigma(m);
      p.fitted = m.value + r[row++] * p.measured.sigma;
    }
    ++run;
  }
  return out;
}

void addRuns(FitProblem& problem, const Intervals& intervals, Fit& out) {
  std::size_t k = 0;
  for (const RunResiduals& run : problem.runs()) {
    FittedRun& f = out.runs.emplace_back();
    f.name = run.run().name, f.count = static_cast<int>(run.run().data.size());
    f.effort = run.effort(), f.otherOrder = intervals.otherOrder(k++);
  }
  for (const FittedPoint& p : out.points) {
    const double r = (p.fitted - p.measured.value) / p.measured.sigma;
    out.runs[static_cast<std::size_t>(p.run)].chi2 += r * r;
  }
}

/// False: there is a better fit, to which x was moved; not if this is the `last` round.
bool addParameters(FitProblem& problem, Intervals& intervals, bool last, Eigen::VectorXd& x,
                   Fit& out) {
  out.parameters.clear();
  for (int i = 0; i < problem.size(); ++i) {
    FittedParameter& p = out.parameters.emplace_back();
    const FitProblem::Unknown& u = problem.unknowns()[static_cast<std::size_t>(i)];
    p.name = problem.request().parameters[static_cast<std::size_t>(u.parameter)].name;
    p.run = u.run;
    if (intervals.find(i, p)) continue;
    if (last) {
      out.converged = false, out.why = "ever better values were found beside the best ones";
      continue;
    }
    x = intervals.better();
    return false;
  }
  return true;
}

}  // namespace

bool Fit::identifiable() const {
  return std::all_of(parameters.begin(), parameters.end(),
                     [](const FittedParameter& p) { return p.identifiable; });
}

Fit fit(const FitRequest& request) {
  FitProblem problem(request);
  if (problem.measurements() == 0) throw ModelError("there are no measurements");
  if (problem.size() == 0) throw ModelError("there are no parameters to fit");
  Eigen::VectorXd x = problem.start();
  problem.residuals(x);  // tells why a run does not work from the start
  Fit out;
  out.tolerance = request.tolerance;
  for (int restarts = 0;; ++restarts) {
    const LeastSquaresEnd end = search(problem, x, out.iterations);
    out.converged = end.converged, out.why = end.why;
    const Information information = informationAt(problem, x);
    if (problem.estimates()) problem.estimateSigma(x, information.rank);
    const Eigen::VectorXd r = problem.residuals(x);
    const int rows = problem.measurements();
    out.chi2 = r.squaredNorm(), out.priors = r.tail(r.size() - rows).squaredNorm();
    out.freedom = static_cast<int>(r.size()) - information.rank;
    out.unknown = information.open;
    out.points = points(problem, r);
    Information weighted = information;
    if (problem.estimates()) weighted = informationAt(problem, x);
    Intervals intervals(problem, weighted, x, quantile(problem.estimates(), out.freedom));
    if (!addParameters(problem, intervals, restarts == kRestarts, x, out)) continue;
    out.covariance = weighted.covariance;
    addRuns(problem, intervals, out);
    break;
  }
  for (int i = 0; i < problem.size(); ++i)
    if (!out.parameters[static_cast<std::size_t>(i)].identifiable) {
      out.covariance.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
      out.covariance.col(i).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  out.signals = problem.signals();
  return out;
}

}  // namespace dynamy
