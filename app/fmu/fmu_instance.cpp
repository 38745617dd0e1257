#include "fmu/fmu_instance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dynamy::fmu {

FmuInstance::FmuInstance(const std::filesystem::path& resources,
                         const std::filesystem::path& libraries, const std::string& token,
                         Partner partner)
    : resources_(resources),
      contents_(FmuContents::read((resources / "contents.json").string())),
      partner_(partner),
      plugins_({libraries}) {
  if (token != contents_.token)
    throw FmuError("the token \"" + token + "\" is not that of this FMU, \"" + contents_.token +
                   '"');
  registerFramework(registry_);
  plugins_.load(kStandardElements, registry_);
  plugins_.trust(resources_);
  reset();
}

void FmuInstance::reset() {
  mode_ = Mode::instantiated;
  run_.reset(), model_.reset();
  set_ = contents_.set, experiment_ = {};
  input_.clear();
  for (const Variable& v : contents_.variables) input_.push_back(v.start);
  load();  // a faulty FMU has no instance
}

const Variable& FmuInstance::variable(std::uint32_t reference) const {
  if (reference >= contents_.variables.size())
    throw FmuError(fmt::format("there is no variable {}", reference));
  return contents_.variables[reference];
}

void FmuInstance::expect(Mode mode, const char* call) const {
  if (mode_ != mode) throw FmuError(std::string(call) + " is not allowed in this mode");
}

void FmuInstance::load() {
  if (model_) return;
  LoadOptions options;
  options.set = set_, options.parameters = &parameters_;
  for (const Variable& v : contents_.variables)
    if (v.role == Role::output || v.role == Role::status) options.signals.push_back(v.source);
  run_.reset();
  model_ = std::make_unique<Model>(
      loadModel(resources_ / "model" / contents_.model, registry_, plugins_, options));
  until_ = model_->simulation.until;
}

void FmuInstance::connect(std::vector<const NamedSignal*>& signals, std::vector<SetInput>& inputs) {
  place_.assign(contents_.variables.size(), -1);
  for (std::size_t i = 0; i < contents_.variables.size(); ++i) {
    const Variable& v = contents_.variables[i];
    if (v.role == Role::output || v.role == Role::status) {
      place_[i] = static_cast<int>(signals.size());
      signals.push_back(model_->signal(v.source));
    } else if (v.role == Role::input) {
      place_[i] = -1;
      for (const auto& f : model_->forces()) {
        if (f->type() != "Input" || f->name() != v.source) continue;
        inputs.push_back({model_->topology().memories().of(*f), input_[i]});
        place_[i] = inputs.back().at.first;
      }
    }
    const bool missing =
        v.role == Role::input ? place_[i] < 0 : place_[i] >= 0 && signals.back() == nullptr;
    if (missing) throw FmuError("the model has no \"" + v.source + "\" with these parameters");
  }
}

/// The run, which is made when a value of it is first needed.
CoupledRun& FmuInstance::run() {
  if (run_) return *run_;
  load();
  if (experiment_.tolerance > 0.0 && model_->simulation.tolerance > 0.0)
    model_->askTolerance(experiment_.tolerance);
  std::vector<const NamedSignal*> signals;
  std::vector<SetInput> inputs;
  connect(signals, inputs);
  const double until = experiment_.stop > 0.0 ? experiment_.stop : until_;
  run_ = std::make_unique<CoupledRun>(*model_, signals, until, std::move(inputs));
  if (!run_->fault().empty()) throw FmuError(run_->fault());
  if (partner_.eventMode) {
    std::erase_if(signals, [](const NamedSignal* s) { return !isStatus(*s); });
    run_->watch(signals);
  }
  before_ = fresh_ = false;
  outputs();
  held_ = values_;
  return *run_;
}

void FmuInstance::outputs() {
  if (fresh_) return;
  const auto now = run_->values(before_);
  values_.assign(now.begin(), now.end());
  fresh_ = true;
}

void FmuInstance::enterInitialization(double start, const Experiment& experiment) {
  expect(Mode::instantiated, "fmi3EnterInitializationMode");
  if (start != 0.0) throw FmuError(fmt::format("the model starts at 0 s, not at {} s", start));
  experiment_ = experiment;
  run_.reset();
  mode_ = Mode::initialization;
}

void FmuInstance::exitInitialization() {
  expect(Mode::initialization, "fmi3ExitInitializationMode");
  run();
  mode_ = partner_.eventMode ? Mode::event : Mode::step;
}

void FmuInstance::enter(Mode mode) {
  if (mode == Mode::event && !partner_.eventMode)
    throw FmuError("the instance was made without event mode");
  if (mode != Mode::terminated && mode_ != Mode::event && mode_ != Mode::step)
    throw FmuError("initialization has not ended, or the run has");
  mode_ = mode;
}

double FmuInstance::updateDiscrete() {
  expect(Mode::event, "fmi3UpdateDiscreteStates");
  run_->sample();
  before_ = fresh_ = false;
  outputs();
  held_ = values_;
  return run_->nextSample();
}

