/// RunObservers: all that see the steps of a run, in this order: the hash of the motion, statistics,
/// the energy ledger, the watch over the figures, checks, rows of the ledger, the recorder, and the
/// observers of the model and of users. Later ones read what earlier ones have found.
#pragma once
#include <dynamy/simulation/report/checks.hpp>
#include <dynamy/simulation/report/ledger_rows.hpp>
#include <dynamy/simulation/report/motion_hash.hpp>
#include <dynamy/simulation/report/recorder.hpp>
#include <dynamy/simulation/report/run_watch.hpp>
#include <dynamy/simulation/report/step_statistics.hpp>
#include <dynamy/simulation/run/energy_gain.hpp>
#include <dynamy/simulation/run/sleep.hpp>

namespace dynamy {

class RunObservers {
 public:
  /// Figures go to `report`; both arguments outlive the observers. Throws ModelError if a check
  /// requests an unknown signal.
  RunObservers(Model& model, RunReport& report);
  RunObservers(const RunObservers&) = delete;
  RunObservers& operator=(const RunObservers&) = delete;
  /// Adds an observer, which outlives the run.
  void add(Observer& observer) { others_.push_back(&observer); }
  /// Records into `sink`, which outlives the run. Throws ModelError for unknown signals.
  void record(RecordSink& sink);

  // The calls of Observer, to all of them.
  void start(const StepView& initial);
  void step(const StepView& view);
  void failed(const StepView& view);
  void finish(const StepView& last);
  void archive(Archive& a);

  /// Books a change of state between two steps, which is no motion: systems were renewed.
  void bring(const State& before, const State& after);
  /// Books a change of parameters between two steps; T + V was `energy` [J] before.
  void changed(double energy, const State& x) { ledger_.take(energy - ledger_.upTo(x).end()); }
  /// Takes the energy back that the step from `before` to `after` gained without a cause.
  void slow(const MechanicalSystem& system, const StepReport& report, const State& before,
            State& after);
  /// Systems fell asleep at the end of this step, or woke at t [s].
  void slept(const StepView& view, const RestChange& change);
  void woke(double t, const RestChange& change);
  /// Puts the figures into the report that are known at the end only.
  void sumUp();
  /// Why the sink can store no more; empty: it can, or there is none.
  std::string_view sinkFault() const { return recorder_ ? recorder_->fault() : ""; }
  std::vector<CheckResult> checks() const { return checks_.results(report_); }

 private:
  template <class Call>
  void forAll(Call&& call);
  Model& model_;
  RunReport& report_;
  MotionHash motion_;
  StepStatistics statistics_;
  EnergyLedger ledger_;
  EnergyGain gain_;
  RunWatch watch_;
  Checks checks_;
  std::unique_ptr<LedgerRows> ledgerRows_;
  std::unique_ptr<Recorder> recorder_;
  std::vector<Observer*> others_;
};

}  // namespace dynamy
