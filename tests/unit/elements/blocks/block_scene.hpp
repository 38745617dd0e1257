/// A cart with blocks, for their tests: read, run, and its signals at the end.
#pragma once
#include <gtest/gtest.h>
#include <build_paths.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/simulation/run/simulation.hpp>

#include <memory>
#include <string>

namespace dynamy {

/// A model with the standard elements.
class BlockScene {
 public:
  explicit BlockScene(const std::string& text) : plugins_({DYNAMY_BINARY_DIR "/lib/dynamy"}) {
    registerFramework(registry_);
    plugins_.load(kStandardElements, {}, registry_);
    model_ = std::make_unique<Model>(loadModelText(text, "scene.xml", registry_, plugins_, {}));
  }
  Model& model() { return *model_; }
  /// The state at the end of a run.
  State run() {
    Simulation simulation(*model_);
    EXPECT_EQ(simulation.run().ended, RunReport::Ended::finished) << simulation.report().reason;
    return simulation.state();
  }
  /// Value of a signal at x.
  double signal(const State& x, const std::string& name) {
    const NamedSignal* s = model_->signal(name);
    if (s == nullptr) throw std::runtime_error("no signal " + name);
    Kinematics k;
    k.evaluate(model_->topology(), x.t, view(x.q), view(x.u), view(x.memory));
    ReadSignals table;
    table.bind({{0, s->signal.value, s->system, {s->memory0, s->memory}}});
    return table.value({0}, k);
  }

 private:
  Registry registry_;
  PluginLoader plugins_;
  std::unique_ptr<Model> model_;
};

/// A cart of 2 kg at x = 0.3 m with 1 m/s.
inline std::string cart(const std::string& forces, const std::string& simulation,
                        const std::string& elements = "") {
  return R"(<dynamy version="1"><parameter name="k" value="8"/><systems>
    <PointMass name="cart" position="0.3 0 0" velocity="1 0 0" mass="2"/></systems><forces>)" +
         forces + "</forces><elements>" + elements + "</elements><simulation until=\"1\" " +
         simulation + "</simulation></dynamy>";
}

inline std::string errorOf(const std::string& text) {
  try {
    const BlockScene scene(text);
  } catch (const ModelError& e) {
    return e.what();
  }
  return {};
}

}  // namespace dynamy