StepEnd FmuInstance::step(double t, double h, const CoupledRun::OnTheWay& onTheWay) {
  expect(Mode::step, "fmi3DoStep");
  if (!(h > 0.0) || !std::isfinite(h)) throw FmuError("the step is not above zero");
  // Other programs compute t as they like: i h, or a sum.
  if (!(std::abs(t - run_->t()) <= 1e-9 * h + 1e-12 * std::abs(t)))
    throw FmuError(fmt::format("the step begins at {} s, the FMU is at {} s", t, run_->t()));
  StepEnd out;
  const double end = t + h;
  target_ = end;
  for (bool there = false; !there;) {
    const double target = target_;
    const auto reached =
        run_->advance(target, partner_.eventMode && partner_.earlyReturn, [&](double now) {
          fresh_ = before_ = false;
          return onTheWay && onTheWay(now);
        });
    fresh_ = false;
    out.event = out.event || reached.event;
    if (!reached.good) throw FmuError(run_->fault());
    there = target_ == target || reached.event || run_->t() >= target_;
  }
  out.t = run_->t();
  out.early = out.t < end;
  out.event = out.event && partner_.eventMode;
  before_ = out.event;
  return out;
}

double FmuInstance::output(std::uint32_t reference, Role role,
                           const std::vector<double>& from) const {
  if (variable(reference).role != role)
    throw FmuError("\"" + variable(reference).name + "\" has another type");
  return from[static_cast<std::size_t>(place_[reference])];
}

double FmuInstance::number(std::uint32_t reference) {
  const Variable& v = variable(reference);
  if (v.role == Role::time) return run_ ? run_->t() : 0.0;
  if (v.role == Role::input) return input_[reference];
  if (v.role == Role::parameter) {
    load();
    return parameters_.at(v.source);
  }
  run();
  outputs();
  return output(reference, Role::output, values_);
}

std::int64_t FmuInstance::status(std::uint32_t reference) {
  run();
  outputs();
  // In event mode discrete outputs change at events alone.
  return std::lround(output(reference, Role::status, partner_.eventMode ? held_ : values_));
}

void FmuInstance::set(std::uint32_t reference, double value) {
  const Variable& v = variable(reference);
  if (!std::isfinite(value)) throw FmuError("the value of \"" + v.name + "\" is not finite");
  const bool early = mode_ == Mode::instantiated || mode_ == Mode::initialization;
  if (v.role == Role::input) {
    input_[reference] = value;
    if (early)
      run_.reset();  // blocks sample at the start
    else
      run().input({{place_[reference]}, value});
    fresh_ = false;
    return;
  }
  if (v.role != Role::parameter || !early) throw FmuError("\"" + v.name + "\" cannot be set now");
  // A parameter that is set to its start value keeps its formula of other parameters.
  const auto old = std::find_if(set_.begin(), set_.end(),
                                [&](const auto& one) { return one.first == v.source; });
  const std::string text = fmt::format("{}", value);
  if (old == set_.end() ? value == v.start : old->second == text) return;
  if (old != set_.end())
    old->second = text;
  else
    set_.emplace_back(v.source, text);
  run_.reset(), model_.reset();
}

std::string FmuInstance::state() {
  Archive a;
  std::string token = contents_.token;
  a(token), a(mode_);
  std::uint64_t n = set_.size();
  a(n);
  for (auto& [name, value] : set_) a(name), a(value);
  a(experiment_.tolerance), a(experiment_.stop), a(input_), a(held_), a(before_);
  bool runs = run_ != nullptr;
  a(runs);
  if (runs) run_->archive(a);
  return a.bytes();
}

void FmuInstance::state(const std::string& bytes) {
  Archive a(bytes);
  std::string token;
  a(token);
  if (token != contents_.token) throw FmuError("the state is of another FMU");
  Overrides set;
  Experiment experiment;
  std::vector<double> input, held;
  bool before = false, runs = false;
  auto mode = mode_;
  a(mode);
  std::uint64_t n = 0;
  a(n);
  for (std::uint64_t i = 0; i < n; ++i) {
    set.emplace_back();
    a(set.back().first), a(set.back().second);
  }
  a(experiment.tolerance), a(experiment.stop), a(input), a(held), a(before), a(runs);
  if (mode > Mode::terminated || input.size() != contents_.variables.size())
    throw FmuError("the state is of another FMU");
  mode_ = mode, input_ = std::move(input);
  // Parameters and accuracy belong to the model.
  if (set != set_ || experiment.tolerance != experiment_.tolerance || !runs)
    run_.reset(), model_.reset();
  set_ = std::move(set), experiment_ = experiment;
  if (!runs) return;
  run().archive(a);
  if (!run_->fault().empty()) throw FmuError(run_->fault());
  if (held.size() != values_.size()) throw FmuError("the state is of another FMU");
  before_ = before, held_ = std::move(held), fresh_ = false;
}

}  // namespace dynamy::fmu
