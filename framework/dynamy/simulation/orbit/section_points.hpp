/// sectionPoints: where a motion passes the section after a transient, for diagrams of what a motion
/// does of itself beside branches of orbits.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/orbit/orbit_section.hpp>
#include <vector>

namespace dynamy {

struct SectionPointsRequest {
  int transient = 100, kept = 24;  ///< passes, each of them also if an orbit has several
  double tolerance = 1e-8;         ///< of the runs
};

/// Coordinates and velocities at each pass of one run that begins near `start`, in the order of
/// coordinatesOf(). Fewer if the motion no longer comes back within the time of the model's run.
std::vector<std::vector<double>> sectionPoints(Model& model, const OrbitSection& section,
                                               const State& start,
                                               const SectionPointsRequest& request = {});

}  // namespace dynamy
