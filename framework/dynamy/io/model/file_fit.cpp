#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/model/file_fit.hpp>
#include <dynamy/io/model/measurement_file.hpp>
#include <dynamy/io/model/start_values.hpp>

namespace dynamy {
namespace {

constexpr double kRunTolerance = 1e-9;  ///< of models that have none

/// A finite number, all of the text; `what` and `hint` in the message.
double numberOf(const std::string& text, const std::string& what, const std::string& hint) {
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(x))
    throw ModelError(what + ": \"" + text + "\" is no number", hint);
  return x;
}

/// Fits as they are asked for, with names resolved.
class AskedFit {
 public:
  AskedFit(const FileFit& wanted, Registry& registry, PluginLoader& plugins)
      : wanted_(wanted), registry_(registry), plugins_(plugins) {}

  FitRequest request() {
    std::map<std::string, double> values;
    findNeeded();
    const Model model = load(wanted_.set, &values);
    for (const auto& [name, value] : values) known_.push_back(name);
    std::erase_if(numbers_, [&](const std::string& name) { return values.contains(name); });
    FitRequest out;
    out.tolerance = wanted_.tolerance > 0.0            ? wanted_.tolerance
                    : model.simulation.tolerance > 0.0 ? model.simulation.tolerance
                                                       : kRunTolerance;
    for (const bool each : {false, true})
      for (const std::string& name : each ? wanted_.each : wanted_.parameters)
        addParameter(name, each, values, out);
    if (out.parameters.empty())
      throw ModelError("nothing says which parameters to find",
                       "--parameters " + fmt::format("{}", fmt::join(known_, ",")));
    for (const auto& [name, text] : wanted_.bounds) addBounds(text, wantedNamed(name, out));
    for (const auto& [name, text] : wanted_.priors) addPrior(text, wantedNamed(name, out));
    for (const auto& [signal, text] : wanted_.sigma)
      sigma_[signal] = sigmaOf(*signalNamed(model, signal), text);
    for (const FileFit::Run& run : wanted_.runs) addRun(run, out);
    return out;
  }

 private:
  Model load(const Overrides& set, std::map<std::string, double>* values) const {
    LoadOptions options;
    options.set = set, options.parameters = values, options.signals = signals_;
    options.numbers = numbers_;
    return loadModel(wanted_.file, registry_, plugins_, options);
  }
  /// Names of signals and numbers of the runs; parameters may be among the numbers.
  void findNeeded() {
    for (const auto& [name, text] : wanted_.sigma) signals_.push_back(name);
    for (const FileFit::Run& run : wanted_.runs) {
      for (const auto& [name, text] : run.set) numbers_.push_back(name);
      for (const MeasuredValue& m : run.measured) signals_.push_back(m.signal);
      if (!run.measured.empty()) continue;
      for (const std::string& name : measuredNames(run.data))
        if (name.find('.') != std::string::npos && !name.starts_with("sigma("))
          signals_.push_back(name);
    }
  }
  bool isParameter(const std::string& name) const {
    return std::find(known_.begin(), known_.end(), name) != known_.end();
  }

  void addParameter(const std::string& name, bool each, const std::map<std::string, double>& values,
                    FitRequest& out) {
    if (!isParameter(name))
      throw ModelError("no parameter \"" + name + '"', unknownNameHint(name, known_));
    for (const WantedParameter& p : out.parameters)
      if (p.name == name)
        throw ModelError("the parameter \"" + name + "\" is to be found twice",
                         "once for all runs (--parameters), or for each run (--each)");
    WantedParameter& p = out.parameters.emplace_back();
    p.name = name, p.start = values.at(name), p.each = each;
  }

  static WantedParameter& wantedNamed(const std::string& name, FitRequest& out) {
    std::vector<std::string> known;
    for (WantedParameter& p : out.parameters) {
      if (p.name == name) return p;
      known.push_back(p.name);
    }
    throw ModelError('"' + name + "\" is no parameter that is to be found",
                     unknownNameHint(name, known));
  }

