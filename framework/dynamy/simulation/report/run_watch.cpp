#include <algorithm>
#include <dynamy/located/governed/switch_governor.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/run_watch.hpp>

namespace dynamy {
namespace {

/// Growth of T since its largest sample that is worth another one: what bursts apart at a start, or
/// diverges, has lost its energy again at the next of the regular ones, or ends the run before.
constexpr double kFaster = 1.2;

constexpr double kSamples = 256.0;  ///< samples of the energy in a run
/// After the first kFirst steps only three in a row of every kEvery are examined, so that watching
/// costs little.
constexpr long kFirst = 256, kEvery = 16;

}  // namespace

RunWatch::RunWatch(Model& model, EnergyLedger& ledger, RunReport& report)
    : length_(model.length()),
      report_(report),
      energy_(ledger, report),
      gaps_(model, report),
      resolution_(model, report),
      travel_(model, report),
      sampleEvery_(std::max(model.simulation.until, 0.0) / kSamples) {}

void RunWatch::start(const StepView& initial) {
  energy_.start(initial);
  sample(initial);
  gaps_.start(initial);
}

void RunWatch::step(const StepView& view) {
  if (view.report.resting) return resolution_.skip();
  if (!view.scheme.choosesSteps()) travel_.contacts(view);
  // Schemes that choose their steps control the resolution of the motion themselves.
  if (!view.scheme.choosesSteps() && (view.index <= kFirst || view.index % kEvery < 3)) {
    travel_.step(view);
    energy_.forcesGive(resolution_.step(view));
  } else {
    resolution_.skip();
  }
  if (const int damped = view.system.implicitForces().damped(); damped > 0) {
    report_.trust.damped = std::max(report_.trust.damped, damped);
    if (!view.scheme.choosesSteps()) energy_.damped(view);
  }
  gaps_.step(view);
  if (view.after.t >= nextSample_) return sample(view);
  if (const double T = kineticEnergy(view); !(T <= kFaster * fastest_)) {
    fastest_ = T;
    energy_.sample(view);
  }
}

/// T with the masses of the last evaluation [J].
double RunWatch::kineticEnergy(const StepView& view) {
  return view.system.slot(0).mass.kineticEnergy(dynamy::view(view.after.u));
}

void RunWatch::sample(const StepView& view) {
  if (view.after.t == lastSample_) return;
  lastSample_ = view.after.t;
  nextSample_ = view.after.t + sampleEvery_;
  fastest_ = std::max(fastest_, kineticEnergy(view));
  energy_.sample(view);
  gaps_.sample(view);
}

void RunWatch::finish(const StepView& last) {
  sample(last);
  GapReport& gaps = report_.gaps;
  for (Worst* w : {&report_.solver.residual, &gaps.penetration, &gaps.atStart, &gaps.solvedOverlap,
                   &gaps.jointError})
    if (w->value > 0.0) w->name = contactName(last.model, w->contact);
  if (Worst& first = report_.stepping.first;
      report_.stepping.periods > 0 && first.contact != SwitchGovernor::kNowhere)
    first.name = contactName(last.model, first.contact);
  resolution_.finish();
  report_.warnings = warningsOf(report_, length_);
}

void RunWatch::archive(Archive& a) {
  a.section("watch");
  a(nextSample_), a(lastSample_);
  a(energy_), a(gaps_), a(resolution_), a(fastest_);
}

}  // namespace dynamy
