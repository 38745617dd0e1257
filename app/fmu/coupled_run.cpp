#include "fmu/coupled_run.hpp"

#include <algorithm>
#include <limits>

namespace dynamy::fmu {
namespace {

/// A step that ends so near to an instant, over its length, ends there (as FixedStep has it).
constexpr double kNear = 1e-9;
/// The recorder writes rows at its own instants, of which nobody has any use here.
constexpr double kNever = 1e300;

bool hasInputs(const Model& model) {
  return std::any_of(model.forces().begin(), model.forces().end(),
                     [](const auto& f) { return f->type() == "Input"; });
}

void archiveInputs(Archive& a, std::vector<SetInput>& inputs) {
  std::uint64_t n = inputs.size();
  a(n);
  if (a.reading()) inputs.assign(std::min<std::uint64_t>(n, 1u << 20), {});
  for (SetInput& i : inputs) a(i.at.first), a(i.value);
}

}  // namespace

CoupledRun::CoupledRun(Model& model, const std::vector<const NamedSignal*>& signals, double until,
                       std::vector<SetInput> inputs)
    : model_(model),
      sampler_(model, signals),
      samples_(model),
      startInputs_(std::move(inputs)),
      values_(signals.size()) {
  model_.checks.clear();
  model_.record.every = kNever, model_.record.framesPerSecond = 0.0;
  if (!signals.empty()) model_.record.signals = {signals.front()->name};
  model_.simulation.until = until;
  begin({});
  ahead_ = model_.scheme().choosesSteps() && !hasInputs(model);
}

void CoupledRun::begin(const std::string& checkpoint) {
  // The old run ends after the new one was made, so that its parts have other addresses: schemes
  // know the system of their last step by its address.
  auto watch = std::make_unique<StepWatch>();
  auto simulation = std::make_unique<Simulation>(model_);
  simulation_ = std::move(simulation), watch_ = std::move(watch);
  simulation_->record(*watch_);
  simulation_->observe(*watch_);
  if (checkpoint.empty())
    for (const SetInput& i : startInputs_) simulation_->input(i.at, i.value);
  else
    simulation_->resume(checkpoint);
  simulation_->start();
  watch_->events();
  checkpoint_ = checkpoint, t_ = simulation_->state().t, event_ = false;
}

bool CoupledRun::isReached(double target, double t) const {
  return isPassed(target, t) || target - t <= kNear * model_.simulation.step;
}

void CoupledRun::input(const SetInput& set) {
  simulation_->input(set.at, set.value);
  inputs_.push_back(set), stale_ = true;
}

void CoupledRun::sample() {
  if (!std::exchange(stale_, false)) return;
  simulation_->sampleAgain();
  inputs_.push_back({{kSampled}, 0.0});
}

void CoupledRun::watch(const std::vector<const NamedSignal*>& statuses) {
  if (statuses.empty()) return;
  statuses_ = std::make_unique<SignalSampler>(model_, statuses);
  statusesNow_.resize(statuses.size());
  statusesChange();
}

/// Takes the statuses at the end of the last step.
bool CoupledRun::statusesChange() {
  if (!statuses_) return false;
  statusesBefore_ = statusesNow_;
  statuses_->sample(*watch_->view(), 1.0, statusesNow_);
  const auto isOpen = [](double s) { return s <= static_cast<double>(Status::separating); };
  for (std::size_t i = 0; i < statusesNow_.size(); ++i)
    if (statusesNow_[i] != statusesBefore_[i] &&
        !(isOpen(statusesNow_[i]) && isOpen(statusesBefore_[i])))
      return true;
  return false;
}

bool CoupledRun::take() {
  sample();
  checkpoint_ = simulation_->archived();  // with the inputs
  inputs_.clear();
  const bool taken = simulation_->step();
  event_ = watch_->events() > 0;
  if (taken && statusesChange()) event_ = true;
  return taken;
}

CoupledRun::Reached CoupledRun::advance(double target, bool stops, const OnTheWay& onTheWay) {
  Reached out;
  const double begin = t_;
  for (;;) {
    const double end = simulation_->state().t;
    const double near = watch_->view() != nullptr ? kNear * watch_->view()->report.dt : 0.0;
    if (target < end - near && ahead_) {  // within the last step
      t_ = target;
      return out;
    }
    const bool there = isReached(target, end) || target < end + near;
    t_ = there ? target : end;
    if (std::exchange(event_, false)) {
      out.event = true;
      if (stops) return out;
    }
    if (there || (onTheWay && end > begin && onTheWay(t_))) return out;
    double& until = model_.simulation.until;
    until = ahead_ ? std::max(until, target) : target;
    if (!take()) {
      out.good = false;
      return out;
    }
  }
}

std::span<const double> CoupledRun::values(bool before) {
  const StepView& view = *watch_->view();
  const double dt = view.report.dt, end = view.after.t;
  if (dt > 0.0 && t_ < end - kNear * dt)
    sampler_.sample(view, std::clamp((t_ - view.before.t) / dt, 0.0, 1.0), values_);
  else if (before && dt > 0.0)
    sampler_.sampleBeforeImpact(view, values_);
  else
    sampler_.sample(view, 1.0, values_);
  return values_;
}

void CoupledRun::archive(Archive& a) {
  a.section("coupled run");
  std::string checkpoint = checkpoint_;
  std::vector<SetInput> inputs = inputs_;
  double t = t_, until = model_.simulation.until;
  bool event = event_;
  std::vector<SetInput> startInputs = startInputs_;
  archiveInputs(a, startInputs);
  archiveInputs(a, inputs);
  a(checkpoint), a(t), a(until), a(event);
  std::vector<double> statuses = statusesNow_;
  a(statuses);
  if (!a.reading()) return;
  const auto known = [&](const SetInput& i) {
    return i.at.first >= kSampled &&
           i.at.first < static_cast<int>(model_.topology().memories().start().size());
  };
  if (statuses.size() != statusesNow_.size() ||
      !std::all_of(startInputs.begin(), startInputs.end(), known) ||
      !std::all_of(inputs.begin(), inputs.end(), known))
    throw ModelError("the state is of another FMU");
  model_.simulation.until = until;
  startInputs_ = std::move(startInputs), inputs_.clear(), stale_ = false;
  begin(checkpoint);
  if (!checkpoint.empty()) take();
  for (const SetInput& i : inputs) {
    if (i.at.first == kSampled)
      sample();
    else
      input(i);
  }
  t_ = t, event_ = event, statusesNow_ = std::move(statuses);
}

}  // namespace dynamy::fmu