  static void addBounds(const std::string& text, WantedParameter& p) {
    const std::string hint = "write both, mu=0:1, or one, mu=0:";
    const std::string what = "bounds of " + p.name;
    const std::size_t at = text.find(':');
    if (at == std::string::npos) throw ModelError(what + ": \"" + text + "\" has no \":\"", hint);
    if (at > 0) p.lower = numberOf(text.substr(0, at), what, hint);
    if (at + 1 < text.size()) p.upper = numberOf(text.substr(at + 1), what, hint);
    if (!(p.lower < p.upper)) throw ModelError(what + ": nothing is between them", hint);
  }

  static void addPrior(const std::string& text, WantedParameter& p) {
    const std::string hint = "write the value and its standard deviation, mu=0.3+-0.05";
    const std::string what = "prior of " + p.name;
    std::size_t at = text.find("+-"), length = 2;
    if (at == std::string::npos) at = text.find("±"), length = std::string("±").size();
    if (at == std::string::npos) throw ModelError(what + ": \"" + text + "\" has no \"+-\"", hint);
    p.priorMean = numberOf(text.substr(0, at), what, hint);
    p.priorSigma = numberOf(text.substr(at + length), what, hint);
    if (!(p.priorSigma > 0.0)) throw ModelError(what + ": a standard deviation is > 0", hint);
  }

  static double sigmaOf(const NamedSignal& signal, const std::string& text) {
    const double sigma = quantityOf(signal.signal.unit, text, signal.name + '=' + text);
    if (!(sigma > 0.0))
      throw ModelError("standard deviation of " + signal.name + ": must be > 0, is " + text);
    return sigma;
  }

  void addRun(const FileFit::Run& run, FitRequest& out) {
    Overrides set = wanted_.set, start;
    MeasuredRun& r = out.runs.emplace_back();
    r.name = nameFor(run, out);
    for (const auto& [name, text] : run.set) {
      if (!isParameter(name)) {
        start.emplace_back(name, text);
        continue;
      }
      set.emplace_back(name, text);
      for (const WantedParameter& p : out.parameters)
        if (p.name == name && !p.each)
          throw ModelError(r.name + ": \"" + name +
                               "\" is to be found for all runs together, so one "
                               "run cannot set it",
                           "find it for each run (--each " + name + "), or leave it out here");
    }
    std::map<std::string, double> values;
    const Model model = load(set, &values);
    for (const WantedParameter& p : out.parameters)
      if (p.each) r.own.emplace_back(p.name, values.at(p.name));
    r.data = run.measured.empty() ? readMeasurements(run.data, model) : checked(run, model);
    for (MeasuredValue& m : r.data)
      if (const auto known = sigma_.find(m.signal); known != sigma_.end() && std::isnan(m.sigma))
        m.sigma = known->second;
    r.make = [this, set](const std::vector<Varied>& changed) {
      Overrides all = set;
      for (const auto& [name, value] : changed) all.emplace_back(name, fmt::format("{}", value));
      return load(all, nullptr);
    };
    if (start.empty()) return;
    r.start = [start](const Model& of) {
      State x = of.initialState();
      for (const auto& [name, text] : start) placeInState(of, name, text, x);
      return x;
    };
    r.start(model);  // tells unknown names
  }

  /// The name of its file without the ending; the second of that name gets a number.
  static std::string nameFor(const FileFit::Run& run, const FitRequest& out) {
    const std::string stem = run.data.stem().string();
    std::string name = stem;
    const auto taken = [&] {
      return std::any_of(out.runs.begin(), out.runs.end() - 1,
                         [&](const MeasuredRun& r) { return r.name == name; });
    };
    for (int k = 2; taken(); ++k) name = fmt::format("{} {}", stem, k);
    return name;
  }

  static std::vector<MeasuredValue> checked(const FileFit::Run& run, const Model& model) {
    const double end = model.simulation.until;
    for (const MeasuredValue& m : run.measured) {
      signalNamed(model, m.signal);
      if (!(m.t >= 0.0 && m.t <= end))
        throw ModelError(
            fmt::format("{}: the time {:g} s is not within the run, which goes from 0 "
                        "to {:g} s",
                        run.data.string(), m.t, end));
      if (!std::isfinite(m.value) || m.sigma <= 0.0 || std::isinf(m.sigma))
        throw ModelError(
            fmt::format("{}: {} at {:g} s has no finite value or no standard "
                        "deviation > 0",
                        run.data.string(), m.signal, m.t));
    }
    return run.measured;
  }

