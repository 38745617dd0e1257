#include "live/driven_run.hpp"

#include <algorithm>
#include <cmath>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/run_files/model_scene.hpp>
#include <dynamy/simulation/report/energy_ledger.hpp>
#include <dynamy/simulation/report/recorder.hpp>

#include "build_text.hpp"

namespace dynamy::app {
namespace {

/// A body that hangs on the hand stretches the spring by this part of the scene's length, if its
/// weight is m · 9.81 m/s²: ω² = g/(part · length).
constexpr double kSag = 0.1, kWeight = 9.81;
constexpr double kDampingRatio = 0.7;
/// Largest ω Δt, with which steps of given length resolve the spring and the damper.
constexpr double kMostPhase = 0.25;

std::string sceneText(const Model& model) {
  std::string out;
  JsonWriter json(out);
  write(json, modelScene(model));
  return out;
}

/// The choice with a longest step where the scheme chooses its steps: an input acts between two
/// steps only, and a picture is to show it.
RunChoice withShortSteps(Program& program, RunChoice choice) {
  Model model = chosenModel(program, choice, nullptr, false);
  model.readyScheme();
  const SimulationSettings& s = model.simulation;
  if (!model.scheme().choosesSteps() || s.step > 0.0) return choice;
  const double pictures = model.record.framesPerSecond;
  choice.step = std::min(pictures > 0.0 ? 1.0 / pictures : 0.02, 0.02);
  if (choice.tolerance <= 0.0) choice.tolerance = s.tolerance;
  return choice;
}

bool sameFiles(const std::vector<Fingerprint>& a, const std::vector<Fingerprint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.name == y.name && x.fingerprint == y.fingerprint;
  });
}

/// Why a run of `a` cannot go on with the model `b`; empty: it can.
std::string difference(Model& a, Model& b) {
  const Topology &x = a.topology(), &y = b.topology();
  if (x.nq() != y.nq() || x.nu() != y.nu() || a.systems().size() != b.systems().size() ||
      a.contacts().size() != b.contacts().size() || a.forces().size() != b.forces().size() ||
      x.memories().start().size() != y.memories().start().size())
    return "it changes the number of bodies, elements or coordinates";
  if (sceneText(a) != sceneText(b)) return "it changes the shapes of the picture";
  a.readyScheme(), b.readyScheme();
  if (a.scheme().type() != b.scheme().type() || a.simulation.step != b.simulation.step ||
      a.simulation.tolerance != b.simulation.tolerance)
    return "it changes the scheme, its step or its tolerance";
  return {};
}

}  // namespace

DrivenRun::DrivenRun(Program& program, RunChoice choice, const std::filesystem::path& folder)
    : program_(program),
      first_(withShortSteps(program, std::move(choice))),
      choice_(first_),
      model_(std::make_unique<Model>(chosenModel(program, choice_, nullptr, false))),
      folder_(folder),
      recording_(std::make_unique<RunRecording>(folder_, *model_)),
      simulation_(std::make_unique<Simulation>(*model_)),
      inputs_(folder_.path() / kInputsName) {
  first_ = choice_;  // with the end time and the sample time
  writeWholeFile(folder_.model(), model_->file.text);
}

void DrivenRun::start(const RunShow& show) {
  simulation_->record(*recording_);
  threads_ = show.threads;
  simulation_->threads(threads_);
  simulation_->start();
  writeFirstFacts(folder_, *model_, first_, shown(show), simulation_->report());
  recording_->flush();
}

bool DrivenRun::step() {
  if (!simulation_->step()) return false;
  ++steps_;
  return true;
}

/// The members of run.json by which a run can be repeated.
RunShow DrivenRun::shown(const RunShow& show) const {
  RunShow out = show;
  out.pack = false;  // the page reads signals.csv to the end
  out.facts = [this](JsonWriter& j) {
    j.key("live").beginObject().member("inputs", kInputsName);
    j.member("actions", inputs_.actions()).member("program", buildText());
    j.member("model", first_.model).member("until", first_.until).member("step", first_.step);
    j.member("every", first_.every).member("tolerance", first_.tolerance);
    j.member("integrator", first_.integrator).member("solver", first_.solver);
    j.key("libraries").beginArray();
    for (const std::string& library : first_.libraries) j.value(library);
    j.endArray().key("set").beginObject();
    for (const auto& [name, value] : first_.set) j.member(name, value);
    j.endObject().endObject();
  };
  return out;
}

int DrivenRun::conclude(const RunShow& show, int signal) {
  recording_->flush();
  const std::vector<CheckResult> checks = simulation_->checks();
  RunEnd end;
  end.status =
      signal != 0 ? kSignalled + signal : exitStatus(simulation_->report(), checks, show.accept);
  return app::conclude(folder_, *model_, first_, shown(show), simulation_->report(), *recording_,
                       checks, std::move(end));
}

