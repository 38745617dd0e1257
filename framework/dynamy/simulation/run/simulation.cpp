#include <algorithm>
#include <ctime>
#include <dynamy/core/declared/element_fault.hpp>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/own_steps.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <exception>
#include <utility>

namespace dynamy {
namespace {

constexpr double kIdleSeconds = 0.1;
constexpr std::size_t kSpare = std::size_t{1} << 20;  ///< [byte]

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

/// Thrown if the run is requested to stop within a step.
struct Stopped {};

/// Beginning of the model file, as the place of elements that are missing; no place for a model
/// without a file.
Place beginning(const Model& model) {
  return model.sourceFile.empty() ? Place() : Place(model.sourceFile, 1, 1);
}

std::unique_ptr<TimeLoop> loopOf(Model& model) {
  model.readyScheme();
  if (model.scheme().findsContacts()) {
    for (const auto& e : model.systems()) refuseSwitching(*e, model.scheme().type());
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
  const int nu = model.topology().nu();
  if (model.scheme().choosesSteps() && (s.step > 0.0 || !model.scheme().needsStep()))
    return std::make_unique<OwnSteps>(s.step, s.onNonConvergence, nu);
  if (s.step > 0.0) return std::make_unique<FixedStep>(s.step, s.onNonConvergence, nu);
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

/// Message of the first law of the last problem that throws, to explain an exception from a solver;
/// empty: none throws.
std::string lawThatThrows(const MechanicalSystem& system) {
  const InclusionProblem& p = system.problem();
  const auto rows = static_cast<std::size_t>(p.rows());
  if (p.gammaFree.size() != rows || p.gammaA.size() != rows) return {};  // none was set up
  std::vector<double> r, xi, Lambda;
  for (int i = 0; i < p.size(); ++i) {
    const auto n = static_cast<std::size_t>(p.dim(i));
    const auto first = p.gammaFree.begin() + p.row0(i);
    r.assign(n, 1.0), xi.assign(first, first + p.dim(i)), Lambda.assign(n, 0.0);
    try {
      named(p.law(i), [&] { p.law(i).prox(p.input(i), r.data(), xi.data(), Lambda.data()); });
    } catch (const ElementFault& e) {
      return e.what();
    }
  }
  return {};
}

}  // namespace

Simulation::Simulation(Model& model)
    : model_(model),
      system_(model.mechanicalSystem()),
      x_(model.initialState()),
      before_(x_),
      loop_(loopOf(model)),
      statistics_(report_),
      ledger_(model),
      watch_(model, ledger_, report_),
      checks_(model) {
  for (const auto& o : model.observers()) observers_.push_back(o.get());
  renews_ = std::any_of(model.systems().begin(), model.systems().end(),
                        [](const auto& s) { return s->renews(); });
}

void Simulation::record(RecordSink& sink) {
  recorder_ = std::make_unique<Recorder>(model_, sink);
  ledgerRows_ = std::make_unique<LedgerRows>(ledger_, sink, model_.simulation.until);
  statistics_.tell(sink);
}

int Simulation::threads(int count) {
  system_.workers(nullptr);
  workers_.reset();
  if (count < 2) return 1;
  workers_ = std::make_unique<Workers>(count);
  system_.workers(workers_.get());
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
  const double wallBefore = report_.wall, cpuBefore = report_.cpu;
  try {
    call();
  } catch (const Stopped&) {
    stopWithin();
  } catch (const std::bad_alloc&) {
    outOfMemory();
  } catch (const ElementFault& e) {
    endBecause("t = " + numberText(x_.t) + " s: " + e.what());
  } catch (const std::exception& e) {  // of observers and files: a full disk, a user's observer
    const std::string law = lawThatThrows(system_);
    endBecause(law.empty() ? e.what() : "t = " + numberText(x_.t) + " s: " + law);
  } catch (...) {
    const std::string law = lawThatThrows(system_);
    endBecause("t = " + numberText(x_.t) +
               " s: " + (law.empty() ? "something was thrown that is no std::exception" : law));
  }
  report_.wall = wallBefore + seconds(Clock::now() - wall);
  report_.cpu = cpuBefore + static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
}

/// Takes one step; begins the run before the first step and ends it after the last one. False: it
/// has ended.
bool Simulation::next() {
  over_ = true;  // an exception ends the run
  if (!begun_) {
    begun_ = true;
    begin();
  }
  const bool good = report_.ended == RunReport::Ended::finished;
  if (good && loop_->next(*this, model_.simulation.until) == Advance::taken) {
    over_ = false;
    return true;
  }
  end();
  return false;
}

void Simulation::begin() {
  lastIdle_ = lastSave_ = Clock::now();
  report_.ended = RunReport::Ended::finished, report_.cause = RunReport::Cause::simulation;
  spare_.resize(kSpare);
  if (!resumed_) start();
  whole_ = true, attempted_ = false;
  if (save_ && !resumed_) save();
  if (const std::string reason = fault(); !reason.empty()) endBecause(reason);
}

void Simulation::start() {
  system_.evaluate(x_);
  report_.start = makeConsistent(model_, system_, x_);
  before_ = x_;
  stepReport_ = {};
  zero_.assign(static_cast<std::size_t>(system_.slot(0).contacts.rows()), 0.0);
  const StepView initial = view(true);
  forAll([&](Observer& o) { o.start(initial); });
}

void Simulation::end() {
  // A run resumed at its end takes no step, which would have evaluated the system.
  const bool resumedHere = resumed_ && stepReport_.dt <= 0.0;
  if (report_.ended == RunReport::Ended::failed || resumedHere) system_.evaluate(x_);
  const bool whole = report_.ended != RunReport::Ended::failed && stepReport_.dt > 0.0;
  const StepView last = view(whole);
  forAll([&](Observer& o) { o.finish(last); });
  report_.t = x_.t;
  report_.energy = ledger_.report();
  report_.hash = motion_.value();
}

StepView Simulation::view(bool whole) {
  const ContactSet& c = system_.slot(0).contacts;
  const auto n = static_cast<Eigen::Index>(c.rows());
  gammaE_.resize(static_cast<std::size_t>(n));
  c.gamma(dynamy::view(std::as_const(x_.u)), {gammaE_.data(), n});
  const bool start = stepReport_.dt <= 0.0 || !whole;
  if (start) zero_.assign(static_cast<std::size_t>(n), 0.0);
  const double* Lambda = start ? zero_.data() : system_.Lambda().data();
  return {model_,
          system_,
          model_.scheme(),
          before_,
          x_,
          ConstVec(Lambda, n),
          ConstVec(gammaE_.data(), n),
          stepReport_,
          report_.steps + 1,
          whole};
}

StepReport Simulation::attempt(double tEnd, double dt) {
  if ((attempted_ || !whole_) && stopped()) throw Stopped{};  // else seen at the step's end
  before_ = x_, attempted_ = true;
  const long evaluations = system_.evaluations();
  const bool last = stopped();  // the run ends after this step, which is to be solved
  system_.stopWhen(last ? nullptr : stop_);
  const bool searches = !model_.scheme().choosesSteps();
  system_.effort(searches ? searches_.next() : Effort::full);
  stepReport_ = model_.scheme().step(system_, model_.solver(), x_, dt);
  if (!last && stopped()) {  // solvers may have stopped early
    x_ = before_;
    throw Stopped{};
  }
  // After a failed search a scheme lowers the effort for the rest of the attempt.
  if (searches) searches_.done(system_.effort() == Effort::full), x_.t = tEnd;
  project();
  system_.remember(x_);
  report_.evaluations += system_.evaluations() - evaluations;
  return stepReport_;
}

void Simulation::project() {
  const Project what = model_.simulation.project;
  if (what == Project::none || !x_.q.allFinite()) return;
  if (!projection_.positions(system_, model_.solver(), x_, system_.gTol()))
    stepReport_.solved.status = SolveStatus::stalled;
  if (what == Project::both && !projection_.velocities(system_, model_.solver(), x_))
    stepReport_.solved.status = SolveStatus::stalled;
}

Passing Simulation::passing() {
  if (model_.scheme().findsContacts()) return {};
  const Passing p = sweep_.look(system_, model_.scheme(), before_, x_);
  report_.swept = sweep_.paths();
  if (p) ++report_.parted;
  return p;
}

void Simulation::leave(const Passing& p) {
  if (++report_.left > 1) return;
  report_.firstLeft.t = before_.t, report_.firstLeft.contact = p.contact;
  report_.firstLeft.name = contactText(model_, p.contact);
}

bool Simulation::accept() {
  if (!sound()) {
    std::string reason = fault();
    report_.refused = !stepReport_.refused.empty();
    x_ = before_;
    stepReport_ = {};
    return endBecause(std::move(reason));
  }
  whole_ = false;
  if (!stepReport_.solved.ok()) noteUnsolved();
  const long evaluations = system_.evaluations();
  const StepView step = view(true);
  forAll([&](Observer& o) { o.step(step); });
  report_.evaluations += system_.evaluations() - evaluations;  // evaluations for dense output
  renew();
  return true;
}

void Simulation::renew() {
  if (!renews_) return;
  const double tA = before_.t;
  const State old = x_;
  if (system_.renew(tA, x_)) ledger_.bring(old, x_);
}

void Simulation::reject() {
  if (!stepReport_.solved.ok() && sound()) {
    noteUnsolved();
    x_ = before_;
    const StepView step = view(true);
    forAll([&](Observer& o) { o.failed(step); });
  }
  x_ = before_;
  ++report_.rejected;
}

bool Simulation::pause(bool asked) {
  whole_ = true, attempted_ = false;
  const auto now = Clock::now();
  if (idle_ && seconds(now - lastIdle_) >= kIdleSeconds) lastIdle_ = now, idle_();
  const bool stop = stopped();
  const double since = seconds(now - lastSave_);
  const bool due =
      save_ && saveEvery_ > 0.0 && since >= saveEvery_ && saveCost_ <= saveShare_ * since;
  const auto full = [this] { return recorder_ && !recorder_->fault().empty(); };
  if (stop || due || asked || full()) keep();
  if (due) save();
  if (stop) report_.ended = RunReport::Ended::stopped;
  // keep() has tried once more to write the collected rows.
  if (!stop && full()) return endBecause(std::string(recorder_->fault()), RunReport::Cause::files);
  return !stop;
}

bool Simulation::endBecause(std::string reason, RunReport::Cause cause) {
  report_.ended = RunReport::Ended::failed, report_.cause = cause;
  report_.reason = std::move(reason);
  return false;
}

}  // namespace dynamy
