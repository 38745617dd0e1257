#include "error_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/io/run_difference.hpp>

namespace dynamy::app {

std::vector<double> errorBars(const std::vector<CheckResult>& whole,
                              const std::vector<CheckResult>& half) {
  std::vector<double> out;
  for (std::size_t i = 0; i < whole.size(); ++i)
    out.push_back(2.0 * std::abs(whole[i].got - half[i].got));
  return out;
}

namespace {

/// Keeps what a run records.
class Table final : public RecordSink {
 public:
  explicit Table(std::size_t columns) { table.columns.resize(columns); }
  void row(double t, std::span<const double> values) override {
    table.t.push_back(t);
    for (std::size_t i = 0; i < values.size(); ++i) table.columns[i].push_back(values[i]);
  }
  void frame(double, std::span<const FramePose>, std::span<const ContactRecord>) override {}
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

std::string errorBarsText(Program& program, RunChoice choice, const std::vector<CheckResult>& whole,
                          const std::filesystem::path& signals) {
  RunChoice own = choice;
  const SimulationSettings given = chosenModel(program, own).simulation;
  const bool tolerance = given.tolerance > 0.0;
  if (tolerance)
    choice.tolerance = 0.1 * given.tolerance;
  else
    choice.step = 0.5 * given.step;
  Model model = chosenModel(program, choice);
  model.record.framesPerSecond = 0.0;
  const SignalTable first = readSignals(signals);
  Table second(first.columns.size());
  Simulation simulation(model);
  simulation.record(second);
  const RunReport& report = simulation.run();
  std::string out =
      tolerance ? fmt::format(" error bars by a run with a tenth of the tolerance, {:g}:\n",
                              choice.tolerance)
                : fmt::format(" error bars by a run with half the step, {:g} s:\n", choice.step);
  if (report.ended != RunReport::Ended::finished)
    return out + "   it ended early: " + report.reason + '\n';
  const std::vector<CheckResult> half = simulation.checks();
  const std::vector<double> bars = errorBars(whole, half);
  for (std::size_t i = 0; i < whole.size(); ++i)
    out += fmt::format("   {}{} = {:.9g} ± {:.2g}\n",
                       whole[i].measure == "value" ? "" : whole[i].measure + " ", whole[i].signal,
                       whole[i].got, bars[i]);
  return out + signalsText(runDifference(first, second.table));
}

}  // namespace dynamy::app
