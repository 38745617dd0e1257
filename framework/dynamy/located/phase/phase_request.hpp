/// PhaseRequest: what evaluations of a phase request: exactly the contacts that are held, wherever
/// they are, with the bias of their rows.
#pragma once
#include <dynamy/stages/evaluation.hpp>
#include <vector>

namespace dynamy {

struct PhaseRequest {
  std::vector<ContactKey> keys;            ///< of the held contacts, ascending
  BiasDifferences* differences = nullptr;  ///< for elements that report no bias; borrowed

  /// With other contacts held; `held`: ascending, borrowed. `alone`: HeldContacts::alone.
  EvaluationRequest holding(std::span<const ContactKey> held, int slot, bool alone = false) const {
    return {.slot = slot,
            .held = HeldContacts{.keys = held, .follow = true, .alone = alone},
            .bias = true,
            .differences = differences};
  }
  EvaluationRequest in(int slot) const { return holding(keys, slot); }
  /// For stages of a step, in slot 1: elements look for held contacts alone. Gaps of the others
  /// matter at the ends of steps and for the search.
  EvaluationRequest ofStage() const { return holding(keys, 1, true); }
};

}  // namespace dynamy
