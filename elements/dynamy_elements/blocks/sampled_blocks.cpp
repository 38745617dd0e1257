#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/blocks/sampled_blocks.hpp>

namespace dynamy {

// ---- Sample ------------------------------------------------------------------------------------

void Sample::declare(Attributes& a) {
  a.about(
      "Sample and hold: out is the value of a formula at the last of the instants "
      "offset + k period. Every scheme ends a step at each of them. Signal: out.");
  a.add(AttributeType::expression, "of", std::nullopt, "formula of t and signals");
  declareSampled(a);
  a.example("<Sample name=\"speed\" of=\"cart.vx\" period=\"10ms\"/>");
}

// ---- Delay -------------------------------------------------------------------------------------

void Delay::declare(Attributes& a) {
  a.about(
      "Delay line: out is the value of a formula some samples ago, held from sample to sample. "
      "Signal: out.");
  a.add(AttributeType::expression, "of", std::nullopt, "formula of t and signals");
  a.add(AttributeType::integer, "samples", "1", "number of periods by which out is late")
      .between(1, 100000);
  declareSampled(a);
  a.example("<Delay name=\"late\" of=\"cart.x\" samples=\"5\" period=\"1ms\"/>");
}

Delay::Delay(const Parameters& x)
    : SampledBlock(x), of_(x, "of", 1), samples_(x["samples"].integer()) {}

std::vector<double> Delay::held() const {
  return std::vector<double>(static_cast<std::size_t>(samples_) + 1, initial());
}

void Delay::sample(const Kinematics& k, double* held) const {
  held[0] = held[1];
  std::copy(held + 2, held + 1 + samples_, held + 1);
  held[samples_] = of_.value(k);
}

// ---- Noise -------------------------------------------------------------------------------------

void Noise::declare(Attributes& a) {
  a.about(
      "Random numbers, one at each of the instants offset + k period, held in between. They depend "
      "on the seed and on k alone: the same with every scheme and step. Signal: out.");
  a.add(AttributeType::integer, "seed", "1", "which sequence").between(0, 2000000000);
  a.choice("distribution", {"normal", "uniform"}, "normal",
           "uniform: between mean - sqrt(3) deviation and mean + sqrt(3) deviation");
  a.optional("deviation", Unit::any, 1.0, "standard deviation").nonNegative();
  a.optional("mean", Unit::any, 0.0, "mean");
  declareSampled(a);
  a.example("<Noise name=\"noise\" seed=\"7\" deviation=\"0.01\" period=\"1ms\"/>");
}

Noise::Noise(const Parameters& x)
    : SampledBlock(x),
      seed_(static_cast<std::uint64_t>(x["seed"].integer())),
      mean_(x["mean"]),
      deviation_(x["deviation"]),
      normal_(x["distribution"].text == "normal") {}

std::uint64_t Noise::bits(std::uint64_t seed, std::uint64_t k) {
  std::uint64_t z = seed + (k + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

void Noise::sample(const Kinematics& k, double* held) const {
  const auto number = static_cast<std::uint64_t>(std::max(0.0, clock().last(k.t())));
  // Sequences of neighbouring seeds would be the same one, shifted.
  const std::uint64_t own = bits(seed_, 0);
  const auto uniform = [&](std::uint64_t i) {  // in (0, 1)
    return (static_cast<double>(bits(own, i) >> 11) + 0.5) * 0x1p-53;
  };
  const double a = uniform(2 * number), b = uniform(2 * number + 1);
  const double z = normal_ ? std::sqrt(-2.0 * std::log(a)) * std::cos(2.0 * kPi * b)  // Box–Muller
                           : std::sqrt(12.0) * (a - 0.5);
  held[0] = mean_ + deviation_ * z;
}

// ---- Pid ---------------------------------------------------------------------------------------

void Pid::declare(Attributes& a) {
  a.about(
      "Sampled PID controller: at t_k = offset + k T, out = clamp(kp e + I + D + f), held until "
      "the "
      "next sample; I += ki T e, D = (Tf D + kd (e - e_before))/(Tf + T). Signals: out, error, "
      "integral, derivative.");
  PidSettings::declare(
      a,
      "rate of the error as a formula of t and signals: D = kd rate; default: from differences of "
      "the error");
  declareSampled(a);
  a.example(
      "<Pid name=\"pid\" error=\"0.5 - cart.x\" kp=\"40\" ki=\"10\" kd=\"8\" period=\"10ms\" "
      "lower=\"-20\" upper=\"20\"/>");
}

Pid::Pid(const Parameters& x) : SampledBlock(x), pid_(x) {}

std::vector<double> Pid::held() const {
  std::vector<double> out(kCount, 0.0);
  out[kOut] = initial();
  return out;
}

void Pid::sample(const Kinematics& k, double* held) const {
  const double T = clock().period(), e = pid_.error.value(k);
  // The first sample has no difference.
  const double change = held[kSamples] > 0.0 ? e - held[kError] : 0.0;
  held[kDerivative] = pid_.rate.empty()
                          ? (pid_.filter * held[kDerivative] + pid_.kd * change) / (pid_.filter + T)
                          : pid_.kd * pid_.rate.value(k);
  const double rest = pid_.kp * e + held[kDerivative] + pid_.feedforward.value(k);
  const double step = pid_.ki * T * e;
  double I = held[kIntegral] + step;
  if (pid_.staysAt(rest + I, step)) I = held[kIntegral];
  held[kOut] = pid_.limited(rest + I);
  if (pid_.antiWindup == PidSettings::AntiWindup::back)
    I += T / pid_.tracking * (held[kOut] - (rest + I));
  held[kIntegral] = I, held[kError] = e, held[kSamples] += 1.0;
}

void Pid::describe(Description& d) const {
  SampledBlock::describe(d);
  const auto held = [&d](const char* name, const char* text, int i) {
    d.signal(name, Unit::any, text, [i](const SignalView& v) { return v.memory[1 + i]; });
  };
  held("error", "error at the last sample", kError);
  held("integral", "integral part I of the output", kIntegral);
  held("derivative", "derivative part D of the output", kDerivative);
}

}  // namespace dynamy
