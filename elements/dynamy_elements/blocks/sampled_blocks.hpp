/// Blocks: elements that exert no force and give a signal `out`, which formulas read (theory 55).
/// Those here change at the instants t_k = offset + k T alone, and hold `out` between them:
///
///   Sample   out = f(t_k)
///   Delay    out = f(t_{k−n})
///   Noise    out = mean + deviation z_k, independent random numbers of a seed
///   Pid      out = clamp(kp e + I + D + f):   I_k = I_{k−1} + ki T e_k,
///                                             D_k = (Tf D_{k−1} + kd (e_k − e_{k−1}))/(Tf + T)
///
/// What a block holds is part of State::memory: a rejected step restores it, a checkpoint stores
/// it. A block changes it in remember() at t_k and announces these instants, at which every scheme
/// ends a step. Blocks of one instant sample in the order of the model. Rejected: to sample at the
/// end of the step that contains t_k; results would depend on the step.
#pragma once
#include <cstdint>
#include <dynamy/simulation/model/time_grid.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/blocks/pid_settings.hpp>
#include <dynamy_elements/signal_formulas.hpp>

namespace dynamy {

/// The instants t_k = offset + k T.
class SampleClock {
 public:
  static void declare(Attributes& a);
  explicit SampleClock(const Parameters& x);
  double period() const { return grid_.spacing(); }
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

class Sample final : public SampledBlock {
 public:
  static void declare(Attributes& a);
  explicit Sample(const Parameters& x) : SampledBlock(x), of_(x, "of", 1) {}

 private:
  std::vector<double> held() const override { return {initial()}; }
  std::vector<SignalFormulas*> formulas() override { return {&of_}; }
  void sample(const Kinematics& k, double* held) const override { held[0] = of_.value(k); }
  SignalFormulas of_;
};

class Delay final : public SampledBlock {
 public:
  static void declare(Attributes& a);
  explicit Delay(const Parameters& x);

 private:
  /// out, then the last `samples` values, the oldest first.
  std::vector<double> held() const override;
  std::vector<SignalFormulas*> formulas() override { return {&of_}; }
  void sample(const Kinematics& k, double* held) const override;
  SignalFormulas of_;
  int samples_;
};

/// The random number of an instant follows from the seed and the number of the instant alone, so
/// that it does not depend on steps, and a rejected step draws nothing. Rejected: a generator with
/// a state.
class Noise final : public SampledBlock {
 public:
  static void declare(Attributes& a);
  explicit Noise(const Parameters& x);
  /// Number k of the sequence of a seed, SplitMix64 [Steele, Lea, Flood 2014].
  static std::uint64_t bits(std::uint64_t seed, std::uint64_t k);

 private:
  std::vector<double> held() const override { return {initial()}; }
  std::vector<SignalFormulas*> formulas() override { return {}; }
  void sample(const Kinematics& k, double* held) const override;
  std::uint64_t seed_;
  double mean_, deviation_;
  bool normal_;
};

class Pid final : public SampledBlock {
 public:
  static void declare(Attributes& a);
  explicit Pid(const Parameters& x);
  void describe(Description& d) const override;

 private:
  enum Held { kOut, kIntegral, kDerivative, kError, kSamples, kCount };
  std::vector<double> held() const override;
  std::vector<SignalFormulas*> formulas() override { return pid_.formulas(); }
  void sample(const Kinematics& k, double* held) const override;
  PidSettings pid_;
};

}  // namespace dynamy
