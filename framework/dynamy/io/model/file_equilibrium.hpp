/// Equilibria of a model file (theory 57).
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/simulation/equilibrium/rest_range.hpp>

namespace dynamy {

/// What is wanted, as it is written on a command line.
struct FileEquilibrium {
  std::filesystem::path file;
  Overrides set = {};               ///< values of parameters
  Overrides start = {};             ///< coordinates and velocities where the search begins
  EquilibriumOptions options = {};  ///< of the search
  bool atRest = false;              ///< the velocities of the model's start are set to zero
};

/// As equilibrium(). Throws ModelError, also for unknown names.
Equilibrium equilibrium(const FileEquilibrium& wanted, Registry& registry, PluginLoader& plugins);

/// As restRanges(), for `parameter` between a and b; the model's start is not followed on its way.
std::vector<RestRange> restRanges(const FileEquilibrium& wanted, const std::string& parameter,
                                  double a, double b, int count, Registry& registry,
                                  PluginLoader& plugins);

/// Write members of an object.
void writeEquilibrium(JsonWriter& json, const Equilibrium& equilibrium);
void writeRanges(JsonWriter& json, const std::string& parameter,
                 const std::vector<RestRange>& ranges);

}  // namespace dynamy
