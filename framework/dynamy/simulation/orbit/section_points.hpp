/// sectionPoints: where a motion passes the section after a transient, for diagrams of what a motion
/// does of itself beside branches of orbits.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/orbit/orbit_section.hpp>
#include <vector>

namespace dynamy {

struct SectionPointsRequest {
  int transient = 60, kept = 24;  ///< passes
  double tolerance = 1e-8;        ///< of the runs
};

/// Coordinates and velocities at each pass, in the order of coordinatesOf(). Empty from the pass on
/// after which the motion does not return.
std::vector<std::vector<double>> sectionPoints(Model& model, const OrbitSection& section,
                                               const State& start,
                                               const SectionPointsRequest& request = {});

}  // namespace dynamy
