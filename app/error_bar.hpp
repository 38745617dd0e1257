/// The error bar of a figure: twice its change when the step is halved, or the tolerance divided by
/// ten. That is its error for a scheme of order one, and more than it for a higher one; what it
/// cannot show is an error that both runs share.
#pragma once
#include <dynamy/simulation/checks.hpp>

#include "run_job.hpp"

namespace dynamy::app {

/// Bars of the checks of a run, from those of a run with half the step.
std::vector<double> errorBars(const std::vector<CheckResult>& whole,
                              const std::vector<CheckResult>& half);

/// Runs `choice` again with half the step or a tenth of the tolerance, no folder written, and says
/// the bars of the checks `whole` and of all recorded signals, those of the run in the file
/// `signals`; where differences grow exponentially, up to when the motion can be told. Throws
/// FileError.
std::string errorBarsText(Program& program, RunChoice choice, const std::vector<CheckResult>& whole,
                          const std::filesystem::path& signals);

}  // namespace dynamy::app
