#include <dynamy/simulation/run/run_observers.hpp>
#include <dynamy/system/renewable.hpp>

namespace dynamy {

RunObservers::RunObservers(Model& model, RunReport& report)
    : model_(model),
      report_(report),
      statistics_(report),
      ledger_(model),
      gain_(model),
      watch_(model, ledger_, report),
      checks_(model) {
  for (const auto& o : model.observers()) others_.push_back(o.get());
}

void RunObservers::record(RecordSink& sink) {
  recorder_ = std::make_unique<Recorder>(model_, sink);
  ledgerRows_ = std::make_unique<LedgerRows>(ledger_, sink, model_.simulation.until);
  statistics_.tell(sink);
}

template <class Call>
void RunObservers::forAll(Call&& call) {
  call(motion_), call(statistics_), call(ledger_), call(watch_), call(checks_);
  if (ledgerRows_) call(*ledgerRows_);
  if (recorder_) call(*recorder_);
  for (Observer* o : others_) call(*o);
}

void RunObservers::start(const StepView& initial) {
  forAll([&](Observer& o) { o.start(initial); });
}

void RunObservers::step(const StepView& view) {
  forAll([&](Observer& o) { o.step(view); });
}

void RunObservers::failed(const StepView& view) {
  forAll([&](Observer& o) { o.failed(view); });
}

void RunObservers::finish(const StepView& last) {
  forAll([&](Observer& o) { o.finish(last); });
}

void RunObservers::archive(Archive& a) {
  forAll([&](Observer& o) { o.archive(a); });
}

void RunObservers::bring(const State& before, const State& after) {
  ledger_.bring(before, after);
  for (int i = 0; i < static_cast<int>(model_.systems().size()); ++i) {
    const Renewable* r = model_.systems()[static_cast<std::size_t>(i)]->abilities().renewable;
    const SystemHandle& s = model_.topology().system(i);
    if (r != nullptr && r->jumps() &&
        (before.q.segment(s.q0, s.nq) != after.q.segment(s.q0, s.nq) ||
         before.u.segment(s.u0, s.nu) != after.u.segment(s.u0, s.nu)))
      statistics_.event(after.t, ContactEvent::Of::jump, i);
  }
}

void RunObservers::slept(const StepView& view, const RestChange& change) {
  for (const int i : change.systems) statistics_.event(view.after.t, ContactEvent::Of::sleep, i);
  statistics_.rest(change.contacts);
  if (recorder_) {
    StepView rested = view;
    new (&rested.Lambda) ConstVec(change.Lambda.data(), change.Lambda.size());
    recorder_->rest(rested, change.contacts);
  }
  ledger_.take(change.energy);
}

void RunObservers::slow(const MechanicalSystem& system, const StepReport& report,
                        const State& before, State& after) {
  const double energy = gain_.takeBack(system, report, before, after);
  if (!(energy > 0.0)) return;
  ledger_.take(energy);
  RunTrust::Slowed& slowed = report_.trust.slowed;
  ++slowed.steps;
  if (energy > slowed.most) slowed.most = energy, slowed.t = after.t;
}

void RunObservers::woke(double t, const RestChange& change) {
  for (const int i : change.systems) statistics_.event(t, ContactEvent::Of::wake, i);
  statistics_.wake(change.contacts);
  if (recorder_) recorder_->wake(change.contacts);
  report_.cost.sleep.woken += static_cast<long>(change.systems.size());
}

void RunObservers::sumUp() {
  report_.energy = ledger_.report();
  report_.hash = motion_.value();
}

}  // namespace dynamy
