// Signals as inputs of formulas, and blocks: closed forms and exact recursions, in every scheme.
#include <gtest/gtest.h>
#include <dynamy/io/model/file_gradient.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

/// x(t) of m ẍ + d ẋ + k x = 0 with m = 2, k = 8, d = 1.
double oscillator(double t) {
  const double delta = 0.25, omega = std::sqrt(4.0 - delta * delta);
  return std::exp(-delta * t) *
         (0.3 * std::cos(omega * t) + (1.0 + delta * 0.3) / omega * std::sin(omega * t));
}

TEST(Signals, MakeAForceAFunctionOfTheState) {
  BlockScene scene(cart(R"(<ForceInput on="cart" force="-k*cart.x - {1}*{cart.vx}; 0; 0"/>)",
                        "tolerance=\"1e-10\">"));
  // The error of a tolerance of 1e-10 of 1 m, over a run that forgets little of it.
  EXPECT_NEAR(scene.run().q[0], oscillator(1.0), 1e-9);
}

TEST(Signals, KeepTheOrderOfASchemeWithFixedSteps) {
  const auto error = [](const char* step) {
    BlockScene scene(cart(R"(<ForceInput on="cart" force="-k*cart.x - cart.vx; 0; 0"/>)",
                          std::string("step=\"") + step + "\"><GeneralizedAlpha/>"));
    return std::abs(scene.run().q[0] - oscillator(1.0));
  };
  // Explicit in this force, of order 1 at least: halving the step halves the error or more.
  EXPECT_GT(error("2e-3"), 1.8 * error("1e-3"));
}

TEST(Signals, OfUnknownNamesAreReportedWithTheirPlace) {
  const std::string error = errorOf(
      "<dynamy version=\"1\"><systems><PointMass name=\"cart\" position=\"0 0 0\" mass=\"2\"/>"
      "</systems>\n<forces><ForceInput on=\"cart\" force=\"2*cart.vy + cart.vxx; 0; 0\"/></forces>"
      "<simulation until=\"1\" step=\"1e-3\"/></dynamy>");
  EXPECT_NE(
      error.find("scene.xml:2:50: error: <ForceInput>: no signal named \"cart.vxx\" — did you "
                 "mean \"cart.vx\"?"),
      std::string::npos)
      << error;
}

TEST(Signals, OfContactForcesAreRefused) {
  const std::string error =
      errorOf(cart(R"(<ForceInput on="cart" force="stop.lambda_N; 0; 0"/>)", "step=\"1e-3\">",
                   R"(<CoordinateContact name="stop" on="cart" gap="1 - x"/>)"));
  EXPECT_NE(error.find("the signal \"stop.lambda_N\" belongs to a contact"), std::string::npos)
      << error;
}

TEST(Signals, ThatFollowFromThemselvesAreRefusedWithTheLoop) {
  const std::string joint = R"( between="world cart" coordinate="displacement" axis="1 0 0" )";
  const std::string error = errorOf(
      "<dynamy version=\"1\"><systems><Ground name=\"world\"/><PointMass name=\"cart\" "
      "position=\"0 0 "
      "0\" mass=\"2\"/></systems><forces><JointForce name=\"a\"" +
      joint + "force=\"b.force\"/><JointForce name=\"b\"" + joint +
      "force=\"1 + a.force\"/></forces><simulation until=\"1\" step=\"1e-3\"/></dynamy>");
  EXPECT_NE(error.find("b.force ← a.force ← b.force"), std::string::npos) << error;
}

TEST(Signals, HaveTheirFullNamesInReplicates) {
  BlockScene scene(R"(<dynamy version="1"><systems><replicate count="2" index="i">
    <PointMass name="cart" position="{i} 0 0" mass="2"/></replicate></systems><forces>
    <replicate count="2" index="i"><ForceInput on="cart" force="2*cart.x; 0; 0"/></replicate>
    <ForceInput on="cart[0]" force="4*{cart[1].x}; 0; 0"/></forces>
    <simulation until="0.1" step="0.1"><MoreauMidpoint/></simulation></dynamy>)");
  const State x = scene.run();
  // One step of constant forces at the start: 4 · 1 N and 2 · 1 N on 2 kg.
  EXPECT_NEAR(x.u[0], 0.2, 1e-15);
  EXPECT_NEAR(x.u[3], 0.1, 1e-15);
}

