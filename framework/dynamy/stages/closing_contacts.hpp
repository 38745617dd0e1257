/// ClosingContacts: selects, of the contacts within reach, those that a step has to solve for.
///
/// The reach of a step is twice the way of the fastest block. With one fast body, all open gaps of
/// a scene are within reach, and an inclusion of some hundred contacts would be solved for the few
/// that close. An open contact whose gap would stay open with the free motion,
///
///   g/Δt + γ_free > |γ_free|/2,   also with all of its bodies but one stopped,
///
/// and which did not press in the last step, is put aside. After the solution, contacts put aside
/// that would close all the same, g/Δt + γ^E < 0, are added, and the inclusion is solved again. The
/// result is that of all contacts, since Λ = 0 is right for those that stay aside. A set of which
/// less than three quarters could be put aside stays complete.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/contact/key_index.hpp>
#include <dynamy/system/state.hpp>

namespace dynamy {

class ClosingContacts {
 public:
  /// Begins with a new set, of which no contact is aside.
  void clear() { aside_ = 0; }
  bool any() const { return aside_ > 0; }
  /// Puts contacts of `c` aside, unless some already are. uFree: velocities of the free motion, nu
  /// numbers; pressed: the impulses of the last step. True: `c` has changed.
  bool reduce(ContactSet& c, ConstVec uFree, double dt, double gTol,
              const RememberedImpulses& pressed);
  /// If contacts put aside would close at the velocities uE, adds them to `c`, together with those
  /// that are near closing. True: `c` has changed.
  bool bringIn(ContactSet& c, const Eigen::VectorXd& uE, double dt);

 private:
  void write(ContactSet& c) const;
  ContactSet all_;
  std::vector<char> asks_;  // per contact of all_: not 0 if the step has to solve for it
  int aside_ = 0;
  KeyIndex old_;
};

}  // namespace dynamy
