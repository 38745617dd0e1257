/// EventImpact: the impact of all contacts that take part in an event (theory 50.4):
///
///   M(u⁺ − u⁻) = WΛ,   with the impact law of the model
#pragma once
#include <array>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/located/switching/ongoing_event.hpp>
#include <dynamy/located/switching/without_rebound.hpp>
#include <memory>

namespace dynamy {

/// Percussions of one contact at an event, and its relative velocities before them, for the report
/// of the step.
struct Percussion {
  ContactKey key;
  int dim = 0;
  std::array<double, kMostRows> Lambda{}, gammaMinus{};
  bool unilateral = false;
};

class EventImpact {
 public:
  /// No impact.
  void clear() { percussions_.clear(), works_ = {}; }
  /// Takes the impact of the contacts in slot 0, if one of them approaches: changes x.u. The
  /// contacts `plastic` do not rebound.
  void take(OngoingEvent& at, const std::vector<ContactKey>& plastic);
  /// Stops contacts in slot 0 that approach more slowly than an impact, without rebound. If they went
  /// on, each would close again at once. True: x.u has changed.
  bool stop(OngoingEvent& at);
  /// Percussions of the last impact, empty: there was none; works() are theirs [J].
  const std::vector<Percussion>& percussions() const { return percussions_; }
  const std::array<double, 5>& works() const { return works_; }
  /// Relative velocities of all rows after it.
  const Eigen::VectorXd& gamma() const { return gamma_; }
  /// Speed above which a contact leaves [m/s].
  double leaves() const { return leaves_; }

 private:
  double fastestApproach(const OngoingEvent& at);
  void solve(OngoingEvent& at);
  void note(const MechanicalSystem& s);
  std::vector<std::unique_ptr<WithoutRebound>> wrappers_;
  std::vector<Percussion> percussions_;
  std::array<double, 5> works_{};
  Eigen::VectorXd gamma_, gammaBefore_;
  double leaves_ = 0.0;
};

}  // namespace dynamy
