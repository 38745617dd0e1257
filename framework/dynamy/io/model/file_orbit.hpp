/// Periodic orbits of a model file (theory 54).
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/simulation/orbit/orbit.hpp>

namespace dynamy {

/// What is wanted, as it is written on a command line.
struct FileOrbit {
  std::filesystem::path file;
  std::string section = {};              ///< "SIGNAL=VALUE+" or "…-"; empty: that of the model
  double period = 0.0;                   ///< of a forcing [s]; 0: none
  int returns = 0;                       ///< passes in one orbit; 0: as in the model, or 1
  std::vector<std::string> mirror = {};  ///< as in OrbitSection; empty: that of the model
  Overrides set = {};                    ///< values of parameters
  Overrides start = {};    ///< values of coordinates and velocities where the search begins
  double tolerance = 0.0;  ///< 0: 1e-12
};

/// The model and the section of its orbit. Throws ModelError, also if nothing says where it is.
Model loadOrbitModel(const FileOrbit& wanted, Registry& registry, PluginLoader& plugins,
                     OrbitSection& section);

/// The initial state of the model with the values of `start`.
State startOf(const Model& model, const FileOrbit& wanted);

/// As orbit(). Throws ModelError, also for unknown names.
Orbit orbit(const FileOrbit& wanted, Registry& registry, PluginLoader& plugins);

/// Writes the members of an object.
void writeOrbit(JsonWriter& json, const Orbit& orbit);

}  // namespace dynamy
