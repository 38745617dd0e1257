/// ImpulseStart: the start values of Λ, by contact key: those of the last step in proportion to Δt,
/// or of a solution of the same step with fewer contacts.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/contact/key_index.hpp>
#include <dynamy/system/state.hpp>

namespace dynamy {

class ImpulseStart {
 public:
  /// Λ of the contacts `c` for a step Δt after the one that left `old`; 0 for those that are new.
  void set(const ContactSet& c, const RememberedImpulses& old, double dt,
           std::vector<double>& Lambda);
  /// The next start is this solution, until forget().
  void again(const ContactSet& c, const std::vector<double>& Lambda);
  void forget() { again_.key.clear(); }
  /// True: contact i of the last set() pressed in the step before.
  bool pressedBefore(int i) const { return pressedBefore_[static_cast<std::size_t>(i)] != 0; }

 private:
  /// Sets Λ of the contacts that are in `old`.
  void take(const ContactSet& c, const RememberedImpulses& old, double scale,
            std::vector<double>& Lambda);
  RememberedImpulses again_;
  KeyIndex remembered_;  // of the impulses taken last
  std::vector<char> pressedBefore_;
};

}  // namespace dynamy
