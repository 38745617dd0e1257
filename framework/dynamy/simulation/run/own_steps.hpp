/// OwnSteps: the loop of schemes that choose their steps (OneStep::choosesSteps). The loop bounds
/// these steps by the end of the run, by the largest step the model allows, and by contacts that a
/// fast body would pass; the scheme decides everything else.
#pragma once
#include <dynamy/simulation/run/time_loop.hpp>

namespace dynamy {

class OwnSteps final : public TimeLoop {
 public:
  /// `largest`: longest step [s]; 0: any length. `nu`: number of velocities of the model, which
  /// limits the tries of a step for fast bodies, see mostParts(). Steps end at `samples`.
  OwnSteps(double largest, NonConvergence policy, int nu, SampleInstants samples = {})
      : largest_(largest), policy_(policy), nu_(nu), samples_(std::move(samples)) {}
  Advance next(Stepper& stepper, double until) override;
  void archive(Archive& a) override { a(parted_), a(unseen_); }

 private:
  bool advance(Stepper& stepper, double until);
  /// The first contact that a fast body has passed in the step that was tried with this work.
  Passing passed(Stepper& stepper, double until, double tried);
  /// May a further step end at a contact that a fast body would pass? Bodies that spin fast may hit so
  /// often that the run would not end.
  bool mayEndAtContact(double t, double until) const;
  double largest_;
  NonConvergence policy_;
  int nu_;
  SampleInstants samples_;
  // Work of tries that went beyond such contacts, and of looks for them as far as they cost more than
  // the steps themselves.
  double parted_ = 0.0;
  long unseen_ = 0;    // steps since the last look, once that work is used up
  bool kept_ = false;  // the state from which a longer run continues is stored
};

}  // namespace dynamy
