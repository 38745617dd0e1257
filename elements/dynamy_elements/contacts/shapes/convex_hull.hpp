/// Convex hull of points, and the mass properties of what triangles enclose.
#pragma once
#include <array>
#include <dynamy/system/shape.hpp>
#include <vector>

namespace dynamy {

using Triangle = std::array<int, 3>;

/// Triangles of the hull, counterclockwise from outside; points in its inside or within 1e-12 of
/// the extent of its faces are part of none. Empty if all points lie in one plane. O(n²).
std::vector<Triangle> convexHull(const std::vector<Vec3>& points);

/// Of the solid that closed triangles enclose: sums over the tetrahedra that they span with the
/// origin, ∫ r rᵀ dV = det/120 (s sᵀ + a aᵀ + b bᵀ + c cᵀ), s = a + b + c [Tonon 2004, 3].
MassProperties enclosed(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

}  // namespace dynamy
