#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/simulation/report/ledger_rows.hpp>
#include <numeric>

namespace dynamy {
namespace {

constexpr double kRows = 400.0;
/// Impacts with rows of their own: a body that rattles has millions.
constexpr long kMostImpacts = 1000;

/// The works of a ledger and what they leave; first those that smooth motion can change.
constexpr std::array kWorks{&EnergyReport::nonPotential, &EnergyReport::friction,
                            &EnergyReport::boundaries,   &EnergyReport::discretisation,
                            &EnergyReport::normal,       &EnergyReport::joints};
constexpr std::size_t kShared = 4;  ///< normal forces and joints do work in impacts alone
using Works = std::array<double, kWorks.size()>;

double sum(const Works& w) { return std::accumulate(w.begin(), w.end(), 0.0); }

/// Adds `rest` to the works of smooth motion in proportion to their sizes in a step.
void share(double rest, const Works& sizes, Works& to) {
  double all = 0.0;
  for (std::size_t i = 0; i < kShared; ++i) all += std::abs(sizes[i]);
  for (std::size_t i = 0; i < kShared && all > 0.0; ++i) to[i] += rest * std::abs(sizes[i]) / all;
  if (all == 0.0) to[kShared - 1] += rest;
}

EnergyReport withWorks(EnergyReport e, const Works& w) {
  for (std::size_t i = 0; i < w.size(); ++i) e.*kWorks[i] = w[i];
  return e;
}

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
  const double near = 1e-9 * view.report.dt, end = view.after.t;
  const bool located = view.report.works.given && !view.report.resting && view.report.dt > 0.0;
  const bool jumps =
      located && view.report.uBeforeImpact != nullptr && impacts_ < kMostImpacts + next_;
  if (located && (jumps || grid_.at(next_) < end - near)) within(view, jumps);
  // Other steps have values at their ends alone.
  if (grid_.at(next_) > end + near && !jumps) return;
  while (grid_.at(next_) <= end + near) ++next_;
  row(view);
}

/// Rows at the instants of the grid within a step, and one before the impact at its end.
void LedgerRows::within(const StepView& view, bool jumps) {
  const EnergyReport end = ledger_.upTo(view.after), start = ledger_.upTo(view.before);
  const StepWorks& w = view.report.works;
  Works all, grown{w.nonPotential, w.friction, w.boundaries, 0.0, w.normal, w.joints};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = end.*kWorks[i];
  grown[kShared - 1] = (end.end() - start.end()) - sum(grown);
  EnergyReport before = end;
  if (jumps) {
    at_.t = view.after.t, at_.q = view.after.q, at_.u = *view.report.uBeforeImpact;
    at_.memory = view.before.memory;
    before = ledger_.upTo(at_);
    Works impact{0.0, 0.0, 0.0, 0.0, w.normal, w.joints};
    share((end.end() - before.end()) - sum(impact), {0.0, w.friction, w.boundaries, 0.0}, impact);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] -= impact[i], grown[i] -= impact[i];
    ++impacts_;
  }
  const double dt = view.after.t - view.before.t, near = 1e-9 * view.report.dt;
  for (; grid_.at(next_) < view.after.t - near; ++next_) {
    const double theta = (grid_.at(next_) - view.before.t) / dt;
    view.scheme.interpolate(view.system, view.before, view.after, theta, at_);
    at_.memory = view.before.memory;
    const EnergyReport now = ledger_.upTo(at_);
    Works works = all;
    for (std::size_t i = 0; i < works.size(); ++i) works[i] -= (1.0 - theta) * grown[i];
    share((now.end() - now.start()) - sum(works), grown, works);
    write(grid_.at(next_), withWorks(now, works));
  }
  if (jumps) write(view.after.t, withWorks(before, all));
}

void LedgerRows::finish(const StepView& last) {
  if (sink_.wantsLedger() && last_ < last.after.t) row(last);
}

void LedgerRows::row(const StepView& view) {
  // While nothing moves no energy changes.
  if (!rested_) energy_ = ledger_.upTo(view.after);
  rested_ = view.report.resting;
  write(view.after.t, energy_);
  residual_ = iterations_ = contacts_ = penetration_ = 0.0;
}

void LedgerRows::write(double t, const EnergyReport& e) {
  LedgerRow r;
  r.t = last_ = t;
  r.value = {e.kineticEnd, e.potentialEnd,   e.nonPotential, e.friction,  e.normal,  e.joints,
             e.boundaries, e.discretisation, residual_,      iterations_, contacts_, penetration_};
  sink_.ledger(r);
}

void LedgerRows::archive(Archive& a) {
  a.section("ledger rows");
  a(next_), a(impacts_), a(last_), a(residual_), a(iterations_), a(contacts_), a(penetration_);
  if (next_ < 0) throw ModelError("the checkpoint counts the rows of its ledger from below zero");
}

}  // namespace dynamy
