#include "run/error_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dynamy::app {

std::vector<double> errorBars(const std::vector<CheckResult>& whole,
                              const std::vector<CheckResult>& half) {
  std::vector<double> out;
  for (std::size_t i = 0; i < whole.size(); ++i)
    out.push_back(2.0 * std::abs(whole[i].got - half[i].got));
  return out;
}

namespace {

/// Keeps the recorded signals of a run in memory.
class Table final : public RecordSink {
 public:
  explicit Table(std::size_t columns) { table.columns.resize(columns); }
  void row(double t, std::span<const double> values) override {
    table.t.push_back(t);
    for (std::size_t i = 0; i < values.size(); ++i) table.columns[i].push_back(values[i]);
  }
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  SignalTable table;
};

std::string signalsText(const RunDifference& d) {
  std::string out;
  std::size_t width = 0;
  for (const SignalDifference& s : d.signals) width = std::max(width, s.name.size());
  for (const SignalDifference& s : d.signals)
    out +=
        fmt::format("   {:<{}}  at the end {:>15.9g} ± {:<8.2g}  at most {:.2g} (t = {:.4g} s)\n",
                    s.name, width, s.end, s.difference, s.largest, s.t);
  if (d.chaotic)
    out += fmt::format("   differences grow tenfold every {:.3g} s: the motion is chaotic\n",
                       std::log(10.0) / d.growth);
  if (std::isfinite(d.horizon))
    out += fmt::format(
        "   a tenth of the range of a signal {} t = {:.4g} s: beyond, no figure of "
        "a single motion means anything\n",
        d.signals.empty() ? "" : "is lost at", d.horizon);
  return out;
}

}  // namespace

ErrorBars errorBars(Program& program, RunChoice choice, const std::vector<CheckResult>& whole,
                    const std::filesystem::path& signals) {
  RunChoice own = choice;
  const SimulationSettings given = chosenModel(program, own).simulation;
  ErrorBars out;
  if (given.tolerance > 0.0)
    choice.tolerance = out.tolerance = given.tolerance / 10.0;
  else
    choice.step = out.step = 0.5 * given.step;
  Model model = chosenModel(program, choice);
  model.record.framesPerSecond = 0.0;
  const SignalTable first = readSignals(signals);
  Table second(first.columns.size());
  Simulation simulation(model);
  simulation.record(second);
  const RunReport& report = simulation.run();
  if (report.ended != RunReport::Ended::finished) {
    out.reason = report.reason;
    return out;
  }
  out.checks = whole;
  out.bars = errorBars(whole, simulation.checks());
  out.difference = runDifference(first, second.table);
  return out;
}

std::string errorBarsText(const ErrorBars& b) {
  std::string out =
      b.tolerance > 0.0
          ? fmt::format(" error bars by a run with a tenth of the tolerance, {:g}:\n", b.tolerance)
          : fmt::format(" error bars by a run with half the step, {:g} s:\n", b.step);
  if (!b.reason.empty()) return out + "   it ended early: " + b.reason + '\n';
  for (std::size_t i = 0; i < b.checks.size(); ++i)
    out += fmt::format("   {}{} = {:.9g} ± {:.2g}\n",
                       b.checks[i].measure == "value" ? "" : b.checks[i].measure + " ",
                       b.checks[i].signal, b.checks[i].got, b.bars[i]);
  return out + signalsText(b.difference);
}

void writeErrorBars(JsonWriter& json, const ErrorBars& b) {
  json.key("errorBars").beginObject();
  json.member("tolerance", b.tolerance).member("step", b.step);
  if (!b.reason.empty()) json.member("reason", b.reason);
  json.key("checks").beginArray();
  for (std::size_t i = 0; i < b.checks.size(); ++i)
    json.beginObject()
        .member("signal", b.checks[i].signal)
        .member("measure", b.checks[i].measure)
        .member("got", b.checks[i].got)
        .member("bar", b.bars[i])
        .endObject();
  json.endArray().key("signals").beginArray();
  for (const SignalDifference& s : b.difference.signals)
    json.beginObject()
        .member("name", s.name)
        .member("end", s.end)
        .member("bar", s.difference)
        .member("largest", s.largest)
        .member("t", s.t)
        .endObject();
  json.endArray().member("growth", b.difference.growth).member("chaotic", b.difference.chaotic);
  json.member("horizon", b.difference.horizon).endObject();
}

}  // namespace dynamy::app