  const FileFit& wanted_;
  Registry& registry_;
  PluginLoader& plugins_;
  std::vector<std::string> known_;  // parameters of the model
  // What the runs are measured by, and coordinates and velocities that they start with.
  std::vector<std::string> signals_, numbers_;
  std::map<std::string, double> sigma_;
};

const char* intervalText(FittedParameter::Interval interval) {
  switch (interval) {
    case FittedParameter::Interval::none:
      return "none";
    case FittedParameter::Interval::gaussian:
      return "gaussian";
    case FittedParameter::Interval::profile:
      return "profile";
  }
  return "none";
}

}  // namespace

FileFit::Run runOfText(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t at = equals == std::string::npos ? equals : text.rfind(':', equals);
  if (at == std::string::npos) return {text};
  FileFit::Run out{text.substr(0, at)};
  for (std::size_t begin = at + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::size_t sign = part.find('=');
    if (sign == 0 || sign == std::string::npos || sign + 1 == part.size())
      throw ModelError('"' + text + "\": \"" + part + "\" sets nothing",
                       "write values of this run behind its file, throw.csv:h=1.2,ball.vx=2");
    out.set.emplace_back(part.substr(0, sign), part.substr(sign + 1));
    begin = end + 1;
  }
  return out;
}

Fit fit(const FileFit& wanted, Registry& registry, PluginLoader& plugins) {
  AskedFit asked(wanted, registry, plugins);
  return fit(asked.request());
}

std::string fittedName(const Fit& fit, const FittedParameter& p) {
  if (p.run < 0) return p.name;
  return p.name + '[' + fit.runs[static_cast<std::size_t>(p.run)].name + ']';
}

void writeFit(JsonWriter& j, const Fit& f) {
  j.key("parameters").beginObject();
  for (const FittedParameter& p : f.parameters) {
    j.key(fittedName(f, p)).beginObject().member("value", p.value);
    j.key("interval").beginArray().value(p.low).value(p.high).endArray();
    j.member("identifiable", p.identifiable).member("kind", intervalText(p.interval));
    j.member("sigma", p.sigma).member("atBound", p.atBound).endObject();
  }
  j.endObject().key("covariance").beginArray();
  for (const auto& row : f.covariance.rowwise()) j.values(row);
  j.endArray().member("chi2", f.chi2).member("freedom", f.freedom).member("priors", f.priors);
  j.key("signals").beginObject();
  for (const FittedSignal& s : f.signals) {
    j.key(s.signal).beginObject().member("sigma", s.sigma).member("estimated", s.estimated);
    j.member("measurements", s.count).endObject();
  }
  j.endObject().key("runs").beginArray();
  for (const FittedRun& r : f.runs) {
    j.beginObject().member("name", r.name).member("measurements", r.count).member("chi2", r.chi2);
    j.member("motions", r.effort.runs).member("derivatives", r.effort.evaluations);
    j.member("reordered", r.effort.reordered).member("acrossSwitches", r.effort.across);
    j.member("ended", r.effort.ended).member("otherOrderInInterval", r.otherOrder).endObject();
  }
  j.endArray().key("open").values(f.unknown);
  j.member("converged", f.converged).member("why", f.why).member("iterations", f.iterations);
  j.member("tolerance", f.tolerance);
}

std::string residualsCsv(const Fit& f) {
  std::string out = "run,t,signal,measured,sigma,fitted,residual\n";
  for (const FittedPoint& p : f.points) {
    appendCsvField(out, f.runs[static_cast<std::size_t>(p.run)].name);
    out += ',';
    appendNumber(out, p.measured.t);
    out += ',';
    appendCsvField(out, p.measured.signal);
    for (const double x : {p.measured.value, p.measured.sigma, p.fitted,
                           (p.measured.value - p.fitted) / p.measured.sigma}) {
      out += ',';
      appendNumber(out, x);
    }
    out += '\n';
  }
  return out;
}

}  // namespace dynamy
