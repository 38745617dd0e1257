/// Derivatives of a run of a model file with respect to its parameters (theory 53).
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/simulation/gradient/gradient.hpp>

namespace dynamy {

/// What is wanted, as it is written on a command line.
struct FileGradient {
  std::filesystem::path file;
  /// "SIGNAL@TIME", "SIGNAL" for the end of the run; instants: "t:CONTACT=impact#2",
  /// "t:CONTACT=STATUS", "t:SIGNAL=VALUE-".
  std::vector<std::string> of;
  std::vector<std::string> by;  ///< names of parameters, or of coordinates and velocities
  Overrides set = {};           ///< values of parameters
  bool checks = false;          ///< also the values of the model's checks
  double tolerance = 0.0;       ///< 0: the model's
};

/// As gradient(). Throws ModelError, also for unknown names.
Gradient gradient(const FileGradient& wanted, Registry& registry, PluginLoader& plugins);

/// Writes the members of an object: values, and which parameters have no derivatives.
void writeGradient(JsonWriter& json, const Gradient& gradient);

}  // namespace dynamy
