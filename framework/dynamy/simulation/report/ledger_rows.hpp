/// LedgerRows: the energy ledger and the solver's figures along the run, a few hundred rows for the
/// strips of the replay. T and V cost an evaluation of the masses each time, so that not every step
/// has a row.
///
/// A located step may be longer than the distance of two rows. Rows within it have T and V of the
/// interpolated state. Its works are known at its end alone: they grow in proportion to time, and
/// what T + V shows beyond that, ΔE, is shared by the works w that smooth motion can do,
///
///   w_i(θ) = w_i^A + θ Δw_i + (ΔE(θ) − Σ θ Δw_k) |Δw_i| / Σ |Δw_k|
///
/// so that the sum of a row is exact, and with it a work that is alone. An impact at the end of the
/// step has a row on each side of it: all works of normal forces and joints in this step are its.
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
  void within(const StepView& view, bool jumps);
  void write(double t, const EnergyReport& e);
  void row(const StepView& view);
  EnergyLedger& ledger_;
  RecordSink& sink_;
  TimeGrid grid_;
  long next_ = 0, impacts_ = 0;  ///< the next row of the grid; impacts that have rows
  double last_ = -1.0;           ///< time of the last row [s]
  bool rested_ = false;          ///< all steps since the last row, and its own
  EnergyReport energy_;
  State at_;  ///< within a step
  /// Worst values since the last row.
  double residual_ = 0.0, iterations_ = 0.0, contacts_ = 0.0, penetration_ = 0.0;
};

}  // namespace dynamy
