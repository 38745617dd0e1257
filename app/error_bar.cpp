#include "error_bar.hpp"

#include <fmt/format.h>

#include <cmath>

namespace dynamy::app {

std::vector<double> errorBars(const std::vector<CheckResult>& whole,
                              const std::vector<CheckResult>& half) {
  std::vector<double> out;
  for (std::size_t i = 0; i < whole.size(); ++i)
    out.push_back(2.0 * std::abs(whole[i].got - half[i].got));
  return out;
}

std::string errorBarsText(Program& program, RunChoice choice,
                          const std::vector<CheckResult>& whole) {
  RunChoice own = choice;
  const SimulationSettings given = chosenModel(program, own).simulation;
  const bool tolerance = given.tolerance > 0.0;
  if (tolerance)
    choice.tolerance = 0.1 * given.tolerance;
  else
    choice.step = 0.5 * given.step;
  Model model = chosenModel(program, choice);
  Simulation simulation(model);
  const RunReport& report = simulation.run();
  std::string out =
      tolerance ? fmt::format(" error bars by a run with a tenth of the tolerance, {:g}:\n",
                              choice.tolerance)
                : fmt::format(" error bars by a run with half the step, {:g} s:\n", choice.step);
  if (whole.empty()) out += "   the model has no <check>: nothing to compare\n";
  if (report.ended != RunReport::Ended::finished)
    return out + "   it ended early: " + report.reason + '\n';
  const std::vector<CheckResult> half = simulation.checks();
  const std::vector<double> bars = errorBars(whole, half);
  for (std::size_t i = 0; i < whole.size(); ++i)
    out += fmt::format("   {}{} = {:.9g} ± {:.2g}\n",
                       whole[i].measure == "value" ? "" : whole[i].measure + " ", whole[i].signal,
                       whole[i].got, bars[i]);
  return out;
}

}  // namespace dynamy::app
