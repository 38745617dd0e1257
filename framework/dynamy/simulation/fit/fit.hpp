/// fit: parameters from measurements (theory 56):
///
///   χ²(p) = Σ ((v_k(p) − y_k)/σ_k)² + Σ ((p_i − m_i)/s_i)²,   min χ² within the bounds
///
/// by the method of Levenberg and Marquardt with derivatives of runs through impacts, stick and
/// slip. The interval of a parameter holds the values at which χ², with the others at their best,
/// exceeds its minimum by less than the square of the quantile. Parameters that the measurements do
/// not determine are found by the rank of the Jacobian and named.
///
/// Rejected: intervals from the covariance alone. They are symmetric, and a coefficient of friction
/// whose block stays where it is has none.
#pragma once
#include <dynamy/simulation/fit/measured_run.hpp>
#include <limits>

namespace dynamy {

struct WantedParameter {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kFree = std::numeric_limits<double>::infinity();
  std::string name;
  double start = 0.0;
  double lower = -kFree, upper = kFree;
  double priorMean = kNone, priorSigma = kNone;  ///< known beforehand; NaN: nothing
  bool each = false;                             ///< each run has a value of its own
};

struct FitRequest {
  std::vector<WantedParameter> parameters;
  std::vector<MeasuredRun> runs;
  double tolerance = 1e-9;  ///< of the runs
  int iterations = 100;     ///< at most
};

struct FittedParameter {
  enum class Interval : std::uint8_t {
    none,      ///< not identifiable
    gaussian,  ///< χ² is quadratic up to the ends of the interval: they follow from the covariance
    profile    ///< ends searched on the profile of χ²
  };
  std::string name;
  int run = -1;  ///< whose own value it is; −1: that of all runs
  double value = 0.0, sigma = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 %; infinite: no end was found
  Interval interval = Interval::none;
  bool identifiable = false;
  bool atBound = false;
};

struct FittedSignal {
  std::string signal;
  double sigma = 0.0;      ///< standard deviation [SI]; of the residuals where it is estimated
  bool estimated = false;  ///< the measurements have none, it is that of the residuals
  int count = 0;
};

struct FittedPoint {
  int run = 0;
  MeasuredValue measured;  ///< with the standard deviation that was used
  double fitted = 0.0;
};

struct FittedRun {
  std::string name;
  int count = 0;
  double chi2 = 0.0;
  FitEffort effort;
  bool otherOrder = false;  ///< within the intervals switches come in another order
};

struct Fit {
  std::vector<FittedParameter> parameters;
  Eigen::MatrixXd covariance;        ///< NaN: of parameters that are not identifiable
  std::vector<std::string> unknown;  ///< what the measurements leave open, a sentence each
  double chi2 = 0.0, priors = 0.0;   ///< at the minimum; of it the priors
  int freedom = 0;                   ///< measurements and priors minus identifiable parameters
  std::vector<FittedSignal> signals;
  std::vector<FittedRun> runs;
  std::vector<FittedPoint> points;
  bool converged = false;
  int iterations = 0;
  std::string why;  ///< the search has ended
  double tolerance = 0.0;
  bool identifiable() const;  ///< all parameters are
};

/// Throws ModelError: no measurements, unknown signals, a run that ends early at the start values.
Fit fit(const FitRequest& request);

}  // namespace dynamy
