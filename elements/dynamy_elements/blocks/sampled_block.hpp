/// SampledBlock: base of the blocks that change at the instants t_k = offset + k T alone, and hold
/// `out` between them (theory 55).
///
/// What a block holds is part of State::memory: a rejected step restores it, a checkpoint stores
/// it. A block changes it in remember() at t_k and announces these instants, at which every scheme
/// ends a step. Blocks of one instant sample in the order of the model. Rejected: to sample at the
/// end of the step that contains t_k; results would depend on the step.
#pragma once
#include <dynamy/simulation/model/time_grid.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/signal_formulas.hpp>

namespace dynamy {

/// The instants t_k = offset + k T.
class SampleClock {
 public:
  static void declare(Attributes& a);
  explicit SampleClock(const Parameters& x);
  SampleClock(double period, double offset) : grid_(period), offset_(offset) {}
  double period() const { return grid_.spacing(); }
  double first() const { return offset_; }  ///< the first instant [s]
  /// Is instant number `count` reached at t, up to rounding?
  bool due(double t, double count) const;
  /// Number of the first instant after t; one that t reaches up to rounding is not after it.
  double after(double t) const;
  /// The first instant after t [s].
  double next(double t) const;
  /// Number of the last instant until t; −1: there is none.
  double last(double t) const { return after(t) - 1.0; }

 private:
  double at(double count) const {
    constexpr double kExact = 9007199254740992.0;  // 2⁵³: beyond it not every number is there
    return offset_ + (count < kExact ? grid_.at(static_cast<long>(count)) : period() * count);
  }
  TimeGrid grid_;
  double offset_;
};

/// Base of the sampled blocks. Memory: number of the next instant, then what the block holds, out
/// first.
class SampledBlock : public ExternalForce {
 public:
  explicit SampledBlock(const Parameters& x);
  SampledBlock(const Parameters& x, SampleClock clock, double initial)
      : ExternalForce(x), clock_(clock), initial_(initial) {}
  void connect(Topology& topology) final;
  bool mayCouple() const override { return false; }
  void addTo(const Kinematics&, ForceSink&) const final {}
  void remember(const Kinematics& k, Vec memory) const final;
  void describe(Description& d) const override;

 protected:
  static void declareSampled(Attributes& a);
  const SampleClock& clock() const { return clock_; }
  /// What the block holds before the first instant.
  virtual std::vector<double> held() const = 0;
  virtual std::vector<SignalFormulas*> formulas() = 0;
  /// Takes a sample: changes what the block holds.
  virtual void sample(const Kinematics& k, double* held) const = 0;
  double initial() const { return initial_; }

 private:
  SampleClock clock_;
  double initial_;
};

}  // namespace dynamy
