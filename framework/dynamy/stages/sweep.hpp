/// Sweep: looks along a step for contacts that it has passed or would pass (theory 37).
///
/// Nothing is evaluated unless an element reports that a body moves further in the step than it is
/// thick. The path is the scheme's own interpolation, so that no second model of the motion is
/// needed. Predicting gaps at the beginning of the step was rejected: the plane of the nearest face
/// would stop bodies that fly past the face.
#pragma once
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class Sweep {
 public:
  /// Finds the contact that was passed first in the step of `scheme` from `a` to `b`, with slot 0
  /// of `s` as the step left it. A result that converts to false: none was passed.
  Passing look(const MechanicalSystem& s, const OneStep& scheme, const State& a, const State& b);
  /// Finds the contact that bodies pass first if they go on from `a` for dt with their velocities.
  /// look() would find it too, unless it finds another one: so a step need not be attempted.
  Passing ahead(const MechanicalSystem& s, const State& a, double dt);
  /// Number of paths searched so far.
  long paths() const { return paths_; }
  /// Work of the searches, in evaluations of one velocity.
  double work() const { return work_; }

 private:
  int pieces(const MechanicalSystem& s, const State& a, const State& b);
  Passing straight(const MechanicalSystem& s, const State& a, double dt, int pieces);
  Passing search(const MechanicalSystem& s);
  void evaluate(const MechanicalSystem& s, const State& x);
  Kinematics kinematics_;
  bool ready_ = false;
  SweptPath path_;
  State at_;
  long paths_ = 0;
  double work_ = 0.0;
};

}  // namespace dynamy
