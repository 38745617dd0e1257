/// Blocks: elements that exert no force and give a signal `out`, which formulas read (theory 55).
/// Those here are sampled:
///
///   Sample   out = f(t_k)
///   Delay    out = f(t_{k−n})
///   Noise    out = mean + deviation z_k, independent random numbers of a seed
///   Pid      out = clamp(kp e + I + D + f):   I_k = I_{k−1} + ki T e_k,
///                                             D_k = (Tf D_{k−1} + kd (e_k − e_{k−1}))/(Tf + T)
#pragma once
#include <cstdint>
#include <dynamy_elements/blocks/pid_settings.hpp>
#include <dynamy_elements/blocks/sampled_block.hpp>

namespace dynamy {

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
