#include <fmt/format.h>

#include <algorithm>
#include <dynamy/io/model/driving_forces.hpp>
#include <map>

namespace dynamy {
namespace {

/// Instants, as parts of the run, at which forces at the start are compared; no common periods.
constexpr double kLooks[] = {0.0, 0.0031, 0.0173, 0.071, 0.293, 0.617, 0.941};

/// The forces of a model that differ between instants at the state of its start.
std::vector<const ExternalForce*> drivingForces(Model& model) {
  std::vector<const ExternalForce*> out;
  MechanicalSystem system = model.mechanicalSystem();
  std::vector<char> withheld(model.forces().size(), 1);
  for (std::size_t i = 0; i < model.forces().size(); ++i) {
    withheld[i] = 0;
    State x = model.initialState();
    const double t0 = x.t;
    Eigen::VectorXd first;
    bool differs = false;
    for (const double look : kLooks) {
      x.t = t0 + look * model.simulation.until;
      const Eigen::VectorXd& h = system.evaluate(x, {.withheld = withheld}).h;
      if (first.size() == 0) first = h;
      differs = differs || h != first;
    }
    if (differs) out.push_back(model.forces()[i].get());
    withheld[i] = 1;
  }
  return out;
}

}  // namespace

ModelError namingDrivingForces(const ModelError& error, const std::filesystem::path& file,
                               const Overrides& set, Registry& registry, PluginLoader& plugins) {
  std::map<std::string, double> parameters;
  LoadOptions options;
  options.set = set, options.parameters = &parameters;
  Model model = loadModel(file, registry, plugins, options);
  const std::vector<const ExternalForce*> forces = drivingForces(model);
  if (forces.empty() || error.diagnostics().empty()) return error;

  Diagnostic d = error.diagnostics().front();
  const ExternalForce& one = *forces.front();
  d.hint =
      fmt::format("<{}> in {}:{} depends on t", one.type(), one.place().file, one.place().line);
  if (forces.size() > 1) d.hint += fmt::format(", and {} more", forces.size() - 1);
  options.parameters = nullptr;
  for (const auto& [name, value] : parameters) {
    if (value == 0.0) continue;
    options.set = set, options.set.emplace_back(name, "0");
    try {
      Model other = loadModel(file, registry, plugins, options);
      if (!drivingForces(other).empty()) continue;
    } catch (const ModelError&) {
      continue;  // 0 is no value for this parameter
    }
    d.hint += fmt::format(": --set {}=0 switches {} off", name, forces.size() > 1 ? "them" : "it");
    break;
  }
  return ModelError(d);
}

}  // namespace dynamy
