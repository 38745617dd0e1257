/// Observer: sees a run step after step (recorder, energy ledger, users' own). No element writes
/// files; observers may.
#pragma once
#include <dynamy/integrator/one_step.hpp>

namespace dynamy {

class Model;

/// Const view of one accepted step.
struct StepView {
  const Model& model;
  const MechanicalSystem& system;  ///< slot(0), problem(): of this step
  const OneStep& scheme;           ///< interpolate()
  const State& before;
  const State& after;
  ConstVec Lambda{nullptr, 0};  ///< percussions of the step, rows of system.problem()
  StepReport report;
  long index = 0;  ///< number of the step, from 1
};

class Observer : public Element {
 public:
  static constexpr Kind kKind = Kind::observer;
  using Element::Element;
  /// Before the first step; `x` is the initial state.
  virtual void start(const Model&, const State& /*x*/) {}
  virtual void step(const StepView& view) = 0;
  /// After the last step, however the run ended.
  virtual void finish(const State& /*x*/) {}
};

}  // namespace dynamy
