#include <algorithm>
#include <dynamy/simulation/report/ledger_rows.hpp>

namespace dynamy {
namespace {

constexpr double kRows = 400.0;

/// Largest penetration of the unilateral contacts [m].
double penetration(const ContactSet& c) {
  double worst = 0.0;
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    if (!(-c.g[i] > worst)) continue;
    const int closed = c.closedIndex[i];
    const bool joint = closed >= 0 && !c.law[static_cast<std::size_t>(closed)]->unilateral();
    if (!joint) worst = -c.g[i];
  }
  return worst;
}

}  // namespace

LedgerRows::LedgerRows(EnergyLedger& ledger, RecordSink& sink, double until)
    : ledger_(ledger), sink_(sink), grid_(until > 0.0 ? until / kRows : 1.0) {}

void LedgerRows::start(const StepView& initial) {
  if (!sink_.wantsLedger()) return;
  row(initial);
  next_ = 1;
}

void LedgerRows::step(const StepView& view) {
  if (!sink_.wantsLedger()) return;
  if (!view.report.resting) rested_ = false;
  residual_ = std::max(residual_, view.report.solved.residuals.largest());
  iterations_ = std::max(iterations_, static_cast<double>(view.report.solved.iterations));
  contacts_ = std::max(contacts_, static_cast<double>(view.report.contacts));
  penetration_ = std::max(penetration_, penetration(view.system.slot(0).contacts));
  // Rows are written at the ends of steps: the ledger has no values within a step.
  const double reached = view.after.t + 1e-9 * view.report.dt;
  if (grid_.at(next_) > reached) return;
  while (grid_.at(next_) <= reached) ++next_;
  row(view);
}

void LedgerRows::finish(const StepView& last) {
  if (sink_.wantsLedger() && last_ < last.after.t) row(last);
}

void LedgerRows::row(const StepView& view) {
  // While nothing moves no energy changes.
  if (!rested_) energy_ = ledger_.upTo(view.after);
  rested_ = view.report.resting;
  const EnergyReport& e = energy_;
  LedgerRow r;
  r.t = last_ = view.after.t;
  r.value = {e.kineticEnd, e.potentialEnd,   e.nonPotential, e.friction,  e.normal,  e.joints,
             e.boundaries, e.discretisation, residual_,      iterations_, contacts_, penetration_};
  sink_.ledger(r);
  residual_ = iterations_ = contacts_ = penetration_ = 0.0;
}

void LedgerRows::archive(Archive& a) {
  a.section("ledger rows");
  a(next_), a(last_), a(residual_), a(iterations_), a(contacts_), a(penetration_);
  if (next_ < 0) throw ModelError("the checkpoint counts the rows of its ledger from below zero");
}

}  // namespace dynamy
