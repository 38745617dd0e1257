// What a run does with a start that its joints do not allow, in every scheme.
#include <gtest/gtest.h>
#include <build_paths.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/run/simulation.hpp>

#include <cmath>
#include <string>

namespace dynamy {
namespace {

/// A model with the standard elements.
class Scene {
 public:
  explicit Scene(const std::string& text) : plugins_({DYNAMY_BINARY_DIR "/lib/dynamy"}) {
    registerFramework(registry_);
    plugins_.load(kStandardElements, {}, registry_);
    model_ = std::make_unique<Model>(loadModelText(text, "scene.xml", registry_, plugins_, {}));
  }
  Model& model() { return *model_; }

 private:
  Registry registry_;
  PluginLoader plugins_;
  std::unique_ptr<Model> model_;
};

/// A rod of mass 1, length 1 and J_S = 1/12 on a pin at its end; its centre starts with the
/// velocity vz along z and the angular velocity w, which a rigid rod at the pin cannot have.
std::string rod(const std::string& simulation, const std::string& more = "",
                const std::string& state = R"(velocity="0 0 1")") {
  return R"(<dynamy version="1"><systems><Ground name="world"/>
    <PlanarBody name="rod" position="0.5 0 0" mass="1" inertia="{1/12}" )" +
         state + R"(><Box size="1 0.1 0.1"/></PlanarBody></systems>
    <elements><Revolute name="pin" between="world rod" at="0 0 0"/>)" +
         more + "</elements><simulation until=\"0.2\" " + simulation + "</simulation></dynamy>";
}

const Warning* find(const std::vector<Warning>& all, const std::string& kind) {
  for (const Warning& w : all)
    if (w.kind == kind) return &w;
  return nullptr;
}

// The angular momentum about the pin decides: m v l/2 = J_O omega, J_O = 1/3, so that
// |omega| = 1.5 rad/s and T falls from 1/2 to ½ (1/3) 1.5² = 3/8 J. Without gravity both last.
TEST(ConsistentStart, VelocitiesAreProjectedInTheMetricOfTheMassInEveryScheme) {
  for (const char* simulation :
       {R"(step="1e-3">)", R"(step="1e-3"><MoreauMidpoint/>)", R"(step="1e-3"><StaggeredMoreau/>)",
        R"(step="1e-3"><NonsmoothRattle/>)", R"(step="1e-3"><StewartTrinkle/>)",
        R"(tolerance="1e-8">)"}) {
    Scene scene(rod(simulation));
    Simulation run(scene.model());
    const RunReport& r = run.run();
    ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
    EXPECT_NEAR(r.energy.kineticStart, 0.375, 1e-12) << simulation;
    // Schemes on velocity level leave the circle along its tangent: each of 200 steps changes the
    // speed by up to (omega dt)^2/2 of it, 2.3e-4 of all; where it was projected, 25 % were lost.
    EXPECT_NEAR(std::abs(run.state().u.tail<1>()[0]), 1.5, 1.5 * 2.3e-4) << simulation;
    EXPECT_NEAR(r.energy.discretisation, 0.0, 0.375 * 2.0 * 2.3e-4) << simulation;
    const Warning* told = find(r.warnings, "start velocities");
    ASSERT_NE(told, nullptr) << simulation;
    EXPECT_EQ(told->place.find("pin (scene.xml:3:"), 0u) << told->place;
    EXPECT_NE(told->text.find("T 0.5 -> 0.375 J"), std::string::npos) << told->text;
    // Of both velocities, in the metric of the mass: √(1/8) / √(1/2).
    EXPECT_NEAR(r.start.velocities.share, 0.5, 1e-12);
    EXPECT_FALSE(r.qualified());
  }
}

TEST(ConsistentStart, RoundedNumbersOfAFileAreMendedInSilence) {
  Scene scene(rod(R"(step="1e-3">)", "", R"(velocity="0 0 1" angularVelocity="2.0000001")"));
  Simulation run(scene.model());
  EXPECT_TRUE(run.run().warnings.empty());
  EXPECT_GT(run.report().start.velocities.off, 0.0);
  EXPECT_LT(run.report().start.velocities.left, 1e-14);
}

