#include <algorithm>
#include <ctime>
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/own_steps.hpp>
#include <dynamy/simulation/run/run_faults.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <exception>
#include <utility>

namespace dynamy {
namespace {

constexpr std::size_t kSpare = std::size_t{1} << 20;  ///< [byte]

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

/// Thrown if the run is requested to stop within a step.
struct Stopped {};

/// Beginning of the model file, as the place of elements that are missing; no place for a model
/// without a file.
Place beginning(const Model& model) {
  return model.file.name.empty() ? Place() : Place(model.file.name, 1, 1);
}

std::unique_ptr<TimeLoop> loopOf(Model& model, const StepPlan* plan) {
  model.readyScheme();
  if (model.scheme().findsContacts()) {
    for (const auto& e : model.systems())
      if (e->abilities().renewable == nullptr) refuseSwitching(*e, model.scheme().type());
    for (const auto& e : model.forces()) refuseSwitching(*e, model.scheme().type());
  }
  const SimulationSettings& s = model.simulation;
  Diagnostic d;
  if (model.systems().empty()) {
    d.place = beginning(model);
    d.text = "the model has no system: nothing can move";
    d.hint = "put a <RigidBody> or another system into <systems>";
    throw ModelError(d);
  }
  if (plan != nullptr && !(plan->stops.empty() && plan->steps.empty()))
    return std::make_unique<PlannedSteps>(*plan);
  const int nu = model.topology().nu();
  if (model.scheme().choosesSteps() && (s.step > 0.0 || !model.scheme().needsStep()))
    return std::make_unique<OwnSteps>(s.step, s.onNonConvergence, nu, SampleInstants(model));
  if (s.step > 0.0)
    return std::make_unique<FixedStep>(s.step, s.onNonConvergence, nu, model.schemeIsDefault(),
                                       SampleInstants(model));
  d.place = s.place, d.element = "simulation";
  if (s.place.line == 0) {
    d.place = beginning(model), d.element.clear();
    d.text = "no <simulation> says how long and how accurately";
    d.hint = "add <simulation until=\"1\" tolerance=\"1e-6\"/>, or step=\"1e-3\"";
  } else if (s.tolerance > 0.0) {
    d.text = "<" + model.scheme().type() + "> takes steps of given length, not a tolerance";
    d.hint = "leave the scheme out, or replace the tolerance by a step, e.g. step=\"1e-3\"";
  } else {
    d.text = "neither a tolerance nor a step is given";
    d.hint = "add one, e.g. tolerance=\"1e-6\", or run with --tolerance 1e-6";
  }
  throw ModelError(d);
}

}  // namespace

Simulation::Simulation(Model& model, const StepPlan* plan)
    : model_(model),
      sleep_(model, plan != nullptr),
      system_(model.mechanicalSystem(sleep_.awake())),
      step_(model, system_, &sleep_, plan != nullptr ? plan->from : nullptr),
      loop_(loopOf(model, plan)),
      observers_(model, report_),
      unsolved_(model, system_, report_.solver.unsolved) {
  sleep_.begin(system_.parts());
  system_.limits.work = &solvers_;
}

void Simulation::record(RecordSink& sink) { observers_.record(sink); }

int Simulation::threads(int count) {
  system_.limits.workers = nullptr;
  workers_.reset();
  if (count < 2) return 1;
  workers_ = std::make_unique<Workers>(count);
  system_.limits.workers = workers_.get();
  return workers_->threads();
}

const RunReport& Simulation::run() {
  if (over_) return report_;
  guarded([this] {
    while (next()) {
    }
  });
  return report_;
}

bool Simulation::step() {
  bool taken = false;
  if (!over_) guarded([&] { taken = next(); });
  return taken;
}

/// Runs `call`; anything that it throws ends the run and is reported.
template <class Call>
void Simulation::guarded(Call&& call) {
  const auto wall = Clock::now();
  const std::clock_t cpu = std::clock();
  const double wallBefore = report_.cost.wall, cpuBefore = report_.cost.cpu;
  // No observer is called again: what it would write may be what could not be written.
  const auto endThrown = [this](std::string reason) {
    endBecause(std::move(reason));
    report_.t = t();
    observers_.sumUp();
  };
  try {
    call();
  } catch (const Stopped&) {
    stopWithin();
  } catch (const std::bad_alloc&) {
    outOfMemory();
  } catch (const ElementFault& e) {
    endThrown("t = " + numberText(t()) + " s: " + e.what());
  } catch (const std::exception& e) {  // of observers and files: a full disk, a user's observer
    const std::string law = lawThatThrows(system_);
    endThrown(law.empty() ? e.what() : "t = " + numberText(t()) + " s: " + law);
  } catch (...) {
    const std::string law = lawThatThrows(system_);
    endThrown("t = " + numberText(t()) +
              " s: " + (law.empty() ? "something was thrown that is no std::exception" : law));
  }
  report_.cost.wall = wallBefore + seconds(Clock::now() - wall);
  report_.cost.cpu = cpuBefore + static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
}

/// Takes one step; begins the run before the first step and ends it after the last one. False: it
/// has ended.
bool Simulation::next() {
  if (!start()) return false;
  over_ = true;  // an exception ends the run
  system_.limits.end = model_.simulation.until;
  const bool good = report_.ended == RunReport::Ended::finished;
  if (good && loop_->next(*this, model_.simulation.until) == Advance::taken) {
    over_ = false;
    return true;
  }
  end();
  return false;
}

bool Simulation::start() {
  if (begun_) return !over_;
  begun_ = over_ = true;  // an exception ends the run
  guarded([this] {
    const Clock::time_point now = Clock::now();
    idle_.begin(now), checkpoints_.begin(now);
    report_.ended = RunReport::Ended::finished, report_.cause = RunReport::Cause::simulation;
    spare_.resize(kSpare);
    if (!resumed_) {
      report_.start = step_.start();
      observers_.start(step_.view(report_.steps + 1, true));
    }
    whole_ = true, step_.settle();
    if (checkpoints_.hasReceiver() && !resumed_)
      checkpoints_.handOn([this] { checkpoints_.keep(archived()); });
    std::string reason = step_.fault();
    if (reason.empty()) reason = SampleInstants(model_).fault(model_.simulation.until);
    if (!reason.empty()) endBecause(reason);
    over_ = false;
  });
  return !over_;
}

void Simulation::end() {
  // A run resumed at its end takes no step, which would have evaluated the system.
  const bool stepped = step_.report().dt > 0.0, failed = report_.ended == RunReport::Ended::failed;
  if (failed || (resumed_ && !stepped)) system_.evaluate(step_.x());
  observers_.finish(step_.view(report_.steps + 1, !failed && stepped));
  report_.t = t(), report_.cost.sleep.reason = sleep_.reason();
  observers_.sumUp();
}

StepReport Simulation::attempt(double tEnd, double dt, StepTry how) {
  // Else seen at the step's end.
  if ((step_.attempted() || !whole_) && stopped()) throw Stopped{};
  const long evaluations = system_.evaluations();
  if (!step_.take(tEnd, dt, stop_, how)) throw Stopped{};
  cheap_ |= how == StepTry::cheap;
  report_.cost.evaluations += system_.evaluations() - evaluations;
  return step_.report();
}

Passing Simulation::passing(double ahead) {
  if (model_.scheme().findsContacts() || step_.report().resting) return {};
  const Passing p = ahead > 0.0 ? sweep_.ahead(system_, step_.x(), ahead)
                                : sweep_.look(system_, model_.scheme(), step_.before(), step_.x());
  report_.passing.swept = sweep_.paths();
  if (p) ++report_.passing.parted;
  return p;
}

void Simulation::divided(int parts) {
  ++report_.passing.divided;
  report_.passing.finest = std::max(report_.passing.finest, parts);
}

Spent Simulation::spent() const {
  const double visits = static_cast<double>(solvers_.visits), nu = model_.topology().nu();
  const long n = report_.cost.evaluations;
  const double implicit = system_.implicitForces().work();
  return {n, nu * static_cast<double>(n) + sweep_.work() + visits + implicit, implicit};
}

void Simulation::leave(const Passing& p) {
  PassingReport& passing = report_.passing;
  if (++passing.left > 1) return;
  passing.firstLeft.t = step_.before().t, passing.firstLeft.contact = p.contact;
  if (p) passing.firstLeft.name = contactText(model_, p.contact);
}

bool Simulation::accept() {
  if (!sound()) {
    std::string reason = step_.fault();
    report_.refused = !step_.report().refused.empty();
    step_.undo();
    step_.clear();
    return endBecause(std::move(reason));
  }
  whole_ = false;
  if (!step_.report().solved.ok())
    unsolved_.note(report_.steps + 1, t(), step_.report(), !stopped());
  const long evaluations = system_.evaluations();
  if (const RestChange woken = sleep_.woken(); !woken.systems.empty())
    observers_.woke(step_.before().t, woken);
  observers_.step(step_.view(report_.steps + 1, true));
  const bool fixed = !model_.scheme().choosesSteps() && model_.schemeIsDefault();
  if (fixed || step_.report().counts.stepped)
    observers_.slow(system_, step_.report(), step_.before(), step_.change());
  sleep_.settle(system_, step_.change(), step_.report().dt, report_.cost.sleep);
  if (!sleep_.slept().systems.empty())
    observers_.slept(step_.view(report_.steps + 1, true), sleep_.slept());
  report_.cost.evaluations += system_.evaluations() - evaluations;  // for dense output and trials
  if (State old; step_.renew(old)) observers_.bring(old, step_.x());
  if (report_.trust.diverged) return endBecause(divergence(model_, step_.x(), report_.trust));
  return true;
}

void Simulation::reject() {
  if (!step_.report().solved.ok() && sound()) {
    unsolved_.note(report_.steps + 1, t(), step_.report(), !stopped());
    step_.undo();
    observers_.failed(step_.view(report_.steps + 1, true));
  }
  step_.undo();
  ++report_.rejected;
}

bool Simulation::fail(const StepReport& report) {
  std::string reason = missedTolerance(model_, system_, t(), report.solved);
  step_.clear();
  return endBecause(std::move(reason));
}

bool Simulation::pause(bool asked) {
  whole_ = true, step_.settle();
  if (std::exchange(cheap_, false)) ++report_.passing.bounded;
  const Clock::time_point now = Clock::now();
  idle_.at(now);
  const bool stop = stopped(), due = checkpoints_.due(now);
  const auto full = [this] { return !observers_.sinkFault().empty(); };
  if (stop || due || asked || full()) checkpoints_.keep(archived());
  if (due) checkpoints_.handOn([this] { checkpoints_.keep(archived()); });
  if (stop) report_.ended = RunReport::Ended::stopped;
  // keep() has tried once more to write the collected rows.
  if (!stop && full())
    return endBecause(std::string(observers_.sinkFault()), RunReport::Cause::files);
  return !stop;
}

bool Simulation::endBecause(std::string reason, RunReport::Cause cause) {
  report_.ended = RunReport::Ended::failed, report_.cause = cause;
  report_.reason = std::move(reason);
  return false;
}

void Simulation::archive(Archive& a) {
  a.section("dynamy checkpoint 19");  // the number counts changes of the layout
  a(step_), a(*loop_), a(report_), a(observers_);
}

void Simulation::resume(const std::string& checkpoint, std::optional<double> changed) {
  Archive a(checkpoint);
  archive(a);
  refuseForeign(model_, a, step_.x());
  step_.resumed();
  if (changed) {
    step_.change().scheme.resize(0);
    step_.start();
    observers_.changed(*changed, step_.x());
  }
  checkpoints_.keep(changed ? archived() : checkpoint);
  resumed_ = true;
}

void Simulation::sampleAgain() {
  State& x = step_.change();
  for (const auto& force : model_.forces()) {
    const MemoryHandle m = model_.topology().memories().of(*force);
    if (m.size > 0 && model_.signal(force->name() + '.' + kNextSample) != nullptr)
      x.memory.segment(m.first, m.size) = step_.before().memory.segment(m.first, m.size);
  }
  system_.remember(x);
}

std::string Simulation::archived() {
  Archive a;
  archive(a);
  return a.bytes();
}

/// Ends the run within a step. Parts of the step that observers have seen are kept; a step that was
/// only tried is undone. In both cases the recorder adds no last row.
void Simulation::stopWithin() {
  report_.ended = RunReport::Ended::stopped;
  report_.reason =
      "t = " + numberText(t()) + " s: stopped within a step" +
      (whole_ ? ", which was taken back" : " of many parts; a checkpoint is of an earlier moment");
  if (whole_) checkpoints_.keep(archived());
  step_.clear();
  end();
}

/// Ends the run when memory runs out. The step that needed the memory is undone if no observer has
/// seen it.
void Simulation::outOfMemory() noexcept {
  report_.ended = RunReport::Ended::failed, report_.cause = RunReport::Cause::memory;
  spare_ = {};
  try {
    if (whole_ && step_.attempted()) step_.undoInPlace();
    step_.settle();
    report_.t = t();
    report_.reason = "t = " + numberText(t()) + " s: out of memory";
    if (whole_) checkpoints_.keep(archived());
    end();
  } catch (...) {  // checkpoint() then holds an earlier state
  }
}

}  // namespace dynamy
