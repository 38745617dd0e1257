#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/run/sample_instants.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Instants of different grids that differ by this part of them are one: larger than the rounding
/// of times and than the distance at which located steps end beside an instant.
constexpr double kSame = 1e-12;

}  // namespace

SampleInstants::SampleInstants(const Model& model) {
  for (const NamedSignal& s : model.signals())
    if (s.name == kNextSample || s.name.ends_with("." + std::string(kNextSample)))
      next_.push_back(s.signal.value);
  if (const double period = model.simulation.sampleEvery; period > 0.0)
    next_.push_back(
        [period](const SignalView& v) { return period * (std::floor(v.t / period) + 1.0); });
}

double SampleInstants::after(double t) const {
  double first = std::numeric_limits<double>::infinity();
  SignalView view;
  view.t = t + kSame * std::abs(t);
  for (const SignalFunction& next : next_) first = std::min(first, next(view));
  return first;
}

bool SampleInstants::isWithin(double at, double tE) { return at < tE - kSame * std::abs(tE); }

}  // namespace dynamy
