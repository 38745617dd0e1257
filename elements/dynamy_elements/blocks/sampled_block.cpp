#include <algorithm>
#include <cmath>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy_elements/blocks/sampled_block.hpp>
#include <limits>

namespace dynamy {
namespace {

/// An instant counts as reached this part of it before: larger than the rounding of times and than
/// the distance at which located steps end beside an instant.
constexpr double kSame = 1e-12;

/// The next number that a double can hold: count + 1 up to 2⁵³.
double following(double count) {
  return std::max(count + 1.0, std::nextafter(count, std::numeric_limits<double>::infinity()));
}

}  // namespace

// ---- SampleClock -------------------------------------------------------------------------------

void SampleClock::declare(Attributes& a) {
  a.required("period", Unit::time, "time T from sample to sample [s]").positive();
  a.optional("offset", Unit::time, 0.0, "instant of the first sample [s]").nonNegative();
}

SampleClock::SampleClock(const Parameters& x) : grid_(double(x["period"])), offset_(x["offset"]) {}

bool SampleClock::due(double t, double count) const {
  const double instant = at(count);
  return t >= instant - kSame * std::abs(instant);
}

double SampleClock::after(double t) const {
  double count = std::max(0.0, std::floor((t - offset_) / period()));
  while (due(t, count)) count = following(count);
  return count;
}

double SampleClock::next(double t) const {
  double count = std::max(0.0, std::floor((t - offset_) / period()));
  while (at(count) <= t) count = following(count);
  return at(count);
}

// ---- SampledBlock ------------------------------------------------------------------------------

void SampledBlock::declareSampled(Attributes& a) {
  SampleClock::declare(a);
  a.optional("initial", Unit::any, 0.0, "out before the first sample");
}

SampledBlock::SampledBlock(const Parameters& x)
    : ExternalForce(x), clock_(x), initial_(x["initial"]) {}

void SampledBlock::connect(Topology& topology) {
  for (SignalFormulas* f : formulas()) f->connect(topology, *this);
  std::vector<double> memory = held();
  memory.insert(memory.begin(), 0.0);
  topology.memory(*this, memory);
}

void SampledBlock::remember(const Kinematics& k, Vec memory) const {
  if (!clock_.due(k.t(), memory[0])) return;
  sample(k, memory.data() + 1);
  memory[0] = clock_.after(k.t());
}

void SampledBlock::describe(Description& d) const {
  d.signal("out", Unit::any, "output, held from sample to sample",
           [](const SignalView& v) { return v.memory[1]; });
  announceSamples(d, [this](double t) { return clock_.next(t); });
}

}  // namespace dynamy
