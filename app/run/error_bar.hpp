/// The error bar of a figure: twice its change when the step is halved or the tolerance is divided
/// by ten. For a scheme of order one the bar is the error; for a higher order it is larger than the
/// error. The bar cannot show an error that both runs share.
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/run_files/run_difference.hpp>
#include <dynamy/simulation/report/checks.hpp>

#include "run/run_job.hpp"

namespace dynamy::app {

/// Error bars of the checks `whole` of a run, from the checks `half` of a run with half the step.
std::vector<double> errorBars(const std::vector<CheckResult>& whole,
                              const std::vector<CheckResult>& half);

/// Error bars of a run, obtained from a second run.
struct ErrorBars {
  double tolerance = 0.0, step = 0.0;  ///< of the second run; one of them is 0
  std::string reason;                  ///< why the second run ended early; "": it did not
  std::vector<CheckResult> checks;     ///< checks of the first run
  std::vector<double> bars;            ///< error bar of each check
  RunDifference difference;            ///< differences of all recorded signals
};

/// Runs `choice` again with half the step or a tenth of the tolerance, without a folder. Compares
/// the checks with those of the first run, `whole`, and the recorded signals with those of the
/// first run in the file `signals`. If differences grow exponentially, the result also has the time
/// up to which the motion is predictable. Throws FileError.
ErrorBars errorBars(Program& program, RunChoice choice, const std::vector<CheckResult>& whole,
                    const std::filesystem::path& signals);

/// The error bars as some lines of text for people.
std::string errorBarsText(const ErrorBars& bars);
/// Writes the member `errorBars` of run.json.
void writeErrorBars(JsonWriter& json, const ErrorBars& bars);

}  // namespace dynamy::app
