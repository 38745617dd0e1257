/// Scene: a file of models/ (or a text) with parameters replaced, stepped by hand, so that a test
/// sees every state and every percussion. The time loop of the program is not used: what is tested
/// here are the equations of a step.
#pragma once
#include <build_paths.hpp>
#include <cmath>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/schemes/half_explicit_euler.hpp>
#include <dynamy/schemes/moreau_midpoint.hpp>
#include <memory>
#include <string>

namespace dynamy::reference {

enum class Scheme { asTheModelSays, moreauMidpoint, halfExplicitEuler };
constexpr Scheme kBothSchemes[] = {Scheme::moreauMidpoint, Scheme::halfExplicitEuler};

struct SceneSetup {
  Overrides set = {};
  Scheme scheme = Scheme::asTheModelSays;
  Delassus::Form form = Delassus::Form::automatic;
  std::unique_ptr<InclusionSolver> solver = nullptr;  ///< null: the model's
  std::string text = {};                              ///< the model itself instead of a file
};

class Scene {
 public:
  /// `file`: name in models/ without ".xml"; of no meaning if the setup brings a text.
  explicit Scene(const std::string& file, SceneSetup setup = {})
      : plugins_({DYNAMY_BINARY_DIR "/lib/dynamy"}), model_(load(file, setup)) {
    if (setup.scheme == Scheme::moreauMidpoint) model_.scheme(std::make_unique<MoreauMidpoint>());
    if (setup.scheme == Scheme::halfExplicitEuler)
      model_.scheme(std::make_unique<HalfExplicitEuler>());
    if (setup.solver) model_.solver(std::move(setup.solver));
    system_ = std::make_unique<MechanicalSystem>(model_.mechanicalSystem());
    system_->limits.form = setup.form;
    x_ = model_.initialState();
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// One step of the scheme; of one that chooses its steps as many as dt takes.
  const StepReport& step(double dt) {
    const double end = x_.t + dt, last = 1e-14 * (std::abs(end) + dt);
    do {
      oneStep(end - x_.t);
    } while (model_.scheme().choosesSteps() && end - x_.t > last && report_.refused.empty());
    return report_;
  }
  /// One step, no longer than dt.
  const StepReport& oneStep(double dt) {
    report_ = model_.scheme().step(*system_, model_.solver(), x_, dt);
    solved_ = solved_ && report_.solved.ok();
    return report_;
  }
  /// Steps to time `t` from now with steps as close to dt as a whole number of them allows;
  /// `each()` is called after every step.
  template <class Each>
  void run(double t, double dt, Each&& each) {
    const double from = x_.t, length = t - from;
    const auto n = static_cast<long>(std::lround(length / dt));
    for (long i = 0; i < n; ++i) {
      step(length / static_cast<double>(n));
      each();
    }
    x_.t = t;
  }
  void run(double t, double dt) {
    run(t, dt, [] {});
  }

  Eigen::VectorXd q(const std::string& system) const {
    const SystemHandle h = handle(system);
    return x_.q.segment(h.q0, h.nq);
  }
  Eigen::VectorXd u(const std::string& system) const {
    const SystemHandle h = handle(system);
    return x_.u.segment(h.u0, h.nu);
  }
  State& state() { return x_; }
  const State& state() const { return x_; }
  Model& model() { return model_; }
  MechanicalSystem& system() { return *system_; }
  ConstVec Lambda() const { return std::as_const(*system_).problem().Lambda(); }
  const StepReport& report() const { return report_; }
  /// All inclusions so far were solved to their tolerance.
  bool solved() const { return solved_; }
  /// T + V [J] at the present state.
  double energy() { return kineticEnergy() + system_->potentialEnergy(x_); }
  /// T [J] at the present state.
  double kineticEnergy() {
    return system_->evaluate(x_).mass.kineticEnergy({x_.u.data(), x_.u.size()});
  }

 private:
  Model load(const std::string& file, const SceneSetup& setup) {
    registerFramework(registry_);
    plugins_.load(kStandardElements, {}, registry_);
    LoadOptions options;
    options.set = setup.set;
    if (!setup.text.empty())
      return loadModelText(setup.text, file + ".xml", registry_, plugins_, options);
    return loadModel(DYNAMY_SOURCE_DIR "/models/" + file + ".xml", registry_, plugins_, options);
  }
  SystemHandle handle(const std::string& name) const {
    const auto& systems = model_.systems();
    for (std::size_t i = 0; i < systems.size(); ++i)
      if (systems[i]->name() == name) return model_.topology().system(static_cast<int>(i));
    throw std::runtime_error("no system " + name);
  }

  Registry registry_;
  PluginLoader plugins_;
  Model model_;
  std::unique_ptr<MechanicalSystem> system_;
  State x_;
  StepReport report_;
  bool solved_ = true;
};

}  // namespace dynamy::reference
