/// Simulation: runs the scheme and the solver of a built model from its initial state, or from a
/// checkpoint, to the end time:
///
///   loop (fixed steps, …) → attempt: OneStep::step → sound? → accept: observers see the step
///
/// A step neither throws nor prints nor allocates. A run ends at the first number that is not
/// finite and at the first mass matrix that is not positive definite. The error names the system
/// and its place, and the numbers recorded before are kept. Rejected: one loop with flags for all
/// ways to choose steps; each way is a TimeLoop.
#pragma once
#include <atomic>
#include <chrono>
#include <dynamy/simulation/report/checks.hpp>
#include <dynamy/simulation/report/ledger_rows.hpp>
#include <dynamy/simulation/report/motion_hash.hpp>
#include <dynamy/simulation/report/recorder.hpp>
#include <dynamy/simulation/report/run_watch.hpp>
#include <dynamy/simulation/run/search_pauses.hpp>
#include <dynamy/simulation/run/time_loop.hpp>
#include <dynamy/stages/projection.hpp>
#include <functional>

namespace dynamy {

class Simulation final : private Stepper {
 public:
  /// `model` is built and outlives the simulation. Throws ModelError if the model lacks the step or
  /// tolerance that its scheme needs, or if a check requests an unknown signal.
  explicit Simulation(Model& model);

  // Before the first step.
  /// Records into `sink`, which outlives the simulation. Throws ModelError for unknown signals.
  void record(RecordSink& sink);
  void observe(Observer& observer) { observers_.push_back(&observer); }
  /// Uses up to `count` threads for each step, fewer if the operating system gives no more. The
  /// results have the same bits with any number. Returns the number of threads in use.
  int threads(int count);
  /// Sets a function that is called about ten times a second of wall time, for progress and for
  /// files with rare rows.
  void onIdle(std::function<void()> call) { idle_ = std::move(call); }
  /// Sets a function that receives the bytes of a checkpoint before the first step, then every
  /// `seconds` of wall time. Checkpoints become rarer if they and the call take more than `share`
  /// of the time.
  void onCheckpoint(double seconds, double share, std::function<void(const std::string&)> call);
  /// The run ends once `flag` is true (Ctrl-C): after the present step, or before the next try or
  /// part of it. No recorded numbers are lost. If the run ended within a step, checkpoint() holds
  /// an earlier state, or is empty if none was stored.
  void stopWhen(const std::atomic<bool>& flag) { stop_ = &flag; }
  /// Continues from a checkpoint of the same model. Throws ModelError if the checkpoint belongs to
  /// another model or holds values that no run produces, and FileError (of the sink) if the
  /// recorded files do not match it. After an error only the destructor may be called.
  void resume(const std::string& checkpoint);

  /// Runs to `until` of the model's simulation settings. Does not throw: errors are in the report.
  /// If memory runs out, or the sink can store no more, the run ends as failed with that cause;
  /// checkpoint() then holds the last state that is known completely.
  const RunReport& run();
  /// Takes the next step of the run with everything that run() does: records, checks, ledger, hash,
  /// checkpoints; `while (s.step()) {}` does the same as run(). A step of given length is a full
  /// step, even if it was taken in halves or parts. True: there is a new state(). False: the run
  /// has ended for the reason in report(), which holds the figures so far until then.
  bool step();
  const RunReport& report() const { return report_; }
  const State& state() const { return x_; }
  /// Report of the step that was tried last; dt = 0: none yet.
  const StepReport& lastStep() const { return stepReport_; }
  std::vector<CheckResult> checks() const { return checks_.results(report_); }
  /// The bytes that `resume` takes: the state at the end of the run, or before its last step if
  /// that was shortened.
  const std::string& checkpoint() const { return checkpoint_; }

 private:
  StepReport attempt(double tEnd, double dt) override;
  bool accept() override;
  void reject() override;
  bool fail(const StepReport& report) override;
  bool sound() const override;
  Passing passing() override;
  void leave(const Passing& p) override;
  double t() const override { return x_.t; }
  double nextStep() const override { return model_.scheme().nextStep(x_); }
  long evaluations() const override { return report_.evaluations; }
  bool pause(bool asked) override;

  template <class Call>
  void guarded(Call&& call);
  bool next();
  void begin();
  void start();
  void end();
  StepView view(bool whole);
  bool endBecause(std::string reason, RunReport::Cause cause = RunReport::Cause::simulation);
  void outOfMemory() noexcept;
  bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }
  void stopWithin();
  void save();
  std::string stateFault() const;
  void noteUnsolved();
  std::string fault() const;
  template <class Call>
  void forAll(Call&& call) {
    call(motion_), call(statistics_), call(ledger_), call(watch_), call(checks_);
    if (ledgerRows_) call(*ledgerRows_);
    if (recorder_) call(*recorder_);
    for (Observer* o : observers_) call(*o);
  }
  void archive(Archive& a);
  void keep();
  void project();
  void renew();

  using Clock = std::chrono::steady_clock;
  Model& model_;
  std::unique_ptr<Workers> workers_;
  MechanicalSystem system_;
  State x_, before_;
  StepReport stepReport_;
  Projection projection_;
  Sweep sweep_;
  std::vector<double> zero_, gammaE_;
  std::unique_ptr<TimeLoop> loop_;
  SearchPauses searches_;
  RunReport report_;
  MotionHash motion_;
  StepStatistics statistics_;
  EnergyLedger ledger_;
  RunWatch watch_;
  Checks checks_;
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<LedgerRows> ledgerRows_;
  std::vector<Observer*> observers_;
  const std::atomic<bool>* stop_ = nullptr;
  std::function<void()> idle_;
  std::function<void(const std::string&)> save_;
  double saveEvery_ = 0.0, saveShare_ = 1.0, saveCost_ = 0.0;
  Clock::time_point lastIdle_, lastSave_;
  std::vector<char> spare_;  // freed when memory runs out, so that the run can end in order
  /// `whole_`: observers and loop are at the state of the last pause, which is `before_` if a step
  /// has been `attempted_` since.
  bool whole_ = false, attempted_ = false;
  std::string checkpoint_;
  bool resumed_ = false, renews_ = false;
  bool begun_ = false, over_ = false;
  int diagnoses_ = 0;
};

}  // namespace dynamy
