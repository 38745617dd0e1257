/// Switches of a periodic motion, in order, and how those of two orbits differ: at a grazing, or
/// where a contact sticks for a moment only, the switches along a branch change.
#pragma once
#include <dynamy/simulation/gradient/motion_sequence.hpp>
#include <string>

namespace dynamy {

struct OrbitEvent {
  double t = 0.0;                    ///< after the section [s]
  int switches = 0;                  ///< at this instant
  std::vector<HeldStatus> statuses;  ///< of contacts after it
  std::vector<ContactKey> impacts;
};

/// The switches and impacts of a motion without its other steps.
std::vector<OrbitEvent> eventsOf(const MotionSequence& sequence);

bool sameEvents(const std::vector<OrbitEvent>& a, const std::vector<OrbitEvent>& b);

/// What distinguishes the motion b from a, e.g. "wall (m.xml:4) is touched 1.2 s after the section".
struct EventChange {
  /// "coincidence": of two; "grazing": an impact more or less; "sliding": a closed contact begins to
  /// stick or to slip once more or less; "switch"
  std::string kind;
  std::string text;
};
EventChange changeOf(const Model& model, const std::vector<OrbitEvent>& a,
                     const std::vector<OrbitEvent>& b);

}  // namespace dynamy
