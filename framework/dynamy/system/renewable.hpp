/// Renewable: a population that removes blocks and adds others between two steps, such as grains
/// that a feeder adds and a sink takes.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

class Renewable {
 public:
  /// Called at the end of an accepted step from tA to tE [s]; q, u: those of the system. q alone
  /// shows which blocks are present, so that a checkpoint contains them. True: q or u changed.
  virtual bool renew(double tA, double tE, Vec q, Vec u) const = 0;

 protected:
  ~Renewable() = default;
};

}  // namespace dynamy