std::string DrivenRun::apply(Action action) {
  std::string refused;
  switch (action.what) {
    case Action::What::set:
      refused = change(action.name, action.values.at(0));
      break;
    case Action::What::input:
      refused = setInput(action.name, action.values.at(0));
      break;
    case Action::What::grab: {
      const std::vector<double>& x = action.values;
      const Hand& hand = *handOf(*model_);
      if (!(x.at(0) >= 0.0 && x[0] < static_cast<double>(hand.frames().size())))
        return "there is no frame " + std::to_string(x[0]) + " that the hand could hold";
      hold({static_cast<int>(x[0]), {x[1], x[2], x[3]}, {x[4], x[5], x[6]}, x[7], x.at(8)});
      break;
    }
    case Action::What::move:
      if (grip_.frame < 0) return "nothing is held";
      grip_.target = {action.values.at(0), action.values.at(1), action.values.at(2)};
      hold(grip_);
      break;
    case Action::What::release:
      hold({});
      break;
    case Action::What::end:
      model_->simulation.until = t();
      break;
  }
  if (!refused.empty()) return refused;
  action.step = steps_, action.t = t();
  inputs_.add(action);
  return {};
}

void DrivenRun::hold(const Grip& grip) {
  grip_ = grip;
  const MemoryHandle m = handOf(*model_)->memory();
  const std::array<double, Hand::kNumbers> numbers = Hand::numbers(grip);
  for (int i = 0; i < Hand::kNumbers; ++i)
    simulation_->input({m.first + i, 1}, numbers[static_cast<std::size_t>(i)]);
}

std::optional<Action> DrivenRun::grab(int drawn, const Vec3& point, const Vec3& target,
                                      double strength) {
  const std::vector<DrawnFrame> frames = drawnFrames(*model_);
  if (drawn < 0 || drawn >= static_cast<int>(frames.size())) return {};
  const DrawnFrame& f = frames[static_cast<std::size_t>(drawn)];
  const Hand& hand = *handOf(*model_);
  const auto found =
      std::find(hand.frames().begin(), hand.frames().end(), std::pair(f.system, f.id));
  if (found == hand.frames().end()) return {};
  Grip grip;
  grip.frame = static_cast<int>(found - hand.frames().begin());
  grip.point = point, grip.target = target;
  const double mass = hand.massAt(*model_, simulation_->state(), grip);
  if (!(mass > 0.0)) return {};
  double omega = std::sqrt(strength * kWeight / (kSag * model_->length()));
  if (const double dt = model_->simulation.step; dt > 0.0 && !model_->scheme().choosesSteps())
    omega = std::min(omega, kMostPhase / dt);
  const Scene scene = modelScene(*model_);
  Action a;
  a.what = Action::What::grab;
  a.name = scene.frames[static_cast<std::size_t>(drawn)].name;
  a.values = {static_cast<double>(grip.frame),
              point[0],
              point[1],
              point[2],
              target[0],
              target[1],
              target[2]};
  a.values.push_back(mass * omega * omega);
  a.values.push_back(2.0 * kDampingRatio * mass * omega);
  return a;
}

std::string DrivenRun::setInput(const std::string& name, double value) {
  for (const auto& f : model_->forces()) {
    if (f->type() != "Input" || f->name() != name) continue;
    simulation_->input(model_->topology().memories().of(*f), value);
    return {};
  }
  return "no input is named \"" + name + '"';
}

/// Goes on with another value of a parameter. The present model and run stay if it cannot be done.
std::string DrivenRun::change(const std::string& parameter, double value) {
  RunChoice choice = choice_;
  std::erase_if(choice.set, [&](const auto& s) { return s.first == parameter; });
  std::string text;
  appendNumber(text, value);
  choice.set.emplace_back(parameter, text);
  try {
    auto model = std::make_unique<Model>(chosenModel(program_, choice, nullptr, false));
    model->simulation.until = model_->simulation.until;
    if (!sameFiles(choice.sources, choice_.sources))
      return "a file of the model has changed since the run began";
    if (std::string why = difference(*model_, *model); !why.empty())
      return why + ": only a new run can take this value (--set " + parameter + '=' + text + ')';
    EnergyMeter meter(*model_);
    const State& x = simulation_->state();
    const double energy = meter.kinetic(x) + meter.potential(x);
    const std::string present = simulation_->archived();
    auto recording = std::make_unique<RunRecording>(folder_, *model, RunRecording::Resume{});
    auto simulation = std::make_unique<Simulation>(*model);
    simulation->record(*recording);
    simulation->threads(threads_);
    simulation->resume(present, energy);
    simulation_ = std::move(simulation), recording_ = std::move(recording);
    model_ = std::move(model), choice_ = std::move(choice);
  } catch (const std::exception& e) {  // also of an element at its first evaluation, or of files
    return e.what();
  }
  return {};
}

std::map<std::string, double> DrivenRun::parameters() const {
  std::map<std::string, double> out;
  LoadOptions options;
  options.set = choice_.set, options.build = false, options.parameters = &out;
  loadModel(choice_.model, program_.registry, program_.plugins, options);
  return out;
}

std::map<std::string, double> DrivenRun::inputs() const {
  std::map<std::string, double> out;
  for (const auto& f : model_->forces())
    if (f->type() == "Input")
      out[f->name()] = simulation_->state().memory[model_->topology().memories().of(*f).first];
  return out;
}

}  // namespace dynamy::app
