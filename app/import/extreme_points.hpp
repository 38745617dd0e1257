/// A few points of many whose convex hull is nearly that of all.
#pragma once
#include <dynamy/core/types.hpp>
#include <vector>

namespace dynamy::app {

/// The outermost of `points` in 168 directions.
std::vector<Vec3> outermostPoints(const std::vector<Vec3>& points);

/// The same, and how far others lie outside of a face of their hull at most [m].
std::vector<Vec3> extremePoints(const std::vector<Vec3>& points, double& inside);

}  // namespace dynamy::app
