/// Loads models with the standard elements and plug-ins of the build tree, as the program does.
#pragma once
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <filesystem>
#include <memory>

namespace dynamy {

/// A model with everything it needs to live.
class LoadedModel {
 public:
  /// `file`: in the source tree, e.g. "models/woodpecker.xml". `reduce`: as LoadOptions.
  explicit LoadedModel(const std::string& file, const Overrides& set = {}, bool reduce = false)
      : plugins_({std::filesystem::path(DYNAMY_BINARY_DIR) / "lib" / "dynamy"}) {
    registerFramework(registry_);
    plugins_.load(kStandardElements, registry_);
    model_ =
        std::make_unique<Model>(loadModel(std::filesystem::path(DYNAMY_SOURCE_DIR) / file,
                                          registry_, plugins_, {.set = set, .reduce = reduce}));
  }
  Model& model() { return *model_; }
  const Registry& registry() const { return registry_; }

 private:
  Registry registry_;
  PluginLoader plugins_;
  std::unique_ptr<Model> model_;
};

/// A model that is stepped by hand.
class HandStepper {
 public:
  explicit HandStepper(Model& model)
      : x(model.initialState()), model_(&model), system_(model.mechanicalSystem()) {}
  StepReport step(double dt) { return model_->scheme().step(system_, model_->solver(), x, dt); }
  /// Percussions of the last step.
  ConstVec Lambda() const { return system_.problem().Lambda(); }
  const MechanicalSystem& system() const { return system_; }
  State x;

 private:
  Model* model_;
  MechanicalSystem system_;
};

/// Every <check> of the model holds after the run.
inline void expectChecksHold(const Simulation& simulation) {
  const auto results = simulation.checks();
  EXPECT_FALSE(results.empty());
  for (const CheckResult& r : results)
    EXPECT_TRUE(r.pass) << r.place.format() << ": " << r.measure << " of " << r.signal << " is "
                        << r.got << ", expected " << r.expected << ' ' << r.note;
}

}  // namespace dynamy
