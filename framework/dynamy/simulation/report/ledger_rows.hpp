/// LedgerRows: the energy ledger and the solver's figures along the run, a few hundred rows for the
/// strips of the replay. T and V cost an evaluation of the masses each time, so that not every step
/// has a row.
#pragma once
#include <dynamy/simulation/model/time_grid.hpp>
#include <dynamy/simulation/report/energy_ledger.hpp>
#include <dynamy/simulation/report/record_sink.hpp>

namespace dynamy {

class LedgerRows final : public Observer {
 public:
  /// `ledger` sees every step before this observer does.
  LedgerRows(EnergyLedger& ledger, RecordSink& sink, double until);
  void start(const StepView& initial) override;
  void step(const StepView& view) override;
  void finish(const StepView& last) override;
  void archive(Archive& a) override;

 private:
  void row(const StepView& view);
  EnergyLedger& ledger_;
  RecordSink& sink_;
  TimeGrid grid_;
  long next_ = 0;
  double last_ = -1.0;   ///< time of the last row [s]
  bool rested_ = false;  ///< all steps since the last row, and its own
  EnergyReport energy_;
  /// Worst values since the last row.
  double residual_ = 0.0, iterations_ = 0.0, contacts_ = 0.0, penetration_ = 0.0;
};

}  // namespace dynamy