TEST(Signals, HaveIndicesThatAreComputed) {
  const auto scene = [](const std::string& of) {
    return "<dynamy version=\"1\"><systems><replicate count=\"3\"><PointMass name=\"m\" "
           "mass=\"1\" position=\"{0.1*i^2} 0 0\"/></replicate></systems><forces><replicate "
           "count=\"2\"><Formula name=\"d\" of=\"" +
           of + "\"/></replicate></forces><simulation until=\"1\" step=\"1e-3\"/></dynamy>";
  };
  BlockScene run(scene("{m[i + 1].x} - {m[2*i].x}"));
  const State x = run.run();
  EXPECT_DOUBLE_EQ(run.signal(x, "d[0].out"), 0.1);
  EXPECT_DOUBLE_EQ(run.signal(x, "d[1].out"), 0.0);
  EXPECT_NE(errorOf(scene("{m[i/2].x}")).find("an index is a whole number from 0 on, not 0.5"),
            std::string::npos);
  EXPECT_NE(errorOf(scene("m[1].x + 1")).find("did you mean \"{m[1].x}\"?"), std::string::npos);
}

TEST(Signals, MoveALatch) {
  // A brake that closes once the other body has passed 0.5 m: at 0.5 s, then 1 − 2 (t − 0.5) m/s.
  BlockScene scene(R"(<dynamy version="1"><systems>
    <PointMass name="other" position="0 0 0" velocity="1 0 0" mass="1"/>
    <Coordinates name="m" q="x" units="m" q0="0" u0="1" M="1"/></systems><elements>
    <CoordinateContact on="m" slip="1" engage="other.x - 0.5"><GivenFriction force="2"/>
    </CoordinateContact></elements><simulation until="0.8" tolerance="1e-10"/></dynamy>)");
  EXPECT_NEAR(scene.run().u[3], 1.0 - 2.0 * 0.3, 1e-9);
}

/// The states of a cart under a held force from 0 to 1 s, sampled every T.
struct Discrete {
  double x = 0.3, v = 1.0;
  void move(double F, double T) {
    const double a = F / 2.0;
    x += T * (v + 0.5 * T * a);
    v += T * a;
  }
};

/// All schemes whose steps are exact under a constant force; steps that the period is no multiple
/// of, and tolerances.
const char* const kExact[] = {"step=\"3ms\">",
                              "step=\"40ms\">",
                              "step=\"3ms\"><MoreauMidpoint/>",
                              "tolerance=\"1e-6\">",
                              "tolerance=\"1e-3\">",
                              "step=\"7ms\"><ThetaMethod theta=\"0.5\"/>",
                              "tolerance=\"1e-6\"><EventDriven/>"};

TEST(SampledBlocks, GiveTheRecursionOfADiscreteControllerInEveryScheme) {
  Discrete cartOf;
  double F = 0.0;
  for (int k = 0; k < 100; ++k) {
    F = -40.0 * cartOf.x - 6.0 * cartOf.v;
    cartOf.move(F, 0.01);
  }
  for (const char* scheme : kExact) {
    BlockScene scene(cart(R"(<Sample name="s" of="-40*cart.x - 6*cart.vx" period="10ms"/>
                        <ForceInput on="cart" force="s.out; 0; 0"/>)",
                          scheme));
    const State x = scene.run();
    // Rounding of 400 steps of numbers up to 1, and the 2e-14 s of located steps beside an instant.
    EXPECT_NEAR(x.q[0], cartOf.x, 1e-12) << scheme;
    EXPECT_NEAR(x.u[0], cartOf.v, 1e-12) << scheme;
  }
}

TEST(SampledBlocks, LimitAPidAndItsIntegral) {
  for (const std::string antiWindup : {"clamp", "back", "none"}) {
    Discrete cartOf;
    double I = 0.0, D = 0.0, before = 0.0;
    const double T = 0.01, Tf = 0.02, Tt = 0.5;
    for (int k = 0;; ++k) {
      const double e = 2.0 - cartOf.x;
      D = (Tf * D + (k > 0 ? 8.0 * (e - before) : 0.0)) / (Tf + T), before = e;
      double next = I + 30.0 * T * e;
      const double wanted = 40.0 * e + next + D;
      if (antiWindup == "clamp" && wanted > 20.0 && e > 0.0) next = I;
      if (antiWindup == "clamp" && wanted < -20.0 && e < 0.0) next = I;
      const double F = std::clamp(40.0 * e + next + D, -20.0, 20.0);
      I = next + (antiWindup == "back" ? T / Tt * (F - (40.0 * e + next + D)) : 0.0);
      if (k == 100) break;  // the sample at the end of the run
      cartOf.move(F, T);
    }
    for (const char* scheme : kExact) {
      BlockScene scene(
          cart(R"(<Pid name="pid" error="2 - cart.x" kp="40" ki="30" kd="8" filter="20ms"
                          period="10ms" lower="-20" upper="20" tracking="0.5" antiWindup=")" +
                   antiWindup + R"("/><ForceInput on="cart" force="pid.out; 0; 0"/>)",
               scheme));
      const State x = scene.run();
      // Located steps end up to 2e-14 s beside an instant: 4e-14 m, times 8 N s/m/30 ms of the rate
      // is 1e-11 N in a sample, less in the positions and integrals of 100 samples.
      EXPECT_NEAR(x.q[0], cartOf.x, 1e-11) << antiWindup << ' ' << scheme;
      EXPECT_NEAR(scene.signal(x, "pid.integral"), I, 1e-10) << antiWindup << ' ' << scheme;
    }
  }
}

