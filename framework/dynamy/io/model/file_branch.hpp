/// A periodic orbit of a model file, followed over a parameter (theory 54.5).
#pragma once
#include <dynamy/io/model/file_orbit.hpp>
#include <dynamy/simulation/orbit/orbit_branch.hpp>

namespace dynamy {

/// What is wanted, as it is written on a command line.
struct FileBranch {
  FileOrbit orbit;
  std::string over;  ///< "NAME=FROM:TO" or "NAME=FROM:TO:COUNT"
  int brute = 0;     ///< values of the parameter at which the motion itself is recorded, too
};

/// Where a motion passes the section after a transient.
struct BrutePoint {
  double p = 0.0;
  std::vector<double> state;  ///< by OrbitBranch::signals
};

struct NamedBranch {
  std::string parameter;
  OrbitBranch branch;
  std::vector<BrutePoint> brute;
};

/// As orbitBranch(). The first orbit is that of the model's own value, or of `set`; if this is
/// outside of the range, the branch begins at the nearest end of it. Throws ModelError, also for
/// unknown names.
NamedBranch branch(const FileBranch& wanted, Registry& registry, PluginLoader& plugins);

/// A table with a row a point: parameter, period, state, multipliers, stable, bifurcation.
std::string branchCsv(const NamedBranch& branch);

/// A table with a row a pass of the plain runs: parameter, state.
std::string bruteCsv(const NamedBranch& branch);

/// Writes the members of an object: ends, and points where something happens.
void writeBranch(JsonWriter& json, const NamedBranch& branch);

}  // namespace dynamy
