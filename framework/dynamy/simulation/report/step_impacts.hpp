/// StepImpacts: which contacts of a step had an impact.
#pragma once
#include <dynamy/contact/key_index.hpp>
#include <dynamy/simulation/model/observer.hpp>

namespace dynamy {

/// True: the scheme reports this contact's status and its impacts itself. A scheme may do so for
/// all contacts, or for those of systems that it did not step in time.
bool isReported(const StepView& view, int contact);

class StepImpacts {
 public:
  /// Begins another step. Data that its contacts share are computed once, when the first contact
  /// needs them.
  void look() { change_ = -1.0; }
  /// True if the contact closed with an approach speed −γ_N^A greater than what smooth forces alone
  /// change in one step, |γ_free − γ^A|, and carried a normal percussion. So the settling of a
  /// resting contact is no impact, and no threshold has to be chosen; speeds below 1e-9 of the
  /// scene's length per second do not count. A scheme that locates impacts itself reports which
  /// contacts had one.
  bool operator()(const StepView& view, int contact);

 private:
  KeyIndex before_;
  /// Largest change of a velocity by the forces of the step [m/s]; < 0: not computed yet.
  double change_ = -1.0;
};

}  // namespace dynamy
