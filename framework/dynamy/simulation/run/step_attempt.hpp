/// StepAttempt: the state of a run and the step tried last, which can be undone. A step is the
/// scheme's step and the projection onto the constraints that the model asks for (theory 34.3).
#pragma once
#include <atomic>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/run_report.hpp>
#include <dynamy/simulation/run/kept_energy.hpp>
#include <dynamy/simulation/run/sleep.hpp>
#include <dynamy/simulation/run/step_coarseness.hpp>
#include <dynamy/simulation/run/time_loop.hpp>
#include <dynamy/stages/projection.hpp>
#include <dynamy/stages/search_pauses.hpp>

namespace dynamy {

class StepAttempt {
 public:
  /// Begins at `from`, or if that is null at the initial state of the model. `sleep`: the islands
  /// that steps leave out; null: none. The first three arguments outlive the attempt.
  StepAttempt(Model& model, MechanicalSystem& system, Sleep* sleep = nullptr,
              const State* from = nullptr);
  /// Evaluates the initial state and moves it onto the joints; reports the corrections.
  StartReport start();
  /// Takes one step of length dt [s] to the instant tEnd [s]. Schemes that choose their steps may
  /// stop earlier, others after a part (StepTry). If `stop` becomes true meanwhile, the step is undone
  /// and the result is false; a flag that is true before is ignored. Null: no flag.
  bool take(double tEnd, double dt, const std::atomic<bool>* stop, StepTry how = StepTry::whole);
  /// Goes back to the state before the step.
  void undo() { x_ = before_; }
  /// The same without memory; the step cannot be seen any more.
  void undoInPlace() noexcept { std::swap(x_, before_); }
  /// The steps so far will not be undone any more.
  void settle() noexcept { attempted_ = false; }
  /// True: a step was tried since settle(), so that before() is the state before it.
  bool attempted() const { return attempted_; }
  /// Forgets the report of the step.
  void clear() { report_ = {}; }
  /// Begins at the state read from a checkpoint.
  void resumed() { before_ = x_; }

  const State& x() const { return x_; }
  /// The state, which may be written between two steps: memory as it is, the rest if x().scheme is
  /// emptied.
  State& change() { return x_; }
  const State& before() const { return before_; }
  /// Of the step tried last; dt = 0: none.
  const StepReport& report() const { return report_; }
  /// How coarse the step is for the motion.
  Coarseness coarseness() {
    return report_.resting ? Coarseness{}
                           : coarseness_.of(system_, before_, x_, report_.dt, kept_.error());
  }
  bool sound() const;
  /// Why the attempted state is not sound; empty: it is.
  std::string fault() const;
  /// The step as observers see it, number `index` from 1. `whole`: it did not fail. Valid until the
  /// next call of a function that is not const.
  StepView view(long index, bool whole);
  /// Lets populations remove and add blocks after the step. True: one did, and `old` is the state
  /// before that.
  bool renew(State& old);
  void archive(Archive& a);

 private:
  void project();
  Model& model_;
  MechanicalSystem& system_;
  Sleep* sleep_;
  State x_, before_;
  StepReport report_;
  StepCoarseness coarseness_;
  KeptEnergy kept_;
  Projection projection_;
  SearchPauses searches_;
  std::vector<double> zero_, gammaE_;  // percussions of no step [N s], γ^E [m/s]
  bool attempted_ = false;
  bool renews_;  // a system renews itself
};

}  // namespace dynamy
