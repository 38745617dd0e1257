/// StepImpacts: which contacts of a step had an impact.
#pragma once
#include <dynamy/contact/key_index.hpp>
#include <dynamy/simulation/model/observer.hpp>

namespace dynamy {

class StepImpacts {
 public:
  /// Another step; what its contacts share is found once, when the first of them needs it.
  void look() { change_ = -1.0; }
  /// True if the contact closed with an approach speed −γ_N^A greater than what smooth forces alone
  /// change in one step, |γ_free − γ^A|, and carried a normal percussion. The settling of a resting
  /// contact is no impact then, and no threshold has to be chosen; speeds below 1e-9 of the scene's
  /// length per second do not count. A scheme that finds impacts itself tells which there were.
  bool operator()(const StepView& view, int contact);

 private:
  KeyIndex before_;
  double change_ = -1.0;  // of velocities by the forces of the step [m/s]; < 0: not asked for yet
};

}  // namespace dynamy
