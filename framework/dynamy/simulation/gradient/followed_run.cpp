#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/simulation/gradient/followed_run.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <memory>
#include <utility>

namespace dynamy {

const NamedSignal* signalNamed(const Model& model, const std::string& name) {
  if (const NamedSignal* s = model.signal(name)) return s;
  std::vector<std::string> known;
  for (const NamedSignal& s : model.signals()) known.push_back(s.name);
  throw ModelError("no signal named \"" + name + '"', unknownNameHint(name, known));
}

namespace {

std::vector<const NamedSignal*> signalsOf(const Model& model, const std::vector<SignalAt>& of) {
  std::vector<const NamedSignal*> out;
  for (const SignalAt& s : of) out.push_back(signalNamed(model, s.signal));
  return out;
}

class Located final : public LocatedDormandPrince {
 public:
  explicit Located(bool givenSteps)
      : LocatedDormandPrince(Parameters::of<LocatedDormandPrince>("", "", {}),
                             {.givenSteps = givenSteps, .oneClock = true}) {}
};

/// Sees every step: notes what happened, and takes the signals at their instants.
class Watch final : public Observer {
 public:
  Watch(const Model& model, const std::vector<SignalAt>& of, const std::vector<double>& stops,
        const LocatedDormandPrince& scheme)
      : of_(of), stops_(stops), scheme_(scheme), sampler_(model, signalsOf(model, of)) {
    run.values.resize(of.size()), run.sizes.resize(of.size());
    // Angles follow from directions, whose rounding is that of numbers of size 1.
    for (std::size_t i = 0; i < of.size(); ++i)
      if (signalNamed(model, of[i].signal)->signal.unit == Unit::angle) run.sizes[i] = 1.0;
  }
  void start(const StepView& initial) override { sample(initial, -1.0); }
  void step(const StepView& view) override {
    const double t = view.after.t;
    const bool stop = std::any_of(stops_.begin(), stops_.end(), [&](double at) {
      return isPassed(at, t) && !isPassed(at, view.before.t);
    });
    run.sequence.add(view, scheme_.endedByMotion() ? PlannedStep::End::ofMotion
                           : stop                  ? PlannedStep::End::atStop
                                                   : PlannedStep::End::bounded);
    if (stop) sample(view, view.before.t);
    for (std::size_t i = 0; measures && i < of_.size(); ++i)
      if (!isPassed(of_[i].t, view.before.t))
        run.sizes[i] = std::max(run.sizes[i], std::abs(sampler_.sampleOne(view, 1.0, i)));
  }
  FollowedRun run;
  bool measures = true;  ///< takes sizes

 private:
  /// The signals whose instants are after `before`, up to the end of the step.
  void sample(const StepView& view, double before) {
    for (std::size_t i = 0; i < of_.size(); ++i)
      if (isPassed(of_[i].t, view.after.t) && !isPassed(of_[i].t, before))
        run.values[i] = sampler_.sampleOne(view, 1.0, i);
  }
  const std::vector<SignalAt>& of_;
  const std::vector<double>& stops_;
  const LocatedDormandPrince& scheme_;
  SignalSampler sampler_;
};

}  // namespace

ModelError denseSwitches(double t) {
  return ModelError(
      fmt::format("from t = {:.6g} s switches are so dense that the run steps in time: "
                  "its return has no derivatives",
                  t),
      "give a tolerance at which switches are located");
}

std::unique_ptr<LocatedDormandPrince> locatedScheme(bool givenSteps) {
  return std::make_unique<Located>(givenSteps);
}

FollowedRun followedRun(Model& model, const std::vector<SignalAt>& of, double tolerance,
                        const FollowedRunOptions& options) {
  auto scheme = locatedScheme(options.like != nullptr);
  LocatedDormandPrince& located = *scheme;
  model.askTolerance(tolerance);
  model.scheme(std::move(scheme));
  StepPlan plan;
  plan.from = options.from;
  for (const SignalAt& s : of) plan.stops.push_back(s.t);
  plan.stops.push_back(model.simulation.until);
  std::sort(plan.stops.begin(), plan.stops.end());
  plan.stops.erase(std::unique(plan.stops.begin(), plan.stops.end()), plan.stops.end());
  const std::vector<double> stops = plan.stops;
  if (options.like != nullptr) plan.steps = options.like->plan();
  Watch watch(model, of, stops, located);
  watch.measures = options.like == nullptr;
  Simulation simulation(model, &plan);
  simulation.observe(watch);
  const std::vector<WantedInstant> none;
  EventInstants instants(model, options.instants != nullptr ? *options.instants : none);
  if (options.instants != nullptr && !options.instants->empty()) simulation.observe(instants);
  while (simulation.step()) {
    const StepReport& last = simulation.lastStep();
    if (options.located && last.counts.stepped) throw denseSwitches(simulation.state().t - last.dt);
    if (options.most > 0 && simulation.report().steps > options.most)
      throw ModelError(fmt::format("the motion needs more than {} steps", options.most));
  }
  const RunReport& report = simulation.report();
  if (report.ended != RunReport::Ended::finished)
    throw ModelError(fmt::format("the run ended at {:.6g} s: {}", report.t, report.reason));
  watch.run.firstInstant = watch.run.values.size();
  for (const double t : instants.instants()) watch.run.values.push_back(t);
  watch.run.events = instants.counts();
  for (const CheckResult& c : simulation.checks()) watch.run.values.push_back(c.got);
  for (std::size_t i = of.size(); i < watch.run.values.size(); ++i)
    watch.run.sizes.push_back(std::abs(watch.run.values[i]));
  watch.run.end = simulation.state();
  return std::move(watch.run);
}

}  // namespace dynamy
