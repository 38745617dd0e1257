/// OngoingEvent: what the stages of an event share, and EventResult, what the event reports.
#pragma once
#include <dynamy/located/phase/phase_point.hpp>
#include <dynamy/located/phase/phase_request.hpp>
#include <dynamy/stages/error_norm.hpp>

namespace dynamy {

struct EventResult {
  bool impact = false, changed = false, undecided = false;
  int accumulations = 0;
  double accumulationEnd = 0.0;  ///< [s]
  SolveReport solved;
  std::string_view fault;
  ContactKey lost;  ///< contact of the faults PhaseFault::kLost and kOtherSet
};

struct OngoingEvent {
  MechanicalSystem& s;  ///< slot 0: at p.x, with all contacts that take part
  InclusionSolver& solver;
  const ErrorNorm& norm;
  PhasePoint& p;  ///< the event changes p.x and p.a
  EventResult& result;
  const PhaseRequest& request;  ///< of the phase that ends
  /// A contact that closes at once, although it may separate at the instant.
  ContactKey closes = kNoContact;
  bool starts = false;  ///< the run begins: bodies inside each other are pushed apart

  /// Evaluates x with exactly these contacts (ascending). `alone`: HeldContacts::alone.
  const Evaluation& evaluate(const State& x, std::span<const ContactKey> keys, int slot = 0,
                             bool alone = false) {
    return s.evaluate(x, request.holding(keys, slot, alone));
  }

  /// Speeds below this count as rest [m/s].
  double restSpeed() const { return 1e-10 * norm.speed(); }
  /// Slower contacts approach by rounding [m/s].
  double stillSpeed() const { return 1e-13 * norm.speed(); }
  /// Slips above this speed continue [m/s].
  double slipSpeed() const { return 1e-9 * norm.speed(); }
};

}  // namespace dynamy
