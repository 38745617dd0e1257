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
/// Differences on one side: δ, the factor to the smaller one, and how much larger a derivative may
/// be with it. One that grows as δ^(-1/2), as beside grazing, becomes 3.2 times larger.
constexpr double kSideDelta = 1e-5, kSideSmaller = 0.1, kGrowth = 2.0;
constexpr int kSideTries = 3;
constexpr double kNoSide = std::numeric_limits<double>::quiet_NaN();

/// False: value k is an instant, and one of the three runs has another event in its place.
bool isSmooth(const FollowedRun& run, const FollowedRun& more, const FollowedRun& less,
              std::size_t k) {
  const std::size_t first = run.firstInstant, last = first + run.events.size();
  if (k < first || k >= last) return true;
  const double a = less.values[k], b = run.values[k], c = more.values[k];
  constexpr double kBend = 0.1,
                   kRoot = 1e-9;  // of the change; of the instant, as roots are located
  return std::abs(a - 2.0 * b + c) <= kBend * std::abs(c - a) + kRoot * std::abs(b);
}

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
      out.push_back(isSmooth(run_, more, less, k)
                        ? (more.values[k] - less.values[k]) / (above - below)
                        : kNoSide);
    delta_ = delta;
    return out;
  }
  return {};
}

std::vector<double> RunDifferences::byFour(const Varied& parameter, double size) const {
  const auto& [name, value] = parameter;
  constexpr int kParts[] = {-2, -1, 1, 2};
  const double delta = wide_ * kWideDelta * size;
  FollowedRun runs[4];
  for (int i = 0; i < 4; ++i) {
    runs[i] = make_({{name, value + kParts[i] * delta}}, &run_.sequence);
    if (runs[i].sequence.from(run_.sequence).any) return {};
  }
  std::vector<double> out;
  for (std::size_t k = 0; k < run_.values.size(); ++k) {
    const double inner = runs[2].values[k] - runs[1].values[k];
    const double outer = runs[3].values[k] - runs[0].values[k];
    out.push_back(isSmooth(run_, runs[3], runs[0], k) ? (8.0 * inner - outer) / (12.0 * delta)
                                                      : kNoSide);
  }
  return out;
}

/// One difference with a signed δ, without errors; empty: the runs have other switches.
RunDifferences::Side RunDifferences::sideOnce(const Varied& parameter, double delta) const {
  const auto& [name, value] = parameter;
  const double p[3] = {value + delta, value + 2.0 * delta, value + 3.0 * delta};
  const FollowedRun middle = make_({{name, p[1]}}, nullptr);
  const FollowedRun near = make_({{name, p[0]}}, &middle.sequence);
  const FollowedRun far = make_({{name, p[2]}}, &middle.sequence);
  if (near.sequence.from(middle.sequence).any || far.sequence.from(middle.sequence).any) return {};
  // Value and derivative at p of the parabola through the three.
  Side out;
  for (std::size_t k = 0; k < middle.values.size(); ++k) {
    const double v[3] = {near.values[k], middle.values[k], far.values[k]};
    out.d.push_back((-5.0 * v[0] + 8.0 * v[1] - 3.0 * v[2]) / (p[2] - p[0]));
    out.limit.push_back(3.0 * (v[0] - v[1]) + v[2]);
  }
  return out;
}

RunDifferences::Side RunDifferences::side(const Varied& parameter, double size, double sign) const {
  const std::size_t n = run_.values.size();
  const std::vector<double> none(n, kNoSide);
  Side out{none, none, none};
  double delta = sign * wide_ * kSideDelta * size;
  for (int tries = kSideTries; tries > 0; --tries, delta *= kSmaller) {
    Side wide, close;
    try {
      wide = sideOnce(parameter, delta);
      if (!wide.d.empty()) close = sideOnce(parameter, kSideSmaller * delta);
    } catch (const ModelError&) {  // no run on this side: it starts within a body, say
      return out;
    }
    if (close.d.empty()) continue;
    for (std::size_t k = 0; k < n; ++k) {
      const double rounding = 8.0 * kRounding * run_.sizes[k] / std::abs(delta);
      if (std::abs(close.d[k]) > kGrowth * std::abs(wide.d[k]) + rounding / kSideSmaller) continue;
      out.d[k] = wide.d[k], out.limit[k] = wide.limit[k];
      out.error[k] = std::abs(close.d[k] - wide.d[k]) + rounding;
    }
    return out;
  }
  return out;
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
