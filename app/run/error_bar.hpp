/// The error bar of a figure: twice its change when the step is halved, or the tolerance divided by
/// ten. That is its error for a scheme of order one, and more than it for a higher one; what it
/// cannot show is an error that both runs share.
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/run_files/run_difference.hpp>
#include <dynamy/simulation/report/checks.hpp>

#include "run/run_job.hpp"

namespace dynamy::app {

/// Bars of the checks of a run, from those of a run with half the step.
std::vector<double> errorBars(const std::vector<CheckResult>& whole,
                              const std::vector<CheckResult>& half);

/// What a second run says about the first.
struct ErrorBars {
  double tolerance = 0.0, step = 0.0;  ///< of the second run; one of them is 0
  std::string reason;                  ///< why it ended early; "": it did not
  std::vector<CheckResult> checks;     ///< of the first run
  std::vector<double> bars;            ///< one for each of them
  RunDifference difference;            ///< of all recorded signals
};

/// Runs `choice` again with half the step or a tenth of the tolerance, no folder written, and
/// compares the checks `whole` and the recorded signals, those of the first run in the file
/// `signals`; where differences grow exponentially, up to when the motion can be told. Throws
/// FileError.
ErrorBars errorBars(Program& program, RunChoice choice, const std::vector<CheckResult>& whole,
                    const std::filesystem::path& signals);

/// For people, some lines.
std::string errorBarsText(const ErrorBars& bars);
/// Member `errorBars` of run.json.
void writeErrorBars(JsonWriter& json, const ErrorBars& bars);

}  // namespace dynamy::app
