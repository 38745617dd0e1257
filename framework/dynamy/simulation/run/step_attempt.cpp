#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/checkpoints.hpp>
#include <dynamy/simulation/run/run_faults.hpp>
#include <dynamy/simulation/run/step_attempt.hpp>
#include <limits>
#include <utility>

namespace dynamy {
namespace {

constexpr double kPart = 0.75;  ///< shorter steps are parts, over the length of a step

/// Refusal of a step after which t is not at its end; StepAttempt::fault() says more.
constexpr std::string_view kOffClock = "it leaves t within the step, or beyond it";
constexpr double kSameTime = 1e-6;  ///< part of a step that counts as the rounding of t

/// True: the scheme, which takes given steps, has moved the time by another length than `dt`.
bool isOffClock(const State& before, const State& x, double dt) {
  const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * std::abs(x.t);
  return !(std::abs(x.t - before.t - dt) <= kSameTime * dt + rounding);
}

bool isSet(const std::atomic<bool>* flag) {
  return flag != nullptr && flag->load(std::memory_order_relaxed);
}

}  // namespace

StepAttempt::StepAttempt(Model& model, MechanicalSystem& system, Sleep* sleep, const State* from)
    : model_(model),
      system_(system),
      sleep_(sleep),
      x_(from != nullptr ? *from : model.initialState()),
      before_(x_),
      coarseness_(model),
      kept_(model),
      renews_(std::any_of(model.systems().begin(), model.systems().end(),
                          [](const auto& s) { return s->abilities().renewable != nullptr; })) {}

StartReport StepAttempt::start() {
  system_.evaluate(x_);
  StartReport report = makeConsistent(model_, system_, x_);
  system_.remember(x_);  // blocks sample at the start, too
  before_ = x_;
  report_ = {};
  return report;
}

bool StepAttempt::take(double tEnd, double dt, const std::atomic<bool>* stop, StepTry how) {
  attempted_ = true;
  if (sleep_ != nullptr && sleep_->allAsleep() && x_.memory.size() == 0) {
    // No number but t changes. Observers see a system without contacts, which is evaluated once.
    if (!report_.resting) before_ = x_, system_.evaluate(x_), system_.impactProblem(x_, dt);
    before_.t = x_.t, x_.t = tEnd;
    report_ = {};
    report_.dt = dt, report_.resting = true;
    return true;
  }
  before_ = x_;
  const bool last = isSet(stop);  // the run ends after this step, which is to be solved
  const bool searches = !model_.scheme().choosesSteps();
  system_.limits.stop = last ? nullptr : stop;
  const bool cheaply = how == StepTry::cheap;
  const Effort effort = cheaply ? Effort::little : searches ? searches_.next() : Effort::full;
  system_.limits.pushOut = searches ? model_.simulation.step : 0.0;
  // Parts of a step are not equal.
  system_.limits.keeping = !(searches && model_.schemeIsDefault()) ? Keeping::none
                           : dt < kPart * model_.simulation.step   ? Keeping::all
                                                                   : Keeping::besideDamped;
  system_.limits.halving = how != StepTry::whole ? Halving::none
                           : searches            ? Halving::ends
                                                 : Halving::within;
  system_.limits.effort = effort;
  report_ = model_.scheme().step(system_, model_.solver(), x_, dt);
  while (sleep_ != nullptr && sleep_->wakes(system_, before_)) {
    x_ = before_, system_.limits.effort = effort;
    report_ = model_.scheme().step(system_, model_.solver(), x_, dt);
  }
  if (!last && isSet(stop)) {  // solvers may have stopped early
    x_ = before_;
    return false;
  }
  // After a failed search a scheme lowers the effort for the rest of the attempt.
  if (searches && !cheaply) searches_.done(system_.limits.effort == Effort::full);
  if (searches) {
    const bool part = report_.dt > 0.0 && std::lround(dt / report_.dt) > 1;
    if (!report_.resting && report_.refused.empty() && report_.solved.ok() &&
        isOffClock(before_, x_, part ? report_.dt : dt)) {
      report_.refused = kOffClock;
      return true;
    }
    x_.t = part ? before_.t + report_.dt : tEnd;
  }
  if (searches && model_.schemeIsDefault()) kept_.keep(system_, report_, before_, x_);
  project();
  system_.remember(x_);
  return true;
}

void StepAttempt::project() {
  const Project what = model_.simulation.project;
  if (what == Project::none || !x_.q.allFinite()) return;
  if (!projection_.positions(system_, model_.solver(), x_, system_.gTol()))
    report_.solved.status = SolveStatus::stalled;
  if (what == Project::both && !projection_.velocities(system_, model_.solver(), x_))
    report_.solved.status = SolveStatus::stalled;
}

bool StepAttempt::sound() const { return report_.resting || isSound(system_, x_, report_); }

std::string StepAttempt::fault() const {
  if (report_.refused == kOffClock)
    return "t = " + numberText(before_.t) + " s: <" + model_.scheme().type() +
           "> moved the time by " + numberText(x_.t - before_.t) + " s in a step of " +
           numberText(report_.dt) +
           " s: each move() advances t, and those of a step sum to its length";
  std::string text = faultOf(model_, system_, x_, report_);
  if (!text.ends_with("is not finite") || !before_.q.allFinite() || !before_.u.allFinite())
    return text;
  // A formula of time that ends within the step is the cause, and not the body it acts on.
  for (const double part : {0.0, 0.5, 1.0}) {
    const double t = before_.t + part * (x_.t - before_.t);
    const ExternalForce* force = forceWithoutNumber(model_, before_, t);
    if (force == nullptr) continue;
    return text + ": the force of " + elementText(*force) +
           " has no finite value at t = " + numberText(t) + " s";
  }
  return text;
}

StepView StepAttempt::view(long index, bool whole) {
  const ContactSet& c = system_.slot(0).contacts;
  const auto n = static_cast<Eigen::Index>(c.rows());
  gammaE_.resize(static_cast<std::size_t>(n));
  c.gamma(dynamy::view(std::as_const(x_.u)), {gammaE_.data(), n});
  const bool start = report_.dt <= 0.0 || !whole;
  if (start) zero_.assign(static_cast<std::size_t>(n), 0.0);
  const double* Lambda = start ? zero_.data() : system_.problem().Lambda().data();
  return {model_,
          system_,
          model_.scheme(),
          before_,
          x_,
          ConstVec(Lambda, n),
          ConstVec(gammaE_.data(), n),
          report_,
          index,
          whole};
}

bool StepAttempt::renew(State& old) {
  if (!renews_) return false;
  old = x_;
  return renewSystems(model_.topology(), before_.t, x_);
}

void StepAttempt::archive(Archive& a) {
  archiveState(a, x_);
  searches_.archive(a);
  if (sleep_ != nullptr) sleep_->archive(a);
}

}  // namespace dynamy
