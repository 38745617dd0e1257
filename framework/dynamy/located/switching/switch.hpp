/// Switch: the end of a status on the path of a trial.
#pragma once
#include <cstdint>

namespace dynamy {

struct Switch {
  enum class Kind : std::uint8_t { none, atStart, root, look };
  Kind kind = Kind::none;
  double theta = 1.0;  ///< place on the path, as a part of the step
  bool force = false;  ///< its monitor is one of forces: each value takes an evaluation
  int monitor = -1;
  double slope = 0.0;  ///< slope of the monitor at the root, per second
  explicit operator bool() const { return kind != Kind::none; }
};

}  // namespace dynamy
