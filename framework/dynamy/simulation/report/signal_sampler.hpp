/// SignalSampler: values of signals anywhere inside a step, through the scheme's own interpolation.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <span>

namespace dynamy {

/// The signals that `names` request, in this order and each once; "toy.*" means all signals of toy,
/// "*" all signals. Without names: all signals of systems. Throws ModelError with places and the
/// nearest known names.
std::vector<const NamedSignal*> chooseSignals(const Model& model,
                                              const std::vector<std::string>& names,
                                              const std::vector<Place>& places);

class SignalSampler {
 public:
  SignalSampler(const Model& model, std::vector<const NamedSignal*> signals);
  const std::vector<const NamedSignal*>& signals() const { return signals_; }

  /// All signals at fraction θ ∈ [0,1] of the step; q and u from OneStep::interpolate, contact
  /// quantities (λ, γ, status) from OneStep::contactsAt if the scheme has them, else those of the
  /// whole step; within a step elements remember what they did at its beginning. No allocation after the
  /// first call.
  void sample(const StepView& view, double theta, std::span<double> out);
  /// Signal number i alone.
  double sampleOne(const StepView& view, double theta, std::size_t i);
  /// True: some signals are forces, or statuses that forces decide. At the start of a run nothing tells
  /// them: the first step does.
  bool readsForces() const { return readsForces_; }
  bool readsForces(std::size_t i) const { return isOfForces(*signals_[i]); }
  /// In place of their values at the start, those of such signals at the beginning of the first step.
  void sampleForces(const StepView& first, std::span<double> out);
  /// Signals right before the switch or the impact at the end of the step.
  void sampleBeforeImpact(const StepView& view, std::span<double> out);
  double sampleBeforeImpact(const StepView& view, std::size_t i);

 private:
  static bool isOfForces(const NamedSignal& signal);
  void place(const StepView& view, double theta, bool ofContacts);
  void placeBeforeImpact(const StepView& view, bool ofContacts);
  /// Asks the scheme for the contacts at at_, if signals of contacts are wanted.
  void look(const StepView& view, bool after, bool ofContacts);
  double value(const StepView& view, const NamedSignal& signal) const;
  const Model& model_;
  std::vector<const NamedSignal*> signals_;
  Kinematics kinematics_;
  State at_;
  ContactInstant instant_;
  bool ofContacts_ = false;  // some signal belongs to a contact
  bool readsForces_ = false;
  bool known_ = false;  // instant_ holds the contacts at at_
};

}  // namespace dynamy
