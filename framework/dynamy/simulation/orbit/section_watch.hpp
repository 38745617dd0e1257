/// SectionWatch: sees the steps of a run, finds where it passes a section, and the ranges of its state.
///
///   s(x(t_a)) < c ≤ s(x(t_b))     for a section that the signal s rises through
#pragma once
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/simulation/orbit/orbit_section.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>

namespace dynamy {

class SectionWatch final : public Observer {
 public:
  /// Passes in steps that begin before `least` [s] do not count; `count`: which pass is sought.
  SectionWatch(const Model& model, const OrbitSection& section, double least, int count);
  void start(const StepView& initial) override;
  void step(const StepView& view) override;
  bool found() const { return found_; }
  double t() const { return t_; }          ///< of the pass [s]
  double part() const { return part_; }    ///< of the last step, where it is
  double slope() const { return slope_; }  ///< of the signal there [1/s]
  /// Seeks pass number `count` from here on.
  void next(int count) { left_ = count, found_ = false; }
  /// Largest minus smallest value of each position and velocity so far.
  Eigen::VectorXd ranges() const { return high_ - low_; }
  /// Switches so far.
  long switches() const { return switches_; }

 private:
  double sign() const { return section_.falling ? -1.0 : 1.0; }
  double side(const StepView& view, double theta);
  const OrbitSection& section_;
  double least_;
  int left_;
  SignalSampler sampler_;
  Eigen::VectorXd low_, high_;
  bool found_ = false;
  double t_ = 0.0, part_ = 0.0, slope_ = 0.0;
  long switches_ = 0;
};

}  // namespace dynamy
