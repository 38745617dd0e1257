/// Convex hull of points, and the mass properties of the solid that triangles enclose.
#pragma once
#include <array>
#include <dynamy/system/shape.hpp>
#include <vector>

namespace dynamy {

using Triangle = std::array<int, 3>;

/// Triangles of the convex hull, counterclockwise seen from outside. Points inside, or nearer to a
/// face than 1e-12 of the hull's extent, belong to no triangle. Empty if all points lie in one
/// plane. The cost is O(n²) at most.
std::vector<Triangle> convexHull(const std::vector<Vec3>& points);

/// Mass properties of the solid that closed triangles enclose: sums over the tetrahedra that the
/// triangles span with the origin,
///   ∫ r rᵀ dV = det/120 (s sᵀ + a aᵀ + b bᵀ + c cᵀ), s = a + b + c [Tonon 2004, 3].
/// All are negative but the centre if the triangles face inwards.
MassProperties enclosed(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

}  // namespace dynamy
