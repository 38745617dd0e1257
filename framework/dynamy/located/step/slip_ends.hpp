/// SlipEnds: ends of slip in space (theory 50.3). |γ_T| reaches zero in a singular way there: the
/// end is taken analytically, for all contacts whose slip is that short at once.
///
///   straight: γ_T = γ_T0 (1 − t/T),  T = −|γ_T|²/(γ_T·γ̇_T), on a way ½ |γ_T| T within the tolerance
#pragma once
#include <dynamy/located/step/coming_contacts.hpp>
#include <dynamy/located/step/event_stage.hpp>

namespace dynamy {

class SlipEnds {
 public:
  SlipEnds(LocatedParts& parts, ComingContacts& coming, EventStage& events)
      : parts_(parts), coming_(coming), events_(events) {}
  struct Result {
    bool stopped = false;  ///< slips have ended, at step.from, which has moved
    double most = 0.0;     ///< else the next trial may have this length [s]
    Refusal refusal{};
  };
  /// Ends the slips that stop within the tolerance. `most`: largest length of the step [s].
  Result take(LocatedStep& step, double most);

 private:
  /// Finds the parts whose slip ends within the tolerance, after at most last_; steps may continue
  /// by at most `bound`.
  Refusal find(LocatedStep& step, double most, double& bound);
  /// How held[i] slips: speed and its rate.
  struct Slip {
    double v = 0.0, along = 0.0, rate = 0.0;
  };
  Slip slipOf(std::size_t i) const;
  void keepImpulses(LocatedStep& step);
  LocatedParts& parts_;
  bool keepsEnergy(LocatedStep& step);
  ComingContacts& coming_;
  EventStage& events_;
  std::vector<HeldKey> stopping_;
  double last_ = 0.0;  // time until the last of them has stopped [s]
  PhasePoint start_;   // where the slips were found to stop
  FrozenPhase slipping_;
};

}  // namespace dynamy
