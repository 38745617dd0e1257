#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/simulation/gradient/gradient.hpp>
#include <dynamy/simulation/model/initial_values.hpp>
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
const std::string kInstant = "instant";  ///< measure of an event
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool isInitial(const GradientRequest& request, const std::string& name) {
  return std::find(request.initial.begin(), request.initial.end(), name) != request.initial.end();
}

/// Runs at one tolerance. `model`: at the values of the request; its end and checks hold for all.
RunDifferences differences(const ModelMaker& make, const GradientRequest& request,
                           const Model& model, double tolerance, double wide) {
  double end = 0.0;
  for (const SignalAt& s : request.of) end = std::max(end, s.t);
  if (request.checks || !request.instants.empty()) end = model.simulation.until;
  RunDifferences out(
      [&make, &request, &model, tolerance, end](const std::vector<Varied>& changed,
                                                const MotionSequence* like) {
        std::vector<Varied> parameters;
        for (const Varied& v : changed)
          if (!isInitial(request, v.first)) parameters.push_back(v);
        Model run = make(parameters);
        run.checks = request.checks ? model.checks : std::vector<CheckSettings>();
        run.simulation.until = end;
        FollowedRunOptions options{.like = like, .instants = &request.instants};
        State from;
        for (const auto& [name, value] : changed) {
          if (!isInitial(request, name)) continue;
          if (options.from == nullptr) from = run.initialState();
          changeInitialValue(run, name, value, from);
          options.from = &from;
        }
        return followedRun(run, request.of, tolerance, options);
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
  if (request.of.empty() && request.instants.empty() && !request.checks)
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

/// Names of the contact elements, as contactName() makes them.
std::vector<std::string> contactElements(const Model& model) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < model.contacts().size(); ++i)
    out.push_back(contactName(model, ContactKey{std::uint64_t{i} << 40}));
  return out;
}

/// Throws where an event does not happen in the run.
void refuseMissing(const Model& model, const GradientRequest& request, const FollowedRun& run) {
  for (std::size_t i = 0; i < request.instants.size(); ++i) {
    const WantedInstant& w = request.instants[i];
    if (run.events[i] >= w.count) continue;
    const std::vector<std::string> known = contactElements(model);
    const bool named = std::any_of(known.begin(), known.end(), [&](const std::string& name) {
      return w.of.rfind(name, 0) == 0 || name.rfind(w.of, 0) == 0;
    });
    const bool ofContact =
        w.what == WantedInstant::What::impact || w.what == WantedInstant::What::status;
    if (ofContact && !named && run.events[i] == 0)
      throw ModelError('"' + w.text + "\": no contact named \"" + w.of + '"',
                       unknownNameHint(w.of, known));
    throw ModelError(fmt::format("\"{}\": the run to {} s has {} of these events, not {}", w.text,
                                 model.simulation.until, run.events[i], w.count),
                     "let the model run longer, or choose an earlier event");
  }
}

/// Values of a run and their errors.
void addValues(Gradient& out, const FollowedRun& run, const FollowedRun& looser) {
  for (const MotionSequence::Step& s : run.sequence.steps)
    out.switches += s.switches, out.impacts += s.impacts.empty() ? 0 : 1;
  for (std::size_t k = 0; k < out.values.size(); ++k) {
    out.values[k].value = run.values[k];
    out.values[k].error = std::abs(looser.values[k] - run.values[k]);
    if (out.values[k].measure == kInstant) out.values[k].at = run.values[k];
  }
}

/// Derivatives towards either side, for parameter i.
void addSides(Gradient& out, std::size_t i, const RunDifferences& runs,
              const RunDifferences& looser, const Varied& by, double size) {
  constexpr double kSeen = 10.0;  // a jump is larger than this many errors of the value
  for (const double sign : {-1.0, 1.0}) {
    const RunDifferences::Side side = runs.side(by, size, sign);
    const RunDifferences::Side rough = looser.side(by, size, sign);
    for (std::size_t k = 0; k < out.values.size(); ++k) {
      GradientValue& v = out.values[k];
      SideDerivative s;
      s.limit = side.limit[k];
      if (!std::isnan(rough.d[k])) {
        s.d = side.d[k], s.error = side.error[k] + std::abs(rough.d[k] - side.d[k]);
        const double apart = std::abs(s.limit - v.value),
                     error = std::abs(rough.limit[k] - s.limit);
        s.jumps = apart > kSeen * (v.error + error + RunDifferences::kRounding * std::abs(v.value));
      }
      auto& all = sign < 0.0 ? v.left : v.right;
      all.resize(i), all.push_back(s);
    }
  }
}

/// Replaces derivatives that are less accurate than they should be by differences of order 4, where
/// these have smaller errors. That of the integration remains; where it is the larger part, the runs
/// of order 4 to the smaller tolerance are saved, and after three such parameters all of them.
class Refinement {
 public:
  Refinement(const RunDifferences& runs, const RunDifferences& looser)
      : runs_(runs), looser_(looser) {}
  /// For parameter i. `rough`: its derivatives by the looser runs.
  void refine(Gradient& out, std::size_t i, const std::vector<double>& rough, const Varied& by,
              double size) {
    if (vain_ >= kPatience || !wanted(out, i, size)) return;
    const std::vector<double> rough4 = looser_.byFour(by, size);
    if (rough4.empty()) return;
    if (!helps(out, i, rough, rough4)) {
      ++vain_;
      return;
    }
    vain_ = 0;
    const std::vector<double> d = runs_.byFour(by, size);
    for (std::size_t k = 0; k < d.size(); ++k) {
      GradientValue& v = out.values[k];
      const double rounding = kWeights * RunDifferences::kRounding * runs_.nominal().sizes[k] /
                              (RunDifferences::kWideDelta * size);
      const double error = std::abs(rough4[k] - d[k]) + rounding;
      if (error < v.dError[i]) v.d[i] = d[k], v.dError[i] = error;
    }
  }

 private:
  static constexpr int kPatience = 3;
  static constexpr double kWeights = 18.0 / 12.0;  // sum of those of (53.4), times δ

  static bool wanted(const Gradient& out, std::size_t i, double size) {
    constexpr double kWanted = 1e-8;  // of max(|d|, |v/p|)
    return std::any_of(out.values.begin(), out.values.end(), [&](const GradientValue& v) {
      return v.dError[i] > kWanted * std::max(std::abs(v.d[i]), std::abs(v.value) / size);
    });
  }
  /// Order 4 moves a derivative of the looser runs, or takes rounding away, by a part of its error that
  /// is worth it.
  bool helps(const Gradient& out, std::size_t i, const std::vector<double>& rough,
             const std::vector<double>& rough4) const {
    constexpr double kPart = 0.25;
    for (std::size_t k = 0; k < rough4.size(); ++k) {
      const double rounding = RunDifferences::kRounding * runs_.nominal().sizes[k] / runs_.delta();
      if (std::abs(rough4[k] - rough[k]) + rounding > kPart * out.values[k].dError[i]) return true;
    }
    return false;
  }

  const RunDifferences &runs_, &looser_;
  int vain_ = 0;  ///< parameters in a row that order 4 did not help
};

/// Adds the error of the values to that of their derivatives by parameter i, in proportion
/// (theory 53.2): runs to two tolerances may agree by chance.
void addErrorOfRun(Gradient& out, std::size_t i, double size) {
  for (GradientValue& v : out.values) {
    const double d = std::abs(v.d[i]), whole = std::max(std::abs(v.value), d * size);
    if (whole > 0.0) v.dError[i] += d * v.error / whole;
  }
}

}  // namespace

