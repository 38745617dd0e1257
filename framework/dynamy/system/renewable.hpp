/// Renewable: a system that changes its state between two steps: a population whose grains a feeder
/// adds and a sink takes, or a hybrid system that jumps.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

class Renewable {
 public:
  /// Called at the end of an accepted step from tA to tE [s]; q, u: those of the system. q alone
  /// shows which blocks are present, so that a checkpoint contains them. True: q or u changed.
  virtual bool renew(double tA, double tE, Vec q, Vec u) const = 0;
  /// True: a change is a jump of the motion, which stands among the events of a run.
  virtual bool jumps() const { return false; }

 protected:
  ~Renewable() = default;
};

}  // namespace dynamy