// Two pins at one place hold twice what one does.
TEST(ConsistentStart, RedundantJointsShare) {
  Scene scene(rod(R"(step="1e-3">)", R"(<Revolute name="pin2" between="world rod" at="0 0 0"/>)"));
  MechanicalSystem s = scene.model().mechanicalSystem();
  State x = scene.model().initialState();
  s.evaluate(x);
  const StartReport start = makeConsistent(scene.model(), s, x);
  EXPECT_NEAR(std::abs(x.u[2]), 1.5, 1e-12);
  EXPECT_EQ(start.velocities.against, "");
  EXPECT_EQ(start.velocities.joints, 2);
}

// A drive sets the rate from the first instant: chi is not zero.
TEST(ConsistentStart, DrivesSetTheVelocitiesFromTheFirstInstant) {
  Scene scene(
      rod(R"(step="1e-3">)", R"(<JointDrive between="world rod" axis="0 1 0" motion="3*t"/>)", ""));
  Simulation run(scene.model());
  const RunReport& r = run.run();
  EXPECT_NEAR(r.energy.kineticStart, 0.5 / 3.0 * 9.0, 1e-12);
  EXPECT_NE(find(r.warnings, "start velocities"), nullptr);
  EXPECT_NEAR(r.energy.discretisation, 0.0, 1e-6);
}

TEST(ConsistentStart, DrivesThatContradictEachOtherQualifyTheRun) {
  Scene scene(rod(R"(step="1e-3">)",
                  R"(<JointDrive between="world rod" axis="0 1 0" motion="3*t"/>
                     <JointDrive name="other" between="world rod" axis="0 1 0" motion="-t"/>)"));
  const RunReport r = Simulation(scene.model()).run();
  ASSERT_NE(find(r.warnings, "contradiction"), nullptr);
  EXPECT_TRUE(r.qualified());
}

/// A point on rods: its distances from the origin and, if not "", from a second point.
std::string bob(const std::string& first, const std::string& second) {
  const auto distance = [](const std::string& length) {
    return length.empty() ? "" : "<Distance between=\"world b\" length=\"" + length + "\"/>";
  };
  return R"(<dynamy version="1"><systems><Ground name="world"/>
    <PointMass name="b" position="0 0 1" mass="1"/></systems><elements>)" +
         distance(first) + distance(second) +
         R"(</elements><simulation until="0.01" step="1e-3"/></dynamy>)";
}

TEST(ConsistentStart, BodiesAreMovedOntoJointsThatDoNotFit) {
  Scene scene(bob("1.2", ""));
  const RunReport r = Simulation(scene.model()).run();
  EXPECT_NEAR(r.start.positions.off, 0.2, 1e-12);
  EXPECT_LT(r.start.positions.left, 1e-11);
  EXPECT_NE(find(r.warnings, "start positions"), nullptr);
  EXPECT_LT(r.gaps.jointError.value, 1e-9);
  EXPECT_FALSE(r.qualified());
}

TEST(ConsistentStart, LengthsThatContradictEachOtherAreNamedAndNothingIsMoved) {
  Scene scene(bob("5", "1"));
  MechanicalSystem s = scene.model().mechanicalSystem();
  State x = scene.model().initialState();
  s.evaluate(x);
  const StartReport start = makeConsistent(scene.model(), s, x);
  EXPECT_EQ(x.q, scene.model().initialState().q);
  EXPECT_NEAR(start.positions.left, 4.0, 1e-12);
  const std::vector<Warning> all = startWarnings(start, scene.model().length());
  ASSERT_NE(find(all, "contradiction"), nullptr);
  EXPECT_NE(find(all, "contradiction")->text.find("scene.xml:"), std::string::npos);
}

TEST(ConsistentStart, AStartThatFitsIsLeftToTheLastBit) {
  Scene scene(rod(R"(step="1e-3">)", "", R"(velocity="0 0 1" angularVelocity="2")"));
  MechanicalSystem s = scene.model().mechanicalSystem();
  State x = scene.model().initialState();
  s.evaluate(x);
  makeConsistent(scene.model(), s, x);
  EXPECT_EQ(x.u, scene.model().initialState().u);
  EXPECT_EQ(x.q, scene.model().initialState().q);
}

