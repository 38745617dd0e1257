#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/simulation/gradient/gradient.hpp>
#include <dynamy/simulation/report/checks.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kDefault = 1e-9;  ///< tolerance of models that have none
/// δ of a parameter, as a part of its size. Central differences of smooth runs have errors of about
/// δ² and 1e-16/δ.
constexpr double kDelta = 5e-6;
constexpr int kTries = 3;  ///< with ever smaller δ, where the switches differ
/// Rounding of a value at the end of a run, in units of the value; divided by δ.
constexpr double kRounding = 32.0 * kEpsilon;
constexpr double kSmaller = 0.1;  ///< factor on δ
/// The run that tells the errors: factors on tolerance and δ.
constexpr double kLooser = 10.0, kWider = 3.0;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Runs at one tolerance.
class Differences {
 public:
  /// `model`: at the values of the request; its instants, end and checks hold for all runs.
  Differences(const ModelMaker& make, const GradientRequest& request, const Model& model,
              double tolerance, double wide)
      : make_(make),
        request_(request),
        model_(model),
        tolerance_(tolerance),
        wide_(wide),
        run_(run({}, nullptr)) {
    for (const MotionSequence::Step& s : run_.sequence.steps)
      if (s.inTime)
        throw ModelError(
            fmt::format("from t = {:.6g} s switches are so dense that the run steps in "
                        "time: it has no derivatives",
                        s.t - s.step.dt),
            "end before, or give a tolerance at which switches are located");
  }
  const FollowedRun& nominal() const { return run_; }

  /// Derivatives of all values by parameter i; empty: the switches differ, see difference().
  std::vector<double> by(std::size_t i) {
    const auto& [name, value] = request_.by[i];
    double delta = wide_ * kDelta * (value != 0.0 ? std::abs(value) : 1.0);
    for (int tries = 0; tries < kTries; ++tries, delta *= kSmaller) {
      const double above = value + delta, below = value - delta;
      const FollowedRun more = run({{name, above}}, &run_.sequence);
      const FollowedRun less = run({{name, below}}, &run_.sequence);
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
  double delta() const { return delta_; }  ///< of these derivatives
  const MotionSequence::Difference& difference() const { return difference_; }
  /// The switches differed for a larger value of the parameter, else for a smaller one.
  bool grows() const { return grows_; }

 private:
  FollowedRun run(const std::vector<Varied>& changed, const MotionSequence* like) const {
    Model model = make_(changed);
    model.checks = request_.checks ? model_.checks : std::vector<CheckSettings>();
    model.simulation.until = request_.checks ? model_.simulation.until : lastInstant();
    return followedRun(model, request_.of, tolerance_, like);
  }
  double lastInstant() const {
    double t = 0.0;
    for (const SignalAt& s : request_.of) t = std::max(t, s.t);
    return t;
  }
  const ModelMaker& make_;
  const GradientRequest& request_;
  const Model& model_;
  double tolerance_, wide_, delta_ = 0.0;
  FollowedRun run_;
  MotionSequence::Difference difference_;
  bool grows_ = false;
};

/// Instants and signals of the request in full.
void complete(const Model& model, GradientRequest& request) {
  if (request.tolerance <= 0.0)
    request.tolerance = model.simulation.tolerance > 0.0 ? model.simulation.tolerance : kDefault;
  const double end = model.simulation.until;
  if (request.of.empty() && !request.checks)
    for (const NamedSignal* s : chooseSignals(model, {}, {}))
      request.of.push_back({s->name, kNone});
  for (SignalAt& s : request.of) {
    if (std::isnan(s.t)) s.t = end;
    if (!(s.t >= 0.0 && s.t <= end))
      throw ModelError(fmt::format("\"{}\" is wanted at {} s, but the run goes from 0 to {} s",
                                   s.signal, s.t, end),
                       "let the model run longer, or choose an instant in between");
  }
}

std::string refusal(const Model& model, const Differences& runs, const std::string& name) {
  const MotionSequence::Difference& d = runs.difference();
  return fmt::format(
      "at t = {:.6g} s {} otherwise as soon as {} {}: there is no derivative", d.t,
      d.contact == kNoContact ? "the motion goes on" : contactText(model, d.contact) + " switches",
      name, runs.grows() ? "grows" : "shrinks");
}

void addChecks(const Model& model, std::vector<GradientValue>& values) {
  Checks checks(model);
  const std::vector<CheckResult> results = checks.results(RunReport{});
  for (std::size_t i = 0; i < results.size(); ++i) {
    const CheckSettings& c = model.checks[i];
    const bool value = c.measure == CheckSettings::Measure::value;
    const double at = value ? c.at : c.to;
    values.push_back(
        {.of = c.signal,
         .at = std::isfinite(at) ? at : model.simulation.until,
         .measure = results[i].measure + (results[i].over.empty() ? "" : " " + results[i].over)});
  }
}

}  // namespace

Gradient gradient(const ModelMaker& make, GradientRequest request) {
  Model model = make({});
  complete(model, request);
  Gradient out;
  out.tolerance = request.tolerance;
  for (const SignalAt& s : request.of) out.values.push_back({.of = s.signal, .at = s.t});
  if (request.checks) addChecks(model, out.values);
  Differences runs(make, request, model, request.tolerance, 1.0);
  Differences looser(make, request, model, kLooser * request.tolerance, kWider);
  for (const MotionSequence::Step& s : runs.nominal().sequence.steps) {
    out.switches += s.switches, out.impacts += s.impacts.empty() ? 0 : 1;
  }
  for (std::size_t k = 0; k < out.values.size(); ++k) {
    out.values[k].value = runs.nominal().values[k];
    out.values[k].error = std::abs(looser.nominal().values[k] - out.values[k].value);
  }
  for (std::size_t i = 0; i < request.by.size(); ++i) {
    out.by.push_back(request.by[i].first);
    const std::vector<double> d = runs.by(i);
    const std::vector<double> rough = d.empty() ? d : looser.by(i);
    out.refused.push_back(d.empty()       ? refusal(model, runs, out.by[i])
                          : rough.empty() ? refusal(model, looser, out.by[i])
                                          : std::string());
    for (std::size_t k = 0; k < out.values.size(); ++k) {
      const bool good = out.refused[i].empty();
      out.values[k].d.push_back(good ? d[k] : kNone);
      const double rounding = kRounding * std::abs(out.values[k].value) / runs.delta();
      out.values[k].dError.push_back(good ? std::abs(rough[k] - d[k]) + rounding : kNone);
    }
  }
  return out;
}

}  // namespace dynamy
