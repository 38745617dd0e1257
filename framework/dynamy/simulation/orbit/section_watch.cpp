#include <algorithm>
#include <dynamy/simulation/gradient/followed_run.hpp>
#include <dynamy/simulation/orbit/section_watch.hpp>

namespace dynamy {
namespace {

constexpr int kBisections = 60;    ///< to find a pass on the path of a step
constexpr double kOfSlope = 1e-3;  ///< part of a step over which the slope is taken

std::vector<const NamedSignal*> signalOf(const Model& model, const OrbitSection& section) {
  if (section.signal.empty()) return {};
  return {signalNamed(model, section.signal)};
}

Eigen::VectorXd all(const State& x) {
  Eigen::VectorXd out(x.q.size() + x.u.size());
  out << x.q, x.u;
  return out;
}

}  // namespace

SectionWatch::SectionWatch(const Model& model, const OrbitSection& section, double least, int count)
    : section_(section), least_(least), left_(count), sampler_(model, signalOf(model, section)) {}

void SectionWatch::start(const StepView& initial) { low_ = high_ = all(initial.after); }

/// Distance from the section at a part θ of the step, positive after the pass.
double SectionWatch::side(const StepView& view, double theta) {
  return sign() * (sampler_.sampleOne(view, theta, 0) - section_.value);
}

void SectionWatch::step(const StepView& view) {
  const Eigen::VectorXd x = all(view.after);
  low_ = low_.cwiseMin(x), high_ = high_.cwiseMax(x);
  switches_ += view.report.counts.switches;
  if (section_.signal.empty() || found_ || view.before.t < least_) return;
  const bool jumps = view.report.uBeforeImpact != nullptr;
  const double reached =
      jumps ? sign() * (sampler_.sampleBeforeImpact(view, 0) - section_.value) : side(view, 1.0);
  if (!(side(view, 0.0) < 0.0 && reached >= 0.0) || --left_ > 0) return;
  double a = 0.0, b = 1.0;
  for (int i = 0; i < kBisections; ++i) (side(view, 0.5 * (a + b)) < 0.0 ? a : b) = 0.5 * (a + b);
  found_ = true, part_ = b;
  t_ = view.before.t + b * view.report.dt;
  const double before = std::min(kOfSlope, b);
  slope_ = -sign() * side(view, b - before) / (before * view.report.dt);
}

}  // namespace dynamy
