/// MeasuredRun: what was measured in one run, and its residuals and their derivatives:
///
///   r = (v(t; p) − y)/σ,   J = ∂r/∂p
///
/// v: the signal of a run to a tolerance. J by runs that follow it (theory 53). Where the switches
/// depend on p, J is from differences of runs that choose their own steps; that is counted.
#pragma once
#include <Eigen/Core>
#include <dynamy/simulation/gradient/run_differences.hpp>
#include <map>
#include <memory>

namespace dynamy {

/// A value of a signal; sigma: its standard deviation, NaN: not known.
struct MeasuredValue {
  std::string signal;
  double t = 0.0, value = 0.0, sigma = 0.0;
};

struct MeasuredRun {
  std::string name;  ///< in results, e.g. of its file
  ModelMaker make;
  /// Its start; null: the initial state of the model.
  std::function<State(const Model&)> start;
  std::vector<MeasuredValue> data;
  std::vector<Varied> own = {};  ///< where the search for parameters of this run begins
};

/// What happened to a run in a fit.
struct FitEffort {
  long runs = 0;        ///< motions that were computed
  int evaluations = 0;  ///< derivatives that were taken
  int reordered = 0;    ///< of these: the sequence of switches was another than the time before
  int across = 0;       ///< of these: some by runs with other switches
  int ended = 0;        ///< values of the parameters at which the run ended early
};

/// The residuals of a run as functions of parameters.
class RunResiduals {
 public:
  /// `parameters`: names, with the sizes that differences are parts of.
  RunResiduals(const MeasuredRun& run, std::vector<Varied> parameters, double tolerance);

  /// Signals at the measured instants for these values of the parameters. Throws ModelError.
  const std::vector<double>& values(const double* x);
  /// Their derivatives, one row per measurement. `wide`: factor on the differences.
  const Eigen::MatrixXd& derivatives(const double* x, double wide = 1.0);
  /// Rounding that the derivatives by parameter i contain, as a change of each measured value.
  double rounding(std::size_t measurement, std::size_t parameter) const;

  const MeasuredRun& run() const { return run_; }
  const FitEffort& effort() const { return effort_; }
  /// Keeps the sequence of switches at the last values, for `sameOrder`.
  void keepOrder() { kept_ = order(); }
  /// The sequence of switches at the last values is the one that was kept.
  bool sameOrder() const { return kept_ == order(); }
  bool across() const { return usedAcross_; }  ///< of the last derivatives
  void countEnded() { ++effort_.ended; }

 private:
  using Order = std::vector<std::pair<ContactKey, int>>;
  void place(const double* x);
  Order order() const;

  const MeasuredRun& run_;
  std::vector<Varied> parameters_;
  double tolerance_;
  std::vector<SignalAt> of_;
  Eigen::VectorXd at_;
  std::unique_ptr<RunDifferences> differences_;  // at at_; null: not computed
  Eigen::MatrixXd derivatives_;
  bool known_ = false, usedAcross_ = false;  // derivatives_ are those at at_
  Order kept_, before_;
  FitEffort effort_;
};

}  // namespace dynamy