TEST(Signals, SetTheSpeedOfAMotor) {
  // Speed 1 + k/10 m/s in the k-th tenth of a second: x = 0.3 + 0.1 Σ (1 + k/10).
  const std::string motor =
      R"(<JointMotor between="world cart" coordinate="displacement" axis="1 0 0" limit="1e6" )";
  for (const char* scheme : {"tolerance=\"1e-8\">", "step=\"3ms\">"}) {
    BlockScene scene(R"(<dynamy version="1"><systems><Ground name="world"/>
      <PointMass name="cart" position="0.3 0 0" velocity="1 0 0" mass="2"/></systems><forces>
      <Sample name="s" of="1 + t" period="0.1"/></forces><elements>)" +
                     motor + R"(speed="s.out" speedRate="0"/></elements><simulation until="1" )" +
                     scheme + "</simulation></dynamy>");
    // Steps that end with the new speed of an instant contain it for one step of 1 ms or less.
    EXPECT_NEAR(scene.run().q[0], 0.3 + 1.45, scheme[0] == 't' ? 1e-7 : 3e-3) << scheme;
  }
}

TEST(Signals, PressABrake) {
  // Friction 4 x N against 2 kg: ẍ = −2 x from 0.3 m with 1 m/s, until it stands.
  BlockScene scene(R"(<dynamy version="1"><systems><Ground name="world"/>
    <PointMass name="cart" position="0.3 0 0" velocity="1 0 0" mass="2"/></systems><elements>
    <JointFriction between="world cart" coordinate="displacement" axis="1 0 0" scale="cart.x">
    <GivenFriction force="4"/></JointFriction></elements>
    <simulation until="0.5" tolerance="1e-9"/></dynamy>)");
  const double w = std::sqrt(2.0);
  EXPECT_NEAR(scene.run().q[0], 0.3 * std::cos(0.5 * w) + std::sin(0.5 * w) / w, 1e-8);
}

TEST(SampledBlocks, DelayByWholePeriods) {
  BlockScene scene(
      cart(R"(<Delay name="late" of="cart.x" samples="30" period="10ms" initial="-1"/>)",
           "tolerance=\"1e-6\">"));
  // x = 0.3 + t at 1 s − 0.3 s.
  EXPECT_NEAR(scene.signal(scene.run(), "late.out"), 1.0, 1e-12);
}

TEST(SampledBlocks, OfOneInstantSampleInTheOrderOfTheModel) {
  BlockScene scene(cart(R"(<Sample name="late" of="now.out" period="0.1"/>
                      <Sample name="now" of="t" period="0.1"/>
                      <Sample name="at_once" of="now.out" period="0.1"/>)",
                        "step=\"1e-2\">"));
  const State x = scene.run();
  EXPECT_NEAR(scene.signal(x, "now.out"), 1.0, 1e-12);
  EXPECT_NEAR(scene.signal(x, "late.out"), 0.9, 1e-12);
  EXPECT_NEAR(scene.signal(x, "at_once.out"), 1.0, 1e-12);
}

TEST(SampledBlocks, WhosePeriodIsBelowTheRoundingOfTheTimeEndARunAtOnce) {
  for (const char* simulation : {R"(step="1e-2">)", R"(tolerance="1e-6">)"}) {
    BlockScene scene(
        cart(R"(<Pid name="pid" error="2 - cart.x" kp="1" period="1e-18"/>)", simulation));
    Simulation run(scene.model());
    const RunReport& r = run.run();
    EXPECT_EQ(r.ended, RunReport::Ended::failed) << simulation;
    EXPECT_EQ(r.steps, 0) << simulation;
    EXPECT_NE(r.reason.find("samples of pid"), std::string::npos) << r.reason;
    // 128 times the rounding of 1 s is 2.8e-14 s.
    EXPECT_NE(r.reason.find("take a period of 3e-14 s"), std::string::npos) << r.reason;
  }
}

TEST(SampledBlocks, AreDifferentiatedWithTheRun) {
  Registry registry;
  PluginLoader plugins({DYNAMY_BINARY_DIR "/lib/dynamy"});
  registerFramework(registry);
  plugins.load(kStandardElements, {}, registry);
  const Gradient g = gradient({.file = DYNAMY_SOURCE_DIR "/models/cart_pid.xml",
                               .of = {"cart.x@0.5"},
                               .by = {"a0"},
                               .tolerance = 1e-9},
                              registry, plugins);
  ASSERT_TRUE(g.refused[0].empty()) << g.refused[0];
  // Differences of the independent integration of theory 55.4, good to 1e-10; derivatives of runs
  // to 1e-8 of their size.
  EXPECT_NEAR(g.values[0].d[0], 2.0939178594, 2e-8);
}

