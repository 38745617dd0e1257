/// Loads a model file into a model that is ready to run. All errors of the files are thrown
/// together, each with file, line, column and the nearest known name.
///
/// Order: files and includes → parameters → names → elements → settings → build → signals. A later
/// stage runs only if the earlier ones found no error that would make its messages wrong.
#pragma once
#include <dynamy/io/model/model_source.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dynamy {

struct OrbitSection;

struct LoadOptions {
  Overrides set;      ///< parameters: (name, value)
  bool build = true;  ///< false: the caller changes the model and calls build() itself
  std::optional<JointCoordinates> coordinates = {};  ///< instead of those in the file
  /// Signals that the caller needs, and coordinates and velocities; parameters may be among them.
  /// Where one of them is of a body or a joint alone, joints stay constraints unless the file says
  /// otherwise.
  std::vector<std::string> signals = {}, numbers = {};
  /// Called before the model is built, to change its settings and methods; null: nothing changes.
  std::function<void(Model&)> prepare = {};
  /// True: the model may be computed in fewer coordinates (SimulationSettings::reduce), where the file
  /// leaves them to the program. For runs alone: q and u change.
  bool reduce = false;
  /// End time that the caller sets afterwards [s]: instants up to it are no faults. 0: none.
  double until = 0.0;
  bool seek = true;  ///< false: `start="equilibrium"` of the model is not followed
  /// Receives the paths of the model, its included files, its plug-ins and the files that elements
  /// name (tables, meshes), including files that were not found, and even if the model is faulty. A program that waits for changes watches
  /// these files.
  std::vector<std::filesystem::path>* files = nullptr;
  /// Receives the values of all parameters by the names that `set` takes.
  std::map<std::string, double>* parameters = nullptr;
  /// Receives the section of `<orbit>`; unchanged if the file has none.
  OrbitSection* orbit = nullptr;
};

/// Reads the model in `file` and builds it. The types it uses must be registered already, except
/// those of its own `<plugin>`, which are added to `registry`. Throws ModelError.
Model loadModel(const std::filesystem::path& file, Registry& registry, PluginLoader& plugins,
                const LoadOptions& options = {});

/// Reads a model from text. `name`: name of the file in messages; paths of includes are relative to
/// `folder`.
Model loadModelText(std::string text, const std::string& name, Registry& registry,
                    PluginLoader& plugins, const LoadOptions& options = {},
                    const std::filesystem::path& folder = ".");

}  // namespace dynamy
