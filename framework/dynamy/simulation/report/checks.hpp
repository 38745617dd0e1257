/// Checks: the measures of `<check>`, taken at the end of every step and not at the recorded rows,
/// so that no figure depends on what is recorded.
///
///   value   the signal at one instant, through the scheme's interpolation; default: the end
///   mean    (1/T) ∫ s dt over the interval, trapezoids between the ends of steps; where the scheme
///           chooses its steps Gauss' rule within them
///   min max over the ends of steps and the ends of the interval
///   period  mean distance of upward crossings of the mid level (min + max)/2; a crossing counts
///           only after the signal was 5 % of its range below it, so that chatter is one crossing.
///           Rejected: distances of maxima, which a flat top or an impact's spike displaces.
///   count   whole-number signals (status, latch): upward jumps; others: changes of sign
///
/// A signal `run.NAME` is a figure of the run's report instead, with the value at the end.
#pragma once
#include <algorithm>
#include <dynamy/core/compensated_sum.hpp>
#include <dynamy/simulation/report/run_watch.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>

namespace dynamy {

struct CheckResult {
  std::string signal;
  std::string measure;   ///< "value", "max", …
  std::string over;      ///< "at 4.1 s", "1 … 5 s"
  std::string expected;  ///< as the model says it
  double got = 0.0, low = 0.0, high = 0.0;
  bool pass = false;
  std::string note;  ///< why there is no value
  Place place;
};

/// One measure of one signal, fed with (t, s) in order of time.
class Measurement {
 public:
  explicit Measurement(const CheckSettings& settings) : settings_(settings) {}
  const CheckSettings& settings() const { return settings_; }
  /// Reserves room for `samples` pairs (t, s) if the measure has to keep them; up to this number
  /// add() does not allocate.
  void reserve(std::size_t samples);
  void add(double t, double s) { add(t, s, 0.5 * (t - t_) * (s_ + s)); }
  /// `area`: ∫ s dt since the last sample.
  void add(double t, double s, double area);
  /// Includes a value between two samples in the minimum and maximum.
  void between(double s) { min_ = std::min(min_, s), max_ = std::max(max_, s); }
  /// The measured value; NaN if there are too few samples.
  double result() const;
  void archive(Archive& a);

 private:
  void keep(double t, double s);
  double period() const;
  CheckSettings settings_;
  double t0_ = 0.0, t_ = 0.0, s_ = 0.0, min_ = 0.0, max_ = 0.0;
  long samples_ = 0, jumps_ = 0, signs_ = 0, stride_ = 1;
  int sign_ = 0;
  bool whole_ = true;
  CompensatedSum integral_;
  std::vector<double> times_, values_;
};

class Checks final : public Observer {
 public:
  /// Throws ModelError for unknown signals.
  explicit Checks(const Model& model);
  /// The results after the run; `report` provides figures such as run.penetration.
  std::vector<CheckResult> results(const RunReport& report) const;

  void start(const StepView& initial) override;
  void step(const StepView& view) override;
  void finish(const StepView& last) override;
  void archive(Archive& a) override;

 private:
  void feedStart(double t, const StepView* first);
  void feed(const StepView& view, std::size_t i, double end);
  /// ∫ s dt from a to b within a step.
  double area(const StepView& view, std::size_t i, double a, double b);
  /// Adds samples within a step of a scheme that chooses its steps: such a step may hold a whole
  /// oscillation.
  void feedWithin(const StepView& view, std::size_t i, double end);
  CheckResult measured(const Measurement& m) const;
  std::vector<CheckSettings> all_;
  SignalSampler sampler_;
  std::vector<Measurement> measurements_;  ///< of the checks on signals
  std::vector<double> values_;
  double t_ = 0.0;
  bool waits_ = false;  ///< forces at the start wait for the first step
};

}  // namespace dynamy
