/// Settings of a scheme that locates switches.
#pragma once
#include <cstdint>
#include <dynamy/located/phase/butcher_tableau.hpp>
#include <dynamy/stages/one_step.hpp>
#include <limits>

namespace dynamy {

/// When smooth phases are integrated implicitly.
enum class StiffSteps : std::uint8_t { automatic, never, always };

/// How events are treated.
struct EventPolicy {
  /// Decisions look ahead by a small part of the step; else they are taken at the instant, on the
  /// level of accelerations.
  bool looksAhead = true;
  /// Contacts that would return within the tolerance stay closed, and empty events are ignored for
  /// a while. Else the scheme stalls where events follow each other without end.
  bool passesAccumulations = true;
  /// The end of slip in space is taken analytically; else the scheme has no way past it.
  bool endsSlipInSpace = true;
  /// The event-driven scheme of the textbooks (theory 51.7).
  static constexpr EventPolicy textbook() { return {false, false, false}; }
};

struct LocatedSettings {
  StiffSteps stiff = StiffSteps::automatic;
  const ButcherTableau* method = nullptr;  ///< null: one that fits the tolerance
  Accuracy accuracy{};
  int columns = 0;  ///< of the half-explicit rule where it is used throughout, else 0
  EventPolicy events{};
  /// Steps have the lengths that the caller gives, whatever their errors are (theory 53): as a
  /// function of the state at its start, such a step is smooth.
  bool givenSteps = false;
  double patience = std::numeric_limits<double>::infinity();  ///< factor on RunPatience
  bool oneClock = true;  ///< all islands end their steps together
  /// The method of smooth phases at this accuracy.
  const ButcherTableau& table() const;
};

}  // namespace dynamy