TEST(ConsistentStart, AJointOfABodyWithItselfIsRefused) {
  for (const char* joint : {"<Spherical between=\"b b\"/>", "<Distance between=\"b b.tip\"/>",
                            "<Fixed between=\"b.tip b\"/>"}) {
    const std::string text = std::string(R"(<dynamy version="1"><systems><Ground name="world"/>
      <RigidBody name="b" position="0 0 1"><Sphere radius="0.1" mass="1"/>
        <Frame name="tip" position="0.2 0 0"/></RigidBody></systems><elements>)") +
                             joint +
                             R"(</elements><simulation until="0.01" step="1e-3"/></dynamy>)";
    try {
      Scene scene(text);
      FAIL() << joint;
    } catch (const ModelError& e) {
      const std::string what = format(e.diagnostics());
      EXPECT_NE(what.find("scene.xml:3:"), std::string::npos) << what;
      EXPECT_NE(what.find("a body and itself"), std::string::npos) << what;
    }
  }
}

/// Crank of 0.1 m at 1 rad, rod of `length`, slider: places fit a rod of 0.3 m, only the crank turns.
std::string sliderCrank(const std::string& length, const std::string& keep) {
  return R"(<dynamy version="1"><parameter name="b" value="{asin(0.1*sin(1)/0.3)}"/><systems>
    <Ground name="world"/>
    <PlanarBody name="crank" angle="1" angularVelocity="10" mass="1" inertia="1e-3"/>
    <PlanarBody name="slider" position="{0.1*cos(1) + 0.3*cos(b)} 0 0" mass="20" inertia="1e-3"/>
    </systems><elements><Revolute name="bearing" between="world crank"/>
    <Distance name="rod" between="crank slider" pointA="0.1 0 0" length=")" +
         length + R"("/><Prismatic name="guide" between="world slider" axis="1 0 0"/></elements>
    <simulation until="0.01" tolerance="1e-8" )" +
         keep + "/></dynamy>";
}

TEST(ConsistentStart, KeepsWhatTheModelSaysAndAssemblesTheRest) {
  // x = r cos φ + √(l² − r² sin² φ) from the crank alone; the heavy slider would win otherwise.
  const auto slider = [](double l) {
    return 0.1 * std::cos(1) + std::sqrt(l * l - std::pow(0.1 * std::sin(1), 2));
  };
  for (const double l : {0.3, 0.31}) {
    Scene scene(sliderCrank(std::to_string(l), R"(keep="crank.omega")"));
    MechanicalSystem s = scene.model().mechanicalSystem();
    State x = scene.model().initialState();
    s.evaluate(x);
    const StartReport report = makeConsistent(scene.model(), s, x);
    EXPECT_EQ(report.kept, "crank.omega");
    EXPECT_TRUE(report.velocities.against.empty());
    // Newton's method ends at 1e-12 of the scene's length.
    EXPECT_EQ(x.q[2], 1.0) << l;
    EXPECT_EQ(x.u[2], 10.0) << l;
    EXPECT_NEAR(x.q[3], slider(l), 1e-12) << l;
    const double c = x.q[3] - 0.1 * std::cos(1);
    EXPECT_NEAR(x.u[3], -10.0 * 0.1 * std::sin(1) * (1.0 + 0.1 * std::cos(1) / c), 1e-10) << l;
    const std::vector<Warning> told = startWarnings(report, 0.3);
    ASSERT_NE(find(told, "start velocities"), nullptr);
    EXPECT_NE(find(told, "start velocities")->text.find("with crank.omega kept"),
              std::string::npos);
  }
}

TEST(ConsistentStart, SaysWhereWhatIsKeptContradictsTheJoints) {
  Scene scene(sliderCrank("0.3", R"(keep="crank slider")"));
  MechanicalSystem s = scene.model().mechanicalSystem();
  State x = scene.model().initialState();
  s.evaluate(x);
  const std::vector<Warning> told = startWarnings(makeConsistent(scene.model(), s, x), 0.3);
  ASSERT_NE(find(told, "contradiction"), nullptr);
  EXPECT_NE(find(told, "contradiction")->text.find("with crank slider kept"), std::string::npos);
}

TEST(ConsistentStart, RefusesToKeepWhatThereIsNot) {
  try {
    Scene scene(sliderCrank("0.3", R"(keep="crank.omga")"));
    FAIL();
  } catch (const ModelError& e) {
    EXPECT_NE(std::string(e.what()).find("no system and no velocity \"crank.omga\" — did you mean "
                                         "\"crank.omega\"?"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace dynamy
