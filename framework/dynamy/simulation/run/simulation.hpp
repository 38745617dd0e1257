/// Simulation: runs the scheme and the solver of a built model from its initial state, or from a
/// checkpoint, to the end time:
///
///   loop (fixed steps, …) → attempt: OneStep::step → sound? → accept: observers see the step
///
/// A step neither throws nor prints nor allocates. A run ends at the first number that is not
/// finite and at the first mass matrix that is not positive definite, naming the system and its
/// place; what was recorded before stays. Rejected: one loop with switches for all ways to choose
/// steps; each is a TimeLoop.
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
  /// `model` is built and outlives the simulation. Throws ModelError if it does not say a step, or
  /// if a check asks for an unknown signal.
  explicit Simulation(Model& model);

  // Before the first step.
  /// Records into `sink`, which outlives the simulation. Throws ModelError for unknown signals.
  void record(RecordSink& sink);
  void observe(Observer& observer) { observers_.push_back(&observer); }
  /// Works on each step with up to `count` threads, fewer if the system gives no more; the same
  /// bits with any number. Returns how many there are.
  int threads(int count);
  /// Called about ten times a second of wall time, for progress and files with rare rows.
  void onIdle(std::function<void()> call) { idle_ = std::move(call); }
  /// Called with the bytes of a checkpoint before the first step, then every `seconds` of wall
  /// time, later if making them and the call take more than `share` of it.
  void onCheckpoint(double seconds, double share, std::function<void(const std::string&)> call);
  /// The run ends once `flag` is true (Ctrl-C): after the present step, or before the next try or
  /// part of it. Nothing recorded is lost; checkpoint() of a run that ended within a step is of an
  /// earlier moment, or empty if none was made.
  void stopWhen(const std::atomic<bool>& flag) { stop_ = &flag; }
  /// Goes on from a checkpoint of the same model. Throws ModelError if it belongs to another one or
  /// holds what no run can have left, FileError (of the sink) if the recorded files do not go with
  /// it: nothing is to be called then but the destructor.
  void resume(const std::string& checkpoint);

  /// Runs to `until` of the model's simulation settings. Does not throw: the report tells. A lack
  /// of memory, and a sink that can keep no more, end it as failed with their cause, and
  /// checkpoint() is of the last moment that is known as a whole.
  const RunReport& run();
  /// The next step of the same run, with all that run() does: records, checks, ledger, hash,
  /// checkpoints; `while (s.step()) {}` is run(). A step of given length is a full one, whatever
  /// halves or parts it took. True: there is a new state(). False: the run has ended, and report()
  /// tells how; until then its figures are those so far.
  bool step();
  const RunReport& report() const { return report_; }
  const State& state() const { return x_; }
  /// The step that was tried last; dt = 0: none yet.
  const StepReport& lastStep() const { return stepReport_; }
  std::vector<CheckResult> checks() const { return checks_.results(report_); }
  /// What `resume` takes: the state at the end of the run, before a last shortened step.
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
  std::vector<char> spare_;  // given back when memory runs out, so that the end has some
  /// What observers have seen, and the loop has counted, is the state of the last pause: `before_`
  /// if a step has been attempted since.
  bool whole_ = false, attempted_ = false;
  std::string checkpoint_;
  bool resumed_ = false, renews_ = false;
  bool begun_ = false, over_ = false;
  int diagnoses_ = 0;
};

}  // namespace dynamy
