#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/simulation/gradient/gradient.hpp>
#include <dynamy/simulation/report/checks.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kDefault = 1e-9;  ///< tolerance of models that have none
constexpr int kTries = 3;          ///< with ever smaller δ, where the switches differ
/// The run that tells the errors: factors on tolerance and δ.
constexpr double kLooser = 10.0, kWider = 3.0;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Runs at one tolerance. `model`: at the values of the request; its end and checks hold for all.
RunDifferences differences(const ModelMaker& make, const GradientRequest& request,
                           const Model& model, double tolerance, double wide) {
  double end = 0.0;
  for (const SignalAt& s : request.of) end = std::max(end, s.t);
  if (request.checks) end = model.simulation.until;
  RunDifferences out(
      [&make, &request, &model, tolerance, end](const std::vector<Varied>& changed,
                                                const MotionSequence* like) {
        Model run = make(changed);
        run.checks = request.checks ? model.checks : std::vector<CheckSettings>();
        run.simulation.until = end;
        return followedRun(run, request.of, tolerance, like);
      },
      wide);
  if (const double t = out.steppedFrom(); !std::isnan(t))
    throw ModelError(fmt::format("from t = {:.6g} s switches are so dense that the run steps in "
                                 "time: it has no derivatives",
                                 t),
                     "end before, or give a tolerance at which switches are located");
  return out;
}

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

std::string refusal(const Model& model, const RunDifferences& runs, const std::string& name) {
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
  RunDifferences runs = differences(make, request, model, request.tolerance, 1.0);
  RunDifferences looser = differences(make, request, model, kLooser * request.tolerance, kWider);
  for (const MotionSequence::Step& s : runs.nominal().sequence.steps) {
    out.switches += s.switches, out.impacts += s.impacts.empty() ? 0 : 1;
  }
  for (std::size_t k = 0; k < out.values.size(); ++k) {
    out.values[k].value = runs.nominal().values[k];
    out.values[k].error = std::abs(looser.nominal().values[k] - out.values[k].value);
  }
  for (std::size_t i = 0; i < request.by.size(); ++i) {
    out.by.push_back(request.by[i].first);
    const double size = request.by[i].second != 0.0 ? std::abs(request.by[i].second) : 1.0;
    const std::vector<double> d = runs.by(request.by[i], size, kTries);
    const std::vector<double> rough = d.empty() ? d : looser.by(request.by[i], size, kTries);
    out.refused.push_back(d.empty()       ? refusal(model, runs, out.by[i])
                          : rough.empty() ? refusal(model, looser, out.by[i])
                                          : std::string());
    for (std::size_t k = 0; k < out.values.size(); ++k) {
      const bool good = out.refused[i].empty();
      out.values[k].d.push_back(good ? d[k] : kNone);
      const double rounding =
          RunDifferences::kRounding * std::abs(out.values[k].value) / runs.delta();
      out.values[k].dError.push_back(good ? std::abs(rough[k] - d[k]) + rounding : kNone);
    }
  }
  return out;
}

}  // namespace dynamy
