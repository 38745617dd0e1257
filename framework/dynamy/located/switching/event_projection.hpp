/// EventProjection: brings positions and velocities of contacts to zero at the instant of a switch,
/// in the metric of the mass (theory 50.4).
#pragma once
#include <dynamy/located/phase/held_projection.hpp>
#include <dynamy/located/switching/ongoing_event.hpp>

namespace dynamy {

class EventProjection {
 public:
  /// Projects the state of the event onto the positions of all contacts of slot 0, those with
  /// `keys` (ascending), which is evaluated anew. Sets on displacements count only if `held` has
  /// them at rest at x = 0.
  void positions(OngoingEvent& at, std::span<const ContactKey> keys, const std::vector<Held>& held);
  /// Projects x.u onto the velocities of the contacts `held`, as evaluated in slot 0.
  void velocities(const MechanicalSystem& s, const std::vector<Held>& held, State& x);

 private:
  std::vector<Held> together_;
  HeldRows rows_;
  HeldProjection projection_;
  Eigen::VectorXd delta_;
  PhaseFault unused_;
};

}  // namespace dynamy
