/// Simulation: runs the scheme and the solver of a built model from its initial state, or from a
/// checkpoint, to the end time:
///
///   loop (fixed steps, …) → attempt: OneStep::step → sound? → accept: observers see the step
///
/// step() and run() neither throw nor print, whatever elements and observers do, and a step of the
/// usual size does not allocate. A run ends at the first number that is not
/// finite and at the first mass matrix that is not positive definite. The error names the system
/// and its place, and the numbers recorded before are kept. Rejected: one loop with flags for all
/// ways to choose steps; each way is a TimeLoop.
#pragma once
#include <atomic>
#include <dynamy/simulation/run/checkpoints.hpp>
#include <dynamy/simulation/run/idle_calls.hpp>
#include <dynamy/simulation/run/planned_steps.hpp>
#include <dynamy/simulation/run/run_observers.hpp>
#include <dynamy/simulation/run/step_attempt.hpp>
#include <dynamy/simulation/run/time_loop.hpp>
#include <dynamy/simulation/run/unsolved_steps.hpp>
#include <functional>
#include <optional>

namespace dynamy {

class Simulation final : private Stepper {
 public:
  /// `model` is built and outlives the simulation. Throws ModelError if the model lacks the step or
  /// tolerance that its scheme needs, or if a check requests an unknown signal. `plan`: of the steps,
  /// for a scheme that chooses its steps; null: none.
  explicit Simulation(Model& model, const StepPlan* plan = nullptr);

  // Before the first step.
  /// Records into `sink`, which outlives the simulation. Throws ModelError for unknown signals.
  void record(RecordSink& sink);
  void observe(Observer& observer) { observers_.add(observer), sleep_.heed(observer); }
  /// Uses up to `count` threads for each step, fewer if the operating system gives no more. The
  /// results have the same bits with any number. Returns the number of threads in use.
  int threads(int count);
  /// Sets a function that is called about ten times a second of wall time, for progress and for
  /// files with rare rows.
  void onIdle(std::function<void()> call) { idle_.call(std::move(call)); }
  /// Sets a function that receives the bytes of a checkpoint before the first step, then every
  /// `seconds` of wall time. Checkpoints become rarer if they and the call take more than `share`
  /// of the time.
  void onCheckpoint(double seconds, double share, std::function<void(const std::string&)> call) {
    checkpoints_.receiver(seconds, share, std::move(call));
  }
  /// The run ends once `flag` is true (Ctrl-C): after the present step, or before the next try or
  /// part of it. No recorded numbers are lost. If the run ended within a step, checkpoint() holds
  /// an earlier state, or is empty if none was stored.
  void stopWhen(const std::atomic<bool>& flag) { stop_ = &flag; }
  /// Continues from a checkpoint of the same model, or, with `changed`, of a model with the same
  /// coordinates and elements, of which only parameters differ: the scheme begins anew, joints are
  /// closed as at the start of a run, and the change of T + V, which was `changed` [J], is booked as
  /// work of the boundaries. Throws ModelError if the checkpoint belongs to another model or holds
  /// values that no run produces, and FileError (of the sink) if the recorded files do not match it.
  /// After an error only the destructor may be called.
  void resume(const std::string& checkpoint, std::optional<double> changed = {});

  /// Evaluates the state at the start, and observers see it; run() and step() do so themselves.
  /// False: an exception has ended the run, see report().
  bool start();
  /// Runs to `until` of the model's simulation settings. Does not throw: errors are in the report.
  /// If memory runs out, or the sink can store no more, the run ends as failed with that cause;
  /// checkpoint() then holds the last state that is known completely.
  const RunReport& run();
  /// Takes the next step of the run with everything that run() does: records, checks, ledger, hash,
  /// checkpoints; `while (s.step()) {}` does the same as run(). A step of given length is a full
  /// step, even if it was taken in halves or parts. True: there is a new state(). False: the run
  /// has ended for the reason in report(), which holds the figures so far until then. `until` of the
  /// model's settings may be moved ahead before a step: a step that ended there is then followed by
  /// others.
  bool step();
  /// From now on a number that an element reserved has this value: what a controller outside of the
  /// model sets between two steps, also while observers see a step.
  void input(MemoryHandle m, double value) { step_.change().memory[m.first] = value; }
  /// Blocks that sampled at the end of the last step sample there again, with the inputs of now:
  /// what a controller outside sets at an instant of theirs counts at this instant.
  void sampleAgain();
  const RunReport& report() const { return report_; }
  const State& state() const { return step_.x(); }
  /// Report of the step that was tried last; dt = 0: none yet.
  const StepReport& lastStep() const { return step_.report(); }
  std::vector<CheckResult> checks() const { return observers_.checks(); }
  /// The bytes that `resume` takes: the state at the end of the run, or before its last step if
  /// that was shortened.
  const std::string& checkpoint() const { return checkpoints_.bytes(); }
  /// The bytes that `resume` takes, of the present state; between two steps only.
  std::string archived();

 private:
  StepReport attempt(double tEnd, double dt, StepTry how) override;
  bool accept() override;
  void reject() override;
  bool fail(const StepReport& report) override;
  bool sound() const override { return step_.sound(); }
  Coarseness coarseness() override { return step_.coarseness(); }
  void divided(int parts) override;
  Passing passing(double ahead) override;
  void leave(const Passing& p) override;
  double t() const override { return step_.x().t; }
  double nextStep() const override { return model_.scheme().nextStep(step_.x()); }
  Spent spent() const override;
  bool pause(bool asked) override;

  template <class Call>
  void guarded(Call&& call);
  bool next();
  void end();
  bool endBecause(std::string reason, RunReport::Cause cause = RunReport::Cause::simulation);
  void outOfMemory() noexcept;
  bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }
  void stopWithin();
  void archive(Archive& a);

  Model& model_;
  std::unique_ptr<Workers> workers_;
  Sleep sleep_;
  MechanicalSystem system_;
  StepAttempt step_;
  Sweep sweep_;
  std::unique_ptr<TimeLoop> loop_;
  RunReport report_;
  RunObservers observers_;
  UnsolvedSteps unsolved_;
  Checkpoints checkpoints_;
  IdleCalls idle_;
  const std::atomic<bool>* stop_ = nullptr;
  std::vector<char> spare_;  // freed when memory runs out, so that the run can end in order
  /// Observers and loop are at the state of the last pause, which is the state before the step if
  /// one was attempted since.
  bool whole_ = false;
  SolverWork solvers_;
  bool cheap_ = false;  // a part of the present full step was taken at a small cost
  bool resumed_ = false;
  bool begun_ = false, over_ = false;
};

}  // namespace dynamy
