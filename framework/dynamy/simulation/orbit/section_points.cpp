#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/simulation/gradient/followed_run.hpp>
#include <dynamy/simulation/linear/state_variation.hpp>
#include <dynamy/simulation/orbit/section_points.hpp>
#include <dynamy/simulation/orbit/section_watch.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/simulation/run/time_loop.hpp>

namespace dynamy {
namespace {

/// All velocities begin this much larger than on the orbit: from an unstable one the motion leaves.
constexpr double kDisturbed = 1e-2;
constexpr long kMostStepsToPass = 20'000;

/// Keeps the coordinates and velocities at each pass.
class Passes final : public Observer {
 public:
  Passes(const Model& model, const OrbitSection& section, int transient)
      : section_(section),
        left_(transient),
        watch_(model, section, kPassed, 1),
        sampler_(model, coordinates(model)) {}
  void start(const StepView& initial) override { watch_.start(initial); }
  void step(const StepView& view) override {
    watch_.step(view);
    ++sinceLast_;
    if (!section_.signal.empty() && watch_.found()) pass(view, watch_.part());
    const double period = section_.period;
    if (section_.signal.empty() && isPassed(period * (passes_ + 1.0), view.after.t))
      pass(view, 1.0);
  }
  std::vector<std::vector<double>> states;
  long sinceLast() const { return sinceLast_; }  ///< steps
  double last() const { return last_; }          ///< pass [s]

 private:
  static constexpr double kPassed = 1e-9;  // the start itself may pass the section
  static std::vector<const NamedSignal*> coordinates(const Model& model) {
    std::vector<const NamedSignal*> out;
    for (const auto& [name, value] : coordinatesOf(model, model.initialState()))
      out.push_back(signalNamed(model, name));
    return out;
  }
  void pass(const StepView& view, double part) {
    ++passes_, sinceLast_ = 0;
    last_ = view.before.t + part * view.report.dt;
    watch_.next(1);
    if (left_-- > 0) return;
    states.emplace_back(sampler_.signals().size());
    sampler_.sample(view, part, states.back());
  }
  const OrbitSection& section_;
  int left_, passes_ = 0;
  SectionWatch watch_;
  SignalSampler sampler_;
  long sinceLast_ = 0;
  double last_ = 0.0;
};

}  // namespace

std::vector<std::vector<double>> sectionPoints(Model& model, const OrbitSection& section,
                                               const State& start,
                                               const SectionPointsRequest& request) {
  const int all = request.transient + request.kept;
  const double longest = section.signal.empty() ? section.period : model.simulation.until;
  State from = start;
  from.u *= 1.0 + kDisturbed;
  StepPlan plan;
  plan.from = &from;
  for (int i = 1; section.signal.empty() && i <= all; ++i) plan.stops.push_back(i * longest);
  model.checks.clear();
  model.simulation.until = all * longest;
  model.askTolerance(request.tolerance);
  model.scheme(locatedScheme(false));
  Passes passes(model, section, request.transient);
  Simulation simulation(model, &plan);
  simulation.observe(passes);
  while (static_cast<int>(passes.states.size()) < request.kept &&
         passes.sinceLast() < kMostStepsToPass && simulation.state().t - passes.last() <= longest &&
         simulation.step()) {
  }
  return std::move(passes.states);
}

}  // namespace dynamy
