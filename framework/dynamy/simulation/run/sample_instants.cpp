#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/run/sample_instants.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Instants of different grids that differ by this part of them are one: larger than the rounding
/// of times and than the distance at which located steps end beside an instant.
constexpr double kSame = 1e-12;
/// Instants nearer to each other than this multiple of the rounding of t are refused, as steps are.
constexpr double kWay = 64.0;

}  // namespace

SampleInstants::SampleInstants(const Model& model) {
  const std::string ending = "." + std::string(kNextSample);
  for (const NamedSignal& s : model.signals())
    if (s.name.ends_with(ending))
      announced_.push_back({s.name.substr(0, s.name.size() - ending.size()), s.signal.value});
    else if (s.name == kNextSample)
      announced_.push_back({"an element without a name", s.signal.value});
  if (const double period = model.simulation.sampleEvery; period > 0.0)
    announced_.push_back({"the caller", [period](const SignalView& v) {
                            return period * (std::floor(v.t / period) + 1.0);
                          }});
}

double SampleInstants::after(double t) const {
  double first = std::numeric_limits<double>::infinity();
  SignalView view;
  view.t = t + kSame * std::abs(t);
  for (const Announced& a : announced_) first = std::min(first, a.next(view));
  return first;
}

std::string SampleInstants::fault(double until) const {
  const double least = kWay * kEpsilon * until;
  for (const Announced& a : announced_) {
    SignalView view;
    view.t = 0.5 * until;  // tables and pulses may have no instant near the end
    view.t = a.next(view);
    const double way = a.next(view) - view.t;
    if (!(view.t <= until) || !(way < least)) continue;
    return fmt::format(
        "samples of {} are {:.2g} s apart, which does not move t near {} s, where the run ends: "
        "take a period of {:.1g} s or more",
        a.element, way, until, 2.0 * least);
  }
  return {};
}

bool SampleInstants::isWithin(double at, double tE) { return at < tE - kSame * std::abs(tE); }

}  // namespace dynamy