Gradient gradient(const ModelMaker& make, GradientRequest request) {
  Model model = make({});
  complete(model, request);
  Gradient out;
  out.tolerance = request.tolerance;
  for (const SignalAt& s : request.of) out.values.push_back({.of = s.signal, .at = s.t});
  for (const WantedInstant& w : request.instants)
    out.values.push_back({.of = w.text, .measure = kInstant});
  if (request.checks) addChecks(model, out.values);
  RunDifferences runs = differences(make, request, model, request.tolerance, 1.0);
  refuseMissing(model, request, runs.nominal());
  RunDifferences looser = differences(make, request, model, kLooser * request.tolerance, kWider);
  addValues(out, runs.nominal(), looser.nominal());
  Refinement refinement(runs, looser);
  for (std::size_t i = 0; i < request.by.size(); ++i) {
    out.by.push_back(request.by[i].first);
    const double size = request.by[i].second != 0.0 ? std::abs(request.by[i].second) : 1.0;
    const std::vector<double> d = runs.by(request.by[i], size, kTries);
    const std::vector<double> rough = d.empty() ? d : looser.by(request.by[i], size, kTries);
    out.refused.push_back(d.empty()       ? refusal(model, runs, out.by[i])
                          : rough.empty() ? refusal(model, looser, out.by[i])
                                          : std::string());
    const bool good = out.refused[i].empty();
    for (std::size_t k = 0; k < out.values.size(); ++k) {
      out.values[k].d.push_back(good ? d[k] : kNone);
      const double rounding = RunDifferences::kRounding * runs.nominal().sizes[k] / runs.delta();
      out.values[k].dError.push_back(good ? std::abs(rough[k] - d[k]) + rounding : kNone);
    }
    if (good) {
      refinement.refine(out, i, rough, request.by[i], size);
      addErrorOfRun(out, i, size);
    } else {
      addSides(out, i, runs, looser, request.by[i], size);
    }
  }
  for (GradientValue& v : out.values)
    for (auto* side : {&v.left, &v.right})
      if (!side->empty()) side->resize(out.by.size());
  return out;
}

}  // namespace dynamy
