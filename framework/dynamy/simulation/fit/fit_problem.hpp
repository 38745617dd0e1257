/// FitProblem: the residuals of all runs and of the priors as functions of all unknowns, which are
/// the common parameters and then the own ones of each run.
#pragma once
#include <dynamy/simulation/fit/fit.hpp>
#include <dynamy/simulation/fit/least_squares.hpp>

namespace dynamy {

class FitProblem {
 public:
  struct Unknown {
    int parameter = 0;  ///< of the request
    int run = -1;       ///< whose own value it is; −1: that of all runs
    double start = 0.0;
    double size = 1.0;  ///< typical change
  };

  /// Throws ModelError for a start beyond bounds.
  explicit FitProblem(const FitRequest& request);
  const FitRequest& request() const { return request_; }
  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  int size() const { return static_cast<int>(unknowns_.size()); }
  Eigen::VectorXd start() const;

  /// The problem, whose blocks refer to this object.
  LeastSquares leastSquares();
  /// All residuals: of the measurements, run by run, then of the priors. Throws ModelError.
  Eigen::VectorXd residuals(const Eigen::VectorXd& x);
  /// Their derivatives; `wide`: factor on the differences.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x, double wide = 1.0);
  /// Norm of what rounding contributes to a column of the Jacobian. After jacobian().
  double rounding(int unknown) const;
  int measurements() const { return measurements_; }

  /// Standard deviations of signals that have none: those of the residuals at x. `unknowns`: how
  /// many the measurements determine. Returns the largest relative change.
  double estimateSigma(const Eigen::VectorXd& x, int unknowns);
  std::vector<FittedSignal> signals() const;
  bool estimates() const;  ///< some signal has no standard deviation

  std::vector<RunResiduals>& runs() { return runs_; }
  const std::vector<RunResiduals>& runs() const { return runs_; }
  double sigma(const MeasuredValue& m) const;

 private:
  std::vector<double> ofRun(int run, const Eigen::VectorXd& x) const;
  bool evaluate(int run, const double* x, double* r, double* J);

  const FitRequest& request_;
  std::vector<Unknown> unknowns_;
  std::vector<std::vector<int>> of_;  // unknowns of each run
  std::vector<RunResiduals> runs_;
  std::vector<int> priors_;  // unknowns with a prior
  int measurements_ = 0;
  struct Noise {
    double sigma = 0.0, known = 0.0, least = 0.0;
    int count = 0;  // without a standard deviation of their own
    int all = 0;
  };
  std::map<std::string, Noise> noise_;  // by signal
};

}  // namespace dynamy