TEST(Table, IsLinearBetweenItsPointsAndHeldBeyondThem) {
  BlockScene scene(cart(R"(<Table name="low" of="-t" points="0 3  1 5"/>
                      <Table name="middle" of="cart.x" points="1 3  2 5"/>
                      <Table name="high" of="cart.x" points="0 3  1 5"/>)",
                        "step=\"1e-2\">"));
  const State x = scene.run();
  EXPECT_EQ(scene.signal(x, "low.out"), 3.0);
  EXPECT_NEAR(scene.signal(x, "middle.out"), 3.6, 1e-13);  // x = 1.3, rounding of 100 steps
  EXPECT_EQ(scene.signal(x, "high.out"), 5.0);
}

TEST(Table, OfTheTimeAnnouncesItsKinks) {
  // Force 0 → 6 N within 0.3 s, then back within 0.1 s: Δv = ½ · 6 · 0.4/2.
  BlockScene scene(cart(R"(<Table name="f" of="2*t - 0.1" points="0 0  0.6 6  0.8 0"/>
                      <ForceInput on="cart" force="f.out; 0; 0"/>)",
                        "tolerance=\"1e-6\">"));
  // Steps of order 5 and 8 end at the kinks and integrate a line exactly.
  EXPECT_NEAR(scene.run().u[0], 1.6, 1e-12);
}

TEST(Table, ReadsColumnsOfAFile) {
  const std::string folder = ::testing::TempDir();
  std::ofstream(folder + "map.csv") << "speed,force,moment\n0,1,10\n2,3,30\n";
  BlockScene scene(
      cart(R"(<Table name="f" of="cart.vx" file=")" + folder + R"(map.csv" column="3"/>)",
           "step=\"1e-2\">"));
  EXPECT_EQ(scene.signal(scene.run(), "f.out"), 20.0);
}

TEST(StateBlocks, IntegrateAndFilterUnderTheErrorControl) {
  BlockScene scene(cart(R"(<Integrator name="i" rate="cart.x" initial="2"/>
                      <Filter name="f" of="1 + i.out - i.out" time="0.2"/>
                      <Integrator name="decay" rate="-3*x" initial="1"/>)",
                        "tolerance=\"1e-10\">"));
  const State x = scene.run();
  // x = 0.3 + t; the tolerance on velocities of 1 m/s.
  EXPECT_NEAR(scene.signal(x, "i.out"), 2.0 + 0.3 + 0.5, 1e-9);
  EXPECT_NEAR(scene.signal(x, "f.out"), 1.0 - std::exp(-5.0), 1e-9);
  EXPECT_NEAR(scene.signal(x, "decay.out"), std::exp(-3.0), 1e-9);
}

TEST(StateBlocks, ThatAreStiffFollowTheirInputInStepsTenTimesTooLong) {
  BlockScene scene(
      cart(R"(<Filter name="f" of="cart.x" time="0.1ms" stiff="true"/>)", "step=\"1e-3\">"));
  Simulation simulation(scene.model());
  EXPECT_EQ(simulation.run().ended, RunReport::Ended::finished) << simulation.report().reason;
  EXPECT_EQ(simulation.report().steps, 1000);  // none is divided
  // x = 0.3 + t lags by T = 1e-4 m; a step takes its input at most a step of the ramp beside.
  EXPECT_NEAR(scene.signal(simulation.state(), "f.out"), 1.3 - 1e-4, 1e-3);
}

TEST(StateBlocks, CloseAContinuousPidLoop) {
  // m ẍ = k (1 − x) + 5 ∫(1 − x) − 6 ẋ with m = 2, k = 8: the same as one system of formulas.
  BlockScene blocks(cart(R"(<Integrator name="i" rate="1 - cart.x"/>
                       <ForceInput on="cart" force="8*(1 - cart.x) + 5*i.out - 6*cart.vx; 0; 0"/>)",
                         "tolerance=\"1e-11\">"));
  BlockScene formulas(R"(<dynamy version="1"><systems>
    <Coordinates name="m" q="x i" units="m m" q0="0.3 0" u0="1 0.7" M="2; 0; 1"
      h="8*(1 - x) + 5*i - 6*x_dot; -x_dot"/></systems>
    <simulation until="1" tolerance="1e-11"/></dynamy>)");
  // Both runs keep a tolerance of 1e-11.
  EXPECT_NEAR(blocks.run().q[0], formulas.run().q[0], 1e-9);
}

}  // namespace
}  // namespace dynamy
