/// Sweep: looks along an attempted step for contacts that it has passed (theory 37).
///
/// Nothing happens, and nothing is evaluated, unless an element says that a body goes further in
/// the step than it is thick. The path is that of the scheme, by its own interpolation, so that no
/// second model of the motion is needed. Predicting gaps at the begin of the step was rejected: the
/// plane of the nearest face stops bodies that fly past the face.
#pragma once
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class Sweep {
 public:
  /// The contact passed first in the step of `scheme` from `a` to `b`, with slot 0 of `s` as the
  /// step left it; none: false.
  Passing look(const MechanicalSystem& s, const OneStep& scheme, const State& a, const State& b);
  /// Paths looked along so far.
  long paths() const { return paths_; }

 private:
  int pieces(const MechanicalSystem& s, const State& a, const State& b);
  void evaluate(const MechanicalSystem& s, const State& x);
  Kinematics kinematics_;
  bool ready_ = false;
  SweptPath path_;
  State at_;
  long paths_ = 0;
};

}  // namespace dynamy
