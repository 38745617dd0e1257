/// Numbers that more than one file of the project uses.
#pragma once
#include <limits>
#include <numbers>

namespace dynamy {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Distance from 1 to the next number, 2⁻⁵² ≈ 2.2e-16.
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2.0 * kPi;  ///< [rad]

}  // namespace dynamy
