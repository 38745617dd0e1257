/// The constants of a located step, with their units. Each was chosen by the figures in theory 50,
/// where a change of it by a factor of ten costs evaluations or digits.
#pragma once
#include <cstdint>

namespace dynamy {

/// Trials of smooth steps (theory 50.2).
struct TrialConstants {
  static constexpr double firstStep = 0.02;    ///< of T
  static constexpr double safety = 0.9;        ///< on the factor tolerance/error of the next step
  static constexpr double shrink = 0.2;        ///< least factor from trial to trial
  static constexpr double half = 0.5;          ///< factor where the error gives none
  static constexpr int most = 60;              ///< trials of one step
  static constexpr double leastStep = 1e-14;   ///< of the time and of T
  static constexpr double mostTurn = 2.0;      ///< [rad] in a step with open contacts,
  static constexpr double mostFeatures = 0.5;  ///< and where contacts come and go with features
  /// Rounding of gaps [L] and of velocities [U].
  static constexpr double gapNoise = 2e-14, speedNoise = 1e-12;
  static constexpr double project = 5e-4;    ///< of the tolerance: corrections below it wait
  static constexpr double suspicious = 0.1;  ///< of the tolerance: above it the bias is checked
};

/// In evaluations of one velocity: an evaluation costs `each` besides those of its velocities, a
/// decomposition of m rows m³/rowsCubed, a gap perGap (theory 50.7).
struct WorkConstants {
  static constexpr double each = 5.0, rowsCubed = 1000.0, perGap = 4.0;
};

/// Events (theory 50.4).
struct EventConstants {
  /// Part of the step that decisions look ahead: at first, and at most after empty events.
  static constexpr double lookAhead = 1e-5, mostLookAhead = 1e-2;
  static constexpr double atOnce = 1e-6;     ///< of the step: events this close are at one instant
  static constexpr int mostEmpty = 5;        ///< empty events at one instant
  static constexpr long mostImpacts = 2000;  ///< that follow each other within one step
  static constexpr double rapid = 1e-7;      ///< of T: the textbook's events this close have no end
  static constexpr double ignored = 1e-3;    ///< of the step: monitors are ignored for this time
  /// Speeds below this part of L per second are no impact, as for schemes with fixed steps [1/s].
  static constexpr double impactFloor = 1e-9;
};

/// The distance left to a root (theory 50.3).
struct RootConstants {
  static constexpr double mostError = 2.0;  ///< of the tolerance: of the step repeated to a root
  static constexpr int mostFirst = 8;       ///< contacts that close before the one that was found
  static constexpr int mostMoves = 8;       ///< iterations of Newton's method
  static constexpr double taylor = 0.01;    ///< (d/h)³ over the tolerance, for Taylor's polynomial
  static constexpr double denseShare = 0.1;  ///< largest d/h for the dense output
  static constexpr double farthest = 0.5;    ///< d/h above which the root is not of this step,
  static constexpr double jump = 1e-2;       ///< and above which the gap of two features has jumped
};

/// Slip in space (theory 20.6).
struct SlipConstants {
  static constexpr double mostTurned = 10.0;  ///< k of theory 20.6, in units of the tolerance
  static constexpr double stop = 0.1;         ///< of the tolerance: a slip end taken as straight
  static constexpr double leastStart = 1e-6;  ///< of T: shortest step in which a start may end
  static constexpr double energy = 1e-3;  ///< of T and |ΔV|: error of the energy until a slip ends
  static constexpr double shareOfStop = 0.75;  ///< steps end before slip does
};

/// Checks of the bias that elements report (theory 52.4).
struct BiasConstants {
  static constexpr double difference = 1e-4;  ///< of T: for γ̇ by differences
  static constexpr double share = 1e-3;       ///< of the sum of absolute values in γ̇
  static constexpr double truncation = 1e-7;  ///< of γ̇, and of γ/T: ten times (δ/T)²
  static constexpr double noise = 1e-12;      ///< of L/T² and 1/T²: rates that count as zero
  /// Of rounding: γ from four places of a difference, each a sum of some products.
  static constexpr double roundings = 16.0;
  static constexpr double noRate = 1e-9;   ///< of L/T² and 1/T²: differences that count as zero
  static constexpr double oneSided = 3.0;  ///< offset of a one-sided difference, in its lengths
  /// Columns of the half-explicit rule at loose tolerances, and at those below `tight`.
  static constexpr int looseColumns = 3, tightColumns = 4;
  static constexpr double tight = 1e-6;
};

/// Contacts that come and go with the features of bodies (theory 50.9).
struct MeetingConstants {
  /// Of tol L, and at least of L: a circle whose lowest point is less below its middle lies flat.
  static constexpr double flat = 0.05, leastFlat = 1e-10;
  static constexpr double left = 1e-3;     ///< of tol L: overlaps that are left as they are
  static constexpr double passing = 10.0;  ///< of tol L: overlaps inside a step
  static constexpr double around = 1e-2;   ///< of L: search for a contact that cannot be followed
  static constexpr std::uintmax_t looks = 12;  ///< evaluations to find where bodies are nearest
  static constexpr int nearestBits = 20;       ///< accuracy of that place
  static constexpr double halfWay = 0.5;    ///< part of a sample interval that a sample looks ahead
  static constexpr double notAtAll = 0.25;  ///< part of the path to retry if bodies meet at once
  static constexpr double atMeeting = 1e-3;  ///< of T: shorter steps to a meeting are not taken
  static constexpr double inside = 0.05;     ///< of T: the same for bodies inside each other
  static constexpr double creeping = 1e-7;   ///< of T: shorter steps find no contact either
  static constexpr double shorter = 0.5;     ///< factor on a step in which bodies sink in
  static constexpr double touching = 1e-5;   ///< of L: gaps up to this may close in any step
  static constexpr double drifted = 1e-10;   ///< of L: drift of joints between two projections
};

/// Announced instants and latches (theory 50.3).
struct InstantConstants {
  /// Of the time: distance right before and after an instant, larger than rounding of formulas.
  static constexpr double beside = 2e-14;
  static constexpr double passed = 4e-13;    ///< of the time: an instant this far back may be due
  static constexpr double nudge = 1e-6;      ///< of the step: greatest delay of a latch
  static constexpr double still = 1e-3;      ///< of the tolerance: speeds of bodies at rest
  static constexpr double shortRest = 0.02;  ///< of T: least length of a step at rest
};

}  // namespace dynamy
