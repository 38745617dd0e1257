/// PhaseMotion: the motion of the present phase: the contacts that are held, and the steps that
/// follow it.
///
/// There are two steps. The step of a trial keeps its stages for the path through the trial, while
/// the rest up to a switch is covered by short steps of their own.
#pragma once
#include <dynamy/located/phase/smooth_step.hpp>

namespace dynamy {

class PhaseMotion {
 public:
  FrozenPhase phase;
  SmoothStep step;       ///< of trials
  SmoothStep shortStep;  ///< of the distance that is left to a switch

  /// Uses the method `table`, and `light` (or null) where the motion is simple.
  void prepare(const MechanicalSystem& s, const ButcherTableau& table, const ButcherTableau* light);
  /// Makes steps implicit from now on, or explicit again.
  void implicit(bool wanted, const MechanicalSystem& s, const ErrorNorm& norm);
  /// Makes explicit steps half-explicit with this number of columns; 0: by the table again.
  void halfExplicit(int columns) { step.halfExplicit(columns), shortStep.halfExplicit(columns); }
  void forgetJacobian() { step.implicitStep().forget(), shortStep.implicitStep().forget(); }

  /// Sorted keys of the contacts that are held, as of the last rekey().
  const std::vector<ContactKey>& keys() const { return phase.request.keys; }
  /// Brings the keys up to date, after the held contacts have changed.
  void rekey();
  /// Holds nothing.
  void clear() { phase.held.clear(), phase.request.keys.clear(); }
  /// Evaluates the forces at p.x in slot 0: p gets its derivatives, forces and powers. False: the
  /// phase has a fault. `alone`: HeldContacts::alone, where the slot is soon evaluated anew.
  bool evaluate(MechanicalSystem& s, PhasePoint& p, bool alone = false);
  /// Sets the energies of p, where the slot is evaluated; of whole systems only.
  static void energies(const MechanicalSystem& s, int slot, PhasePoint& p);
};

}  // namespace dynamy
