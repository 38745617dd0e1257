/// Observer: sees a run step after step (recorder, energy ledger, users' own). No element writes
/// files; observers may.
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
  /// Before the first step: a step of length 0 at the initial state, with its contacts, Λ = 0.
  virtual void start(const StepView& /*initial*/) {}
  virtual void step(const StepView& view) = 0;
  /// A step that is taken back because its inclusion was not solved: the state is that before it.
  virtual void failed(const StepView& /*view*/) {}
  /// After the last step, however the run ended; `last` is the last accepted step.
  virtual void finish(const StepView& /*last*/) {}
  /// What a resumed run needs to go on as if it had not been stopped; both directions.
  virtual void archive(Archive&) {}
};

}  // namespace dynamy
