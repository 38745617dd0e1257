#include "sweep/sweep_row.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/run_files/run_facts.hpp>
#include <dynamy/simulation/report/run_watch.hpp>
#include <dynamy/simulation/report/signal_sampler.hpp>

#include "run/run_text.hpp"

namespace dynamy::app {
namespace {

constexpr std::size_t kMostEnds = 12;

/// Reads measure, signal, and instant or interval: "max ball.z", "ball.z@1.5s", "mean ball.z@2..5".
CheckSettings measureOf(const std::string& text) {
  const auto fail = [&](const std::string& why) {
    throw CLI::ValidationError("--measure", '"' + text + "\": " + why);
  };
  using Measure = CheckSettings::Measure;
  const std::vector<std::pair<std::string, Measure>> kWords = {
      {"value", Measure::value}, {"mean", Measure::mean},     {"min", Measure::min},
      {"max", Measure::max},     {"period", Measure::period}, {"count", Measure::count}};
  CheckSettings c;
  const std::size_t blank = text.find(' '), at = text.find('@');
  c.signal =
      text.substr(blank == std::string::npos ? 0 : blank + 1,
                  at == std::string::npos ? at : at - (blank == std::string::npos ? 0 : blank + 1));
  if (blank != std::string::npos) {
    std::vector<std::string> known;
    for (const auto& [word, measure] : kWords) known.push_back(word);
    const std::string word = text.substr(0, blank);
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) fail("no measure \"" + word + "\" — " + unknownNameHint(word, known));
    c.measure = kWords[static_cast<std::size_t>(found - known.begin())].second;
  }
  if (c.signal.empty()) fail("expected [MEASURE] SIGNAL[@TIME] or SIGNAL[@FROM..TO]");
  if (at == std::string::npos) return c;
  const std::string when = text.substr(at + 1);
  const std::size_t dots = when.find("..");
  if ((dots == std::string::npos) != (c.measure == Measure::value))
    fail(dots == std::string::npos ? "an instant goes with a value, an interval FROM..TO with this"
                                   : "a value is taken at one instant");
  if (dots == std::string::npos) {
    c.at = instant(when, "--measure");
  } else {
    c.from = instant(when.substr(0, dots), "--measure");
    c.to = seconds(when.substr(dots + 2), "--measure");
  }
  return c;
}

/// Inserts the measures of the sweep as checks before the model's own checks.
void addMeasures(Model& model, const std::vector<std::string>& measures) {
  std::vector<CheckSettings> all;
  for (const std::string& text : measures) {
    CheckSettings& c = all.emplace_back(measureOf(text));
    c.low = -std::numeric_limits<double>::infinity();
    c.high = std::numeric_limits<double>::infinity();
    c.text = "measured";
  }
  model.checks.insert(model.checks.begin(), all.begin(), all.end());
}

/// Throws ModelError for a measure of a signal that the model does not have, or of a time after its
/// end.
void verifyMeasures(const Model& model, const std::vector<std::string>& measures) {
  for (const std::string& text : measures) {
    const CheckSettings c = measureOf(text);
    const std::string& signal = c.signal;
    const double last = c.measure == CheckSettings::Measure::value ? c.at : c.to;
    if (const double until = model.simulation.until; std::isfinite(last) && last > until)
      throw ModelError(
          fmt::format("--measure {}: the run ends at {:g} s, before {:g} s", text, until, last),
          "take a later --until, or an earlier time");
    if (model.signal(signal) != nullptr || runFigure(signal) != nullptr) continue;
    std::vector<std::string> known;
    for (const NamedSignal& s : model.signals()) known.push_back(s.name);
    throw ModelError("--measure " + text + ": no signal \"" + signal + '"',
                     unknownNameHint(signal, known));
  }
}

std::string unitOf(const Model& model, const CheckSettings& c) {
  if (c.measure == CheckSettings::Measure::count) return {};
  if (c.measure == CheckSettings::Measure::period) return "s";
  const NamedSignal* const signal = model.signal(c.signal);
  if (signal == nullptr || unitText(signal->signal.unit) == "-") return {};
  return std::string(unitText(signal->signal.unit));
}

/// The recorded signals at the end, as default measures of a sweep.
std::vector<std::string> endsOf(const Model& model) {
  std::vector<std::string> out;
  for (const NamedSignal* s : chooseSignals(model, model.record.signals, model.record.places))
    if (out.size() < kMostEnds) out.push_back(s->name);
  return out;
}

struct Result {
  RunReport report;
  std::vector<CheckResult> checks;
  std::string error;
};

Result run(Program& program, const Sweep& sweep, const SweepFolder& folder, std::size_t id) {
  Result out;
  RunChoice choice = sweep.choiceOf(id);
  Model model = chosenModel(program, choice);
  addMeasures(model, sweep.measures);
  if (sweep.keep) {
    RunShow show;
    show.tell = [&out](const RunReport& report, const std::vector<CheckResult>& checks) {
      out.report = report, out.checks = checks;
    };
    runInto(folder.run(id), model, choice, show, out.checks);
  } else {
    Simulation simulation(model);
    out.report = simulation.run();
    out.checks = simulation.checks();
  }
  return out;
}

std::string lineOf(const Sweep& sweep, std::size_t id, const Result& result) {
  std::string out = std::to_string(id);
  const auto number = [&out](double x) { out += ',', appendNumber(out, x); };
  int failed = 0;
  for (std::size_t k = 0; k < sweep.columns.size(); ++k) {
    const bool there = k < result.checks.size();
    number(there ? result.checks[k].got : std::numeric_limits<double>::quiet_NaN());
    failed += there && !result.checks[k].pass && k >= sweep.measures.size();
  }
  const RunReport& r = result.report;
  const bool finished = r.ended == RunReport::Ended::finished && result.error.empty();
  out += !result.error.empty() ? ",error" : finished ? ",finished" : ",failed";
  for (const double x :
       {static_cast<double>(failed), r.t, static_cast<double>(r.steps),
        static_cast<double>(r.solver.iterations), static_cast<double>(r.contacts.impacts),
        static_cast<double>(r.contacts.switches), static_cast<double>(r.solver.unconverged),
        r.gaps.penetration.value, r.gaps.jointError.value, r.energy.end(), r.energy.discretisation})
    number(x);
  out += ',' + hashText(r.hash) + ',';
  appendCsvField(out, finished ? qualifyingKinds(r, {}, "; ") : ""), out += ',';
  appendCsvField(out, result.error.empty() ? r.reason : result.error);
  return out + '\n';
}

}  // namespace

