/// ClosingContacts: of the contacts within reach those that a step has to ask.
///
/// The reach of a look ahead is twice the way of the fastest block. With one fast body, all open gaps
/// of a scene are within it, and an inclusion of some hundred contacts is solved for the few that
/// close. An open contact whose gap would stay open with the free motion,
///
///   g/Δt + γ_free > |γ_free|/2,   also with all of its bodies but one stopped,
///
/// and which did not press in the last step, is put aside; with the solution, those aside that would
/// close all the same, g/Δt + γ^E < 0, come in, and the inclusion is solved again. The result is that
/// of all contacts: for what stays aside, Λ = 0 is right. Sets of which less than three quarters
/// would go stay as they are.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/contact/key_index.hpp>
#include <dynamy/system/state.hpp>

namespace dynamy {

class ClosingContacts {
 public:
  /// A new set; nothing is aside.
  void clear() { aside_ = 0; }
  bool any() const { return aside_ > 0; }
  /// Puts contacts of `c` aside, unless some are already. uFree: velocities of the free motion, nu
  /// numbers; pressed: the impulses of the last step. True: `c` has changed.
  bool reduce(ContactSet& c, ConstVec uFree, double dt, double gTol,
              const RememberedImpulses& pressed);
  /// If some aside would close at the velocities uE, brings them in with those that are near it.
  /// True: `c` has changed.
  bool bringIn(ContactSet& c, const Eigen::VectorXd& uE, double dt);

 private:
  void write(ContactSet& c) const;
  ContactSet all_;
  std::vector<char> asks_;  // of all_
  int aside_ = 0;
  KeyIndex old_;
};

}  // namespace dynamy
