/// Observer: receives every step of a run (recorder, energy ledger, observers of users). Elements
/// never write files; observers may.
#pragma once
#include <dynamy/core/archive.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class Model;

/// Const view of one accepted step.
struct StepView {
  const Model& model;
  const MechanicalSystem& system;  ///< slot(0), problem(): of this step
  const OneStep& scheme;           ///< interpolate()
  const State& before;
  const State& after;
  ConstVec Lambda{nullptr, 0};  ///< percussions of the step, rows of system.problem() [N s]
  ConstVec gammaE{nullptr, 0};  ///< Wᵀu^E + χ of the same rows [m/s]
  StepReport report;            ///< dt = 0: no step, the state at the start of the run
  long index = 0;               ///< number of the step, from 1
  bool whole = true;  ///< false: the run ended in a failed step; contacts are not to be used
};

class Observer : public Element {
 public:
  static constexpr Kind kKind = Kind::observer;
  using Element::Element;
  /// True: it reads contacts, which steps do not evaluate between bodies that sleep. No body sleeps
  /// then (theory 58).
  virtual bool readsContacts() const { return true; }
  /// Called before the first step: `initial` is a step of length 0 at the initial state, with its
  /// contacts and Λ = 0.
  virtual void start(const StepView& /*initial*/) {}
  virtual void step(const StepView& view) = 0;
  /// Called for a step that is rejected because its inclusion was not solved. The view holds the
  /// state before that step.
  virtual void failed(const StepView& /*view*/) {}
  /// Called after the last step, however the run ended; `last` is the last accepted step.
  virtual void finish(const StepView& /*last*/) {}
  /// Writes or reads what a resumed run needs to continue as if it had not been stopped.
  virtual void archive(Archive&) {}
};

}  // namespace dynamy
