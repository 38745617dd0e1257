/// The acceleration of gravity of scenes that give no other.
#pragma once

namespace dynamy {

inline constexpr double kG = 9.81;  // [m/s²]

}  // namespace dynamy
