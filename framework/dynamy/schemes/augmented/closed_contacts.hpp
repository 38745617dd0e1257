/// ClosedContacts: contacts that count as closed during a block of AugmentedMoreau, whatever their
/// gaps: those closed where the block begins, and those that pressed in the step before.
#pragma once
#include <dynamy/stages/discrete_state.hpp>

namespace dynamy {

class ClosedContacts {
 public:
  /// Starts a step from x: the contacts that pressed in the step before.
  void begin(const State& x);
  /// Adds to them the contacts that are closed at x.
  void find(const MechanicalSystem& s, const State& x);
  const std::vector<ContactKey>& keys() const { return closed_; }
  /// True: a contact of c that does not count as closed has a gap of at most `least`.
  bool anyPassed(const ContactSet& c, double least) const;
  /// True: no contact but these is closed at x.
  bool othersAreOpen(const MechanicalSystem& s, const State& x);
  /// Sets γ_N^A to 0 in the contacts that stay closed: it is an error there and not an approach.
  /// sigma: the discrete state before; h: length of the step that p belongs to.
  void settle(const DiscreteState& sigma, double h, InclusionProblem& p) const;

 private:
  const ContactSet& at(const MechanicalSystem& s, const State& x, const ContactRequest& request);

  std::vector<ContactKey> closed_;   // sorted
  std::vector<ContactKey> pressed_;  // in the step before
  double lastDt_ = 0.0;              // length of that step [s]
  Kinematics kinematics_;
  bool ready_ = false;
  ContactSet contacts_;
};

}  // namespace dynamy
