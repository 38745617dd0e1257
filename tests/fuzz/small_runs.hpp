/// Runs of a few bodies for fuzzing: what they keep, and going on from bytes of any origin.
#pragma once
#include <atomic>
#include <cstdint>
#include <dynamy/core/error.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy::fuzz {

/// Bodies that fall, slide and hang; `simulation` is the element of that name.
inline std::string scene(std::string_view simulation) {
  return R"(<dynamy version="1"><systems>
  <Ground name="world"><HalfSpace material="floor"/></Ground>
  <RigidBody name="a" position="0 0 0.3" velocity="1 0 0"><Sphere radius="0.1" mass="1" material="ball"/></RigidBody>
  <RigidBody name="b" position="0.35 0 0.3" velocity="-1 0 0.2"><Sphere radius="0.1" mass="1" material="ball"/></RigidBody>
  <RigidBody name="rod" position="2 0 1" mass="1" inertia="0.1 0.1 0.1"/></systems>
  <forces><Gravity/></forces>
  <elements><Contact between="ball floor"><UnilateralCoulomb epsilonN="0.5" mu="0.3"/></Contact>
  <Contact between="ball ball"><UnilateralCoulomb epsilonN="0.5" mu="0.3"/></Contact>
  <Spherical name="hook" between="world rod" at="2.3 0 1"/></elements>)" +
         std::string(simulation) + R"(
  <record signals="a.* rod.*" every="10ms"/>
  <check signal="a.z" measure="period" between="0 9"/><check signal="a.x" measure="mean" between="-9 9"/>
</dynamy>)";
}

/// One for each way to step and to keep numbers from step to step.
inline const std::vector<std::string>& scenes() {
  static const std::vector<std::string> all = {
      scene(R"(<simulation until="1" step="5ms"/>)"),
      scene(R"(<simulation until="1" tolerance="1e-6"/>)"),
      scene(R"(<simulation until="1" step="5ms"><MoreauMidpoint/></simulation>)"),
      scene(R"(<simulation until="1" step="5ms"><GeneralizedAlpha/></simulation>)"),
      scene(R"(<simulation until="1" step="10ms"><AugmentedMoreau/></simulation>)"),
  };
  return all;
}

struct World {
  Registry registry;
  PluginLoader plugins;
  World() {
    registerFramework(registry);
    plugins.load(kStandardElements, "", registry);
  }
  Model model(std::size_t scene) {
    return loadModelText(scenes()[scene % scenes().size()], "fuzz.xml", registry, plugins);
  }
};

/// Takes all that a run records, and forgets it.
class Nowhere final : public RecordSink {
 public:
  void row(double, std::span<const double>) override {}
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  bool wantsLedger() const override { return true; }
};
/// Ends a run after so many steps.
class StopAfter final : public Observer {
 public:
  explicit StopAfter(long steps) : left_(steps) {}
  void step(const StepView&) override { stop = --left_ <= 0; }
  std::atomic<bool> stop{false};

 private:
  long left_;
};

/// What a run of the scene keeps after so many steps, or so many after `from`.
inline std::string kept(World& world, std::size_t scene, long steps, const std::string& from = {}) {
  Model model = world.model(scene);
  Simulation simulation(model);
  Nowhere sink;
  StopAfter observer(steps);
  simulation.record(sink);
  simulation.observe(observer);
  simulation.stopWhen(observer.stop);
  if (!from.empty()) simulation.resume(from);
  simulation.run();
  return simulation.checkpoint();
}

/// Goes on from any bytes: a ModelError, or a run that ends in words; never anything else. True: it
/// went on.
inline bool goesOn(World& world, std::size_t scene, const std::string& bytes, long steps = 3) {
  try {
    kept(world, scene, steps, bytes);
    return true;
  } catch (const ModelError&) {
    return false;
  }
}

}  // namespace dynamy::fuzz