std::vector<Column> factColumns() {
  return {{"state", ""},        {"failed checks", ""}, {"t", "s"},       {"steps", ""},
          {"iterations", ""},   {"impacts", ""},       {"switches", ""}, {"unconverged", ""},
          {"penetration", "m"}, {"joint error", "m"},  {"energy", "J"},  {"discretisation", "J"},
          {"hash", ""},         {"warnings", ""},      {"message", ""}};
}

void verify(Program& program, Sweep& sweep, std::size_t id) {
  RunChoice choice = sweep.choiceOf(id);
  std::vector<std::filesystem::path> files;
  Model model = chosenModel(program, choice, &files);
  sweep.choice.model = choice.model;
  sweep.fingerprint = fingerprintOf(files), sweep.title = model.title;
  if (sweep.measures.empty() && model.checks.empty()) sweep.measures = endsOf(model);
  addMeasures(model, sweep.measures);
  verifyMeasures(model, sweep.measures);
  const Simulation verified(model);  // verifies the step and the signals of the measures
  const std::vector<CheckResult> checks = verified.checks();
  const bool first = sweep.columns.empty();
  for (std::size_t k = 0; k < checks.size(); ++k) {
    const std::size_t asked = sweep.measures.size();
    const std::string name = k < asked ? sweep.measures[k] : checkText(checks[k]);
    if (first)
      sweep.columns.push_back({name, unitOf(model, model.checks[k])});
    else if (k < sweep.columns.size() && sweep.columns[k].name != name)
      // The instant of this check depends on a varied parameter.
      sweep.columns[k].name =
          (checks[k].measure == "value" ? checks[k].signal
                                        : checks[k].measure + " " + checks[k].signal) +
          " (check " + std::to_string(k - asked + 1) + ')';
  }
}

void prepare(Program& program, const Sweep& sweep) {
  program.load();
  for (const Fingerprint& library : sweep.choice.loaded)
    program.plugins.load(library, program.registry);
  RunChoice choice = sweep.choiceOf(1);
  std::vector<std::filesystem::path> files;
  try {
    chosenModel(program, choice, &files);
  } catch (const ModelError&) {  // each run reports the fault in its line
  }
  if (fingerprintOf(files) != sweep.fingerprint)
    throw ModelError(sweep.choice.model + " has changed since the sweep began",
                     "start it again with --restart, or with another --out");
}

bool computeRun(Program& program, const Sweep& sweep, const SweepFolder& folder, std::size_t id,
                const Claim& claim) {
  Result result;
  try {
    result = run(program, sweep, folder, id);
  } catch (const ModelError& e) {
    result.error = format(e.diagnostics());
  } catch (const CLI::ValidationError& e) {
    result.error = e.what();
  }
  if (result.report.ended == RunReport::Ended::stopped) return false;
  folder.finish(id, claim, lineOf(sweep, id, result));
  return true;
}

}  // namespace dynamy::app
