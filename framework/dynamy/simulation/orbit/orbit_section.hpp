/// OrbitSection: where a periodic orbit is cut: where a signal passes a value in one direction, or
/// once every period of a forcing.
#pragma once
#include <string>
#include <vector>

namespace dynamy {

struct OrbitSection {
  std::string signal;    ///< empty: none
  double value = 0.0;    ///< [unit of the signal]
  bool falling = false;  ///< passes the value downwards
  double period = 0.0;   ///< of a forcing [s]; 0: none
  int returns = 1;       ///< passes, or periods of the forcing, in one orbit
  /// Symmetry of a motion that repeats itself mirrored after half a period: signals that change their
  /// signs, "m.x", or that are exchanged, "left.x=right.x", "left.x=-right.x"; empty: none.
  std::vector<std::string> mirror = {};
  bool given() const { return !signal.empty() || period > 0.0; }
  /// "toy.phiM falls through 0", "every 2.5 s".
  std::string text() const;
};

}  // namespace dynamy
