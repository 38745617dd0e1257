/// OwnSteps: the loop of schemes that choose their steps (OneStep::choosesSteps). It bounds them by
/// the end of the run, by the largest step the model allows, and by contacts that a fast body would
/// pass; all else is the scheme's affair.
#pragma once
#include <dynamy/simulation/run/time_loop.hpp>

namespace dynamy {

class OwnSteps final : public TimeLoop {
 public:
  /// `largest`: no step is longer [s]; 0: any length. `nu`: velocities of the model, which
  /// bound the tries of a step for fast bodies, see mostParts().
  OwnSteps(double largest, NonConvergence policy, int nu)
      : largest_(largest), policy_(policy), nu_(nu) {}
  Advance next(Stepper& stepper, double until) override;
  void archive(Archive&) override {}

 private:
  bool advance(Stepper& stepper, double until);
  double largest_;
  NonConvergence policy_;
  int nu_;
  bool kept_ = false;  // what a longer run goes on from
};

}  // namespace dynamy
