/// StepRecord: what a located step reports: impulses of the contacts that were held, percussions,
/// impacts, and works for the energy ledger.
#pragma once
#include <dynamy/located/phase/frozen_phase.hpp>
#include <dynamy/located/switching/switch_event.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

/// Begins the report of percussions of a step to x: none, and relative velocities at its end. γ_N
/// that the projection leaves is no impact.
void clearPercussions(ImpactProblem& p, const State& x);

class StepRecord {
 public:
  /// Works of the step so far [J], in the order of bookWork.
  std::array<double, 5> works{};
  /// ∫λ dt over the smooth part of the step, rows as in `impulsesOf` [N s].
  Eigen::VectorXd impulse;

  /// Begins a step.
  void begin();
  /// Notes that `impulse` has the rows of `phase`.
  void impulsesOf(const FrozenPhase& phase);
  /// The step has no smooth part.
  void noImpulses() { parts_.clear(), impulse.resize(0); }
  void addWorks(const std::array<double, 5>& more, double factor = 1.0) {
    for (std::size_t k = 0; k < works.size(); ++k) works[k] += factor * more[k];
  }
  /// Adds the percussions of an event at time t, after which `phase` holds. `impact`: the event had
  /// one; approaches slower than `floor` [m/s] count as none.
  void event(const SwitchEvent& event, const FrozenPhase& phase, double t, bool impact,
             double floor);
  /// Velocities right before an impact at time t; null: there was none.
  const Eigen::VectorXd* uBeforeImpact(double t) const {
    return tImpact_ == t ? &uBefore_ : nullptr;
  }
  /// Writes impulses, statuses, impacts and works into the report of a step that ended at x.
  void report(MechanicalSystem& s, const FrozenPhase& phase, State& x, StepReport& report);

  /// What an event that is taken back has to remove.
  struct Mark {
    std::size_t percussions, impacts;
    std::array<double, 5> works;
  };
  Mark mark() const { return {percussions_.size(), impacts_.size(), works}; }
  void back(const Mark& to) {
    percussions_.resize(to.percussions), impacts_.resize(to.impacts), works = to.works;
  }

 private:
  void withStruck(MechanicalSystem& s, const PhaseRequest& request, const State& x);
  /// Rows of `impulse` that belong to one part of a contact.
  struct Part {
    ContactKey key;
    int first, row, dim;
  };
  std::vector<Part> parts_;
  std::vector<Percussion> percussions_;
  std::vector<LocatedImpact> impacts_;
  std::vector<HeldStatus> statuses_;
  std::vector<ContactKey> struck_;  // contacts with a percussion
  Eigen::VectorXd uBefore_;
  double tImpact_ = -1e300;  // of uBefore_ [s]
};

}  // namespace dynamy
