// LocatedMotion advances one island: two instances on two halves of a scene take turns, and find
// the bits of two separate runs.
#include <gtest/gtest.h>

#include <build_paths.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/located/step/located_motion.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dynamy::reference {
namespace {

constexpr double kIslandTolerance = 1e-8, kLength = 1.0, kUntil = 3.0;  // [1], [m], [s]

const std::string kRubberBall = R"xml(
  <PointMass name="ball" mass="1" position="0 0 1" velocity="1 0.5 0">
    <Point material="rubber"/></PointMass>)xml";
const std::string kWoodenBox = R"xml(
  <RigidBody name="box" mass="2" inertia="0.1 0.2 0.25" position="9 0 1.2" orientation="0.97 0.2 0.1 0.05"
    velocity="0.5 0 0" angularVelocity="1 2 0.5"><Box size="0.3 0.4 0.5" material="wood"/></RigidBody>)xml";

/// A scene with a floor and these bodies, loaded and completed.
class IslandScene {
 public:
  explicit IslandScene(const std::string& bodies) : plugins_({DYNAMY_BINARY_DIR "/lib/dynamy"}) {
    registerFramework(registry_);
    plugins_.load(kStandardElements, {}, registry_);
    const std::string text = "<dynamy version=\"1\"><systems>" + bodies + R"xml(
      <Ground name="world"><HalfSpace material="floor"/></Ground></systems>
      <forces><Gravity/></forces><elements>
      <Contact between="rubber floor"><UnilateralCoulomb epsilonN="0.7" mu="0.3"/></Contact>
      <Contact between="wood floor"><UnilateralCoulomb epsilonN="0.2" mu="0.4"/></Contact>
      <NoContact between="rubber wood"/><NoContact between="rubber rubber"/>
      <NoContact between="wood wood"/></elements><simulation until="3" step="1"/></dynamy>)xml";
    model_ = std::make_unique<Model>(loadModelText(text, "scene.xml", registry_, plugins_, {}));
    system_ = std::make_unique<MechanicalSystem>(model_->mechanicalSystem());
  }
  MechanicalSystem& system() { return *system_; }
  Model& model() { return *model_; }
  /// Place of a system among q and u.
  const SystemHandle& handle(int i) const { return system_->parts().topology->system(i); }

 private:
  Registry registry_;
  PluginLoader plugins_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<MechanicalSystem> system_;
};

/// A view on system `only` of a scene (0 or 1).
class Island {
 public:
  Island(IslandScene& scene, int only)
      : scene_(scene), x_(scene.model().initialState()), only_(only) {
    motion_.aim({kIslandTolerance, kLength});
    leftOut_.assign(scene.system().parts().topology->systems().size(), 0);
    for (int i = 0; i < static_cast<int>(leftOut_.size()); ++i) {
      const SystemHandle& h = scene.handle(i);
      if (i == only || h.nu == 0) continue;
      leftOut_[static_cast<std::size_t>(i)] = 1;
      x_.u.segment(h.u0, h.nu).setZero();
    }
    SystemParts parts = scene.system().parts();
    subset_.assign(*parts.topology, leftOut_, parts.forces, parts.contacts);
    parts.subset = &subset_;
    view_ = std::make_unique<MechanicalSystem>(parts, 2);
    view_->gTol(scene.system().gTol());
  }
  double t() const { return x_.t; }
  int impacts() const { return impacts_; }
  /// Takes a step and notes its end.
  void step() {
    MechanicalSystem& s = *view_;
    StepReport report;
    LocatedMotion::Start start;
    start.goesOn = motion_.endsAt(s, x_), start.held = started_ ? &held_ : nullptr;
    const Refusal refusal =
        motion_.advance(s, scene_.model().solver(), x_, start, kUntil - x_.t, report);
    ASSERT_FALSE(refusal) << refusal.why;
    const State& end = motion_.end();
    x_.t = end.t, x_.q = end.q, x_.u = end.u;
    motion_.keep(held_), motion_.report(s, x_, report);
    started_ = true, impacts_ += report.counts.impacts;
    const SystemHandle& h = scene_.handle(only_);
    ends_.push_back(x_.t);
    for (int i = 0; i < h.nq; ++i) ends_.push_back(x_.q[h.q0 + i]);
    for (int i = 0; i < h.nu; ++i) ends_.push_back(x_.u[h.u0 + i]);
  }
  /// Numbers in q and u of the system.
  int numbers() const { return scene_.handle(only_).nq + scene_.handle(only_).nu; }
  /// t, q and u of the system at the ends of all steps.
  const std::vector<double>& ends() const { return ends_; }

 private:
  IslandScene& scene_;
  SystemSubset subset_;
  std::unique_ptr<MechanicalSystem> view_;
  LocatedMotion motion_{LocatedSettings{}};
  State x_;
  HeldState held_;
  std::vector<char> leftOut_;
  std::vector<double> ends_;
  int only_, impacts_ = 0;
  bool started_ = false;
};

void runIslands(Island& island) {
  while (island.t() < kUntil) ASSERT_NO_FATAL_FAILURE(island.step());
}

TEST(TwoIslands, TakeTurnsAndKeepTheBitsOfRunsOfTheirOwn) {
  IslandScene scene(kRubberBall + kWoodenBox), same(kRubberBall + kWoodenBox);
  Island first(scene, 0), second(scene, 1), ball(same, 0), box(same, 1);
  while (first.t() < kUntil || second.t() < kUntil)
    ASSERT_NO_FATAL_FAILURE((first.t() <= second.t() ? first : second).step());
  runIslands(ball), runIslands(box);
  // Four impacts of a ball from 1 m with 0.7 take 0.45 (1 + 2 (0.7 + 0.49 + 0.34)) = 1.8 s; a box
  // that tumbles has more.
  EXPECT_GE(first.impacts(), 4);
  EXPECT_GE(second.impacts(), 4);
  EXPECT_EQ(first.ends(), ball.ends());
  EXPECT_EQ(second.ends(), box.ends());
}

TEST(TwoIslands, MoveAsInScenesWithoutTheOther) {
  IslandScene scene(kRubberBall + kWoodenBox), ballScene(kRubberBall), boxScene(kWoodenBox);
  Island first(scene, 0), second(scene, 1), ball(ballScene, 0), box(boxScene, 0);
  runIslands(first), runIslands(second), runIslands(ball), runIslands(box);
  for (const auto& [island, alone] : {std::pair{&first, &ball}, {&second, &box}}) {
    // Not the bits: g_tol (1e-12 of the length of a scene, here about 1e-11 m) decides how far a
    // projection goes on, and impacts of a box that tumbles enlarge differences. In the first
    // 0.6 s, with the first ones, they stay below ten of the errors that a step may have.
    const std::size_t row = 1 + static_cast<std::size_t>(island->numbers());
    for (std::size_t k = 0; alone->ends().at(k - k % row) < 0.6; ++k)
      ASSERT_NEAR(island->ends().at(k), alone->ends()[k], 10.0 * kIslandTolerance) << k;
  }
}

}  // namespace
}  // namespace dynamy::reference
