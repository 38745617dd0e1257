/// OrbitSection: where a periodic orbit is cut: where a signal passes a value in one direction, or
/// once every period of a forcing.
#pragma once
#include <string>

namespace dynamy {

struct OrbitSection {
  std::string signal;    ///< empty: none
  double value = 0.0;    ///< [unit of the signal]
  bool falling = false;  ///< passes the value downwards
  double period = 0.0;   ///< of a forcing [s]; 0: none
  int returns = 1;       ///< passes, or periods of the forcing, in one orbit
  bool given() const { return !signal.empty() || period > 0.0; }
  /// "toy.phiM falls through 0", "every 2.5 s".
  std::string text() const;
};

}  // namespace dynamy
