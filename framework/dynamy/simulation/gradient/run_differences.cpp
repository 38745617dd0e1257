#include <cmath>
#include <dynamy/core/error.hpp>
#include <dynamy/simulation/gradient/run_differences.hpp>
#include <limits>
#include <optional>

namespace dynamy {
namespace {

constexpr double kSmaller = 0.1;  ///< factor on δ
/// δ of runs that choose their own steps: their error is that of the integration over δ.
constexpr double kAcross = 1e-4;

}  // namespace

RunDifferences::RunDifferences(Run run, double wide)
    : make_(std::move(run)), wide_(wide), run_(make_({}, nullptr)) {}

double RunDifferences::steppedFrom() const {
  for (const MotionSequence::Step& s : run_.sequence.steps)
    if (s.inTime) return s.t - s.step.dt;
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> RunDifferences::by(const Varied& parameter, double size, int tries) {
  const auto& [name, value] = parameter;
  double delta = wide_ * kDelta * size;
  for (; tries > 0; --tries, delta *= kSmaller) {
    const double above = value + delta, below = value - delta;
    const FollowedRun more = make_({{name, above}}, &run_.sequence);
    const FollowedRun less = make_({{name, below}}, &run_.sequence);
    difference_ = more.sequence.from(run_.sequence), grows_ = true;
    if (!difference_.any) difference_ = less.sequence.from(run_.sequence), grows_ = false;
    if (difference_.any) continue;
    std::vector<double> out;
    for (std::size_t k = 0; k < run_.values.size(); ++k)
      out.push_back((more.values[k] - less.values[k]) / (above - below));
    delta_ = delta;
    return out;
  }
  return {};
}

std::vector<double> RunDifferences::across(const Varied& parameter, double size) const {
  const auto& [name, value] = parameter;
  std::vector<double> out;
  std::optional<ModelError> fault;
  for (const double sign : {1.0, -1.0}) {
    const double moved = value + sign * kAcross * size;
    try {
      const FollowedRun other = make_({{name, moved}}, nullptr);
      const bool first = out.empty();
      out.resize(run_.values.size());
      for (std::size_t k = 0; k < out.size(); ++k) {
        const double d = (other.values[k] - run_.values[k]) / (moved - value);
        if (first || std::abs(d) < std::abs(out[k])) out[k] = d;
      }
    } catch (const ModelError& e) {
      fault = e;
    }
  }
  if (out.empty()) throw ModelError(*fault);
  return out;
}

}  // namespace dynamy
