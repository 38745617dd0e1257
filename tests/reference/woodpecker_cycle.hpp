/// The woodpecker's limit cycle: its period, and what a test measures of it.
#pragma once

namespace dynamy::reference {

/// Of the event-driven solution, Taylor series of order 40.
inline constexpr double kPeriod = 0.145976065144;  // [s]

struct Cycle {
  double period = 0.0, fall = 0.0;
};

}  // namespace dynamy::reference
