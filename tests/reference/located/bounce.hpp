/// Closed form of a ball that bounces on a floor, as truth for scenes of many of them.
#pragma once
#include <cmath>
#include <support/gravity.hpp>

namespace dynamy::reference {

/// Height [m] at time t [s] of a point that is let go at height z [m] above a floor, with
/// restitution e: parabolas between impacts at √(2z/g) (1 + 2e + 2e² + …), g = 9.81 m/s². Before
/// its accumulation point.
inline double bounceHeight(double z, double e, double t) {
  double v = std::sqrt(2.0 * kG * z), left = t - v / kG;
  if (left < 0.0) return z - 0.5 * kG * t * t;
  for (;; left -= 2.0 * v / kG) {
    v *= e;
    if (left < 2.0 * v / kG) return v * left - 0.5 * kG * left * left;
  }
}

}  // namespace dynamy::reference
