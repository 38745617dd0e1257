/// Parameters of a model file from measurements (theory 56).
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/simulation/fit/fit.hpp>

namespace dynamy {

/// What is wanted, as it is written on a command line.
struct FileFit {
  struct Run {
    std::filesystem::path data;  ///< CSV, see measurement_file.hpp
    /// Values in this run alone: of parameters, and of coordinates and velocities at its start.
    Overrides set = {};
    std::vector<MeasuredValue> measured = {};  ///< in place of a file; named after `data`
  };
  std::filesystem::path file;
  std::vector<Run> runs;
  std::vector<std::string> parameters;  ///< to be found, with one value for all runs
  std::vector<std::string> each = {};   ///< to be found, with a value of its own for each run
  Overrides set = {};                   ///< values of parameters, where the search begins
  Overrides sigma = {};                 ///< standard deviations of signals that have none: "0.5mm"
  Overrides bounds = {};                ///< "0:1", "0:", ":1"
  Overrides priors = {};                ///< known beforehand: "0.3+-0.05"
  double tolerance = 0.0;               ///< of the runs; 0: the model's, or 1e-9 if it has none
};

/// "throw.csv:h=1.2,ball.vx=2" → a run. Throws ModelError.
FileFit::Run runOfText(const std::string& text);

/// As fit(). Throws ModelError, also for unknown names.
Fit fit(const FileFit& wanted, Registry& registry, PluginLoader& plugins);

/// "mu", or "h[throw]" for a value of a run.
std::string fittedName(const Fit& fit, const FittedParameter& parameter);

/// Writes the members of an object.
void writeFit(JsonWriter& json, const Fit& fit);

/// All measurements beside the signals of the fit, as CSV.
std::string residualsCsv(const Fit& fit);

}  // namespace dynamy
