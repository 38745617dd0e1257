// Elastic ropes against closed forms: statics over sheaves, drums that wind, slack, balance.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <support/gravity.hpp>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

std::string ropeScene(const std::string& systems, const std::string& forces,
                      const std::string& until, const std::string& elements = "") {
  return R"(<dynamy version="1"><systems><Ground name="world"/>)" + systems + "</systems><forces>" +
         forces + "</forces><elements>" + elements + R"(</elements><simulation until=")" + until +
         R"(" tolerance="1e-10"/></dynamy>)";
}

TEST(ElasticRope, CarriesHalfOfTheLoadOnAPulley) {
  // Hung at x = −0.2, down round the pulley of the load at x = 0, up to x = 0.2: S = m g/2 without
  // any motion, since the free length at the start is that of this force.
  BlockScene scene(ropeScene(
      R"(<PlanarBody name="load" position="0 0 -3" mass="100" inertia="1"/>)",
      R"(<Gravity/><ElasticRope name="rope" between="world world" pointA="-0.2 0 0" pointB="0.2 0 0"
         EA="1e5" preload="490.5"><Sheave on="load" radius="0.2" side="0 0 -1"/></ElasticRope>)",
      "1"));
  const State x = scene.run();
  const double l = 6.0 + 0.2 * std::numbers::pi;
  EXPECT_NEAR(scene.signal(x, "load.z"), -3.0, 1e-9);           // ten times the tolerance, of 1 m
  EXPECT_NEAR(scene.signal(x, "rope.force"), 50.0 * kG, 1e-4);  // EA/l of it
  EXPECT_NEAR(scene.signal(x, "rope.length"), l / (1.0 + 490.5e-5), 1e-13);
}

TEST(ElasticRope, PullsASheaveAlongTheBisector) {
  // A rope from (0, 0) over a sheave at (3, 4) of radius 0.5 to (6, 0), stretched by 2 %: by symmetry
  // the sheave is pulled down with 2 S t_z; the tangent rises by 4 m + ... over half the way.
  BlockScene scene(ropeScene(
      R"(<PlanarBody name="wheel" position="3 0 4" mass="1e12" inertia="1"/>)",
      R"(<ElasticRope name="rope" between="world world" pointB="6 0 0" EA="1e4" preload="200">
         <Sheave on="wheel" radius="0.5"/></ElasticRope>)",
      "1"));
  const State x = scene.run();
  // d = (3, 4), |d| = 5: l = √24.75, and the tangent over the sheave has z (4 l + 3 · 0.5)/25.
  const double sine = (4.0 * std::sqrt(24.75) + 1.5) / 25.0;
  EXPECT_NEAR(scene.signal(x, "wheel.vz") * 1e12, -400.0 * sine, 1e-5);
  EXPECT_NEAR(scene.signal(x, "wheel.vx") * 1e12, 0.0, 1e-5);
}

TEST(ElasticRope, WindsManyTurnsOnADrum) {
  // A motor that nothing holds back turns the drum by 10 rad/s for 12 s, 19.1 turns; a load of 10 kg
  // hangs from it and starts with the speed of the rim, so that it only swings by rounding:
  // l0 = l00 − r 120.
  const double S = 10.0 * kG, r = 0.25, l00 = 40.0 / (1.0 + S / 1e6);
  BlockScene scene(ropeScene(
      R"(<Ground name="frame"/>
         <PlanarBody name="drum" mass="1" inertia="1e12" angularVelocity="-10"/>
         <PlanarBody name="load" position="-0.25 0 -40" velocity="0 0 2.5" mass="10" inertia="1"/>)",
      R"(<Gravity/><ElasticRope name="rope" between="load drum" drumB="0.25" sideB="-1 0 0"
         carrier="frame" EA="1e6" damping="0.01" preload=")" +
          std::to_string(S) + R"("/>)",
      "12", R"(<Revolute between="world drum"/><Prismatic between="world load" axis="0 0 1"/>)"));
  const State x = scene.run();
  const double l0 = l00 - r * 120.0;
  EXPECT_NEAR(scene.signal(x, "rope.length"), l0, 1e-8);
  EXPECT_NEAR(scene.signal(x, "rope.turnB"), -120.0, 1e-8);
  // The rope shortens, its stretch with it: the load rises by l0's change times 1 + ε, a little
  // faster than the rim; the force of that is nothing.
  EXPECT_NEAR(scene.signal(x, "load.z"), -l0 * (1.0 + S / 1e6), 1e-7);
}

TEST(ElasticRope, KeepsTheEnergyWhileItWinds) {
  // A free drum and a load swing on an undamped rope: T + V stays.
  BlockScene scene(ropeScene(
      R"(<PlanarBody name="drum" mass="1" inertia="0.5" angularVelocity="3"/>
         <PlanarBody name="load" position="0.25 0 -4" velocity="0.7 0 0" mass="10" inertia="1"/>)",
      R"(<Gravity/><ElasticRope name="rope" between="drum load" drumA="0.25" EA="3000"
         preload="90"/>)",
      "1.5", R"(<Revolute between="world drum"/>)"));
  Simulation run(scene.model());
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_LT(std::abs(run.report().energy.discretisation), 1e-6);  // of 400 J, 1e-10 a step
  EXPECT_GT(scene.signal(run.state(), "rope.force"), 1.0);
}

TEST(ElasticRope, LetsAThrownLoadFlyAndCatchesIt) {
  // Thrown up from where the rope is just taut: slack for 2 v/g, then caught; half a swing about the
  // static stretch: lowest point −l − s − √(s² + v²/ω²), s = m g/k, at the first time v = 0.
  const double m = 2.0, k = 1000.0, v = 1.5, s = m * kG / k, omega = std::sqrt(k / m);
  const double deepest = s + std::sqrt(s * s + v * v / (omega * omega));
  const double phase = std::numbers::pi - std::atan2(v / omega, s),
               t = 2.0 * v / kG + phase / omega;
  BlockScene scene(ropeScene(
      R"(<PlanarBody name="load" position="0 0 -2" velocity="0 0 1.5" mass="2" inertia="1"/>)",
      R"(<Gravity/><ElasticRope name="rope" between="world load" EA="2000"/>)", std::to_string(t)));
  const State x = scene.run();
  // Six decimals of the instant: the speed is 60 m/s² of 5e-7 s. The kink at the end of the slack is
  // passed within the tolerance, times 100 for the steps that it takes.
  EXPECT_NEAR(scene.signal(x, "load.vz"), 0.0, 5e-5);
  EXPECT_NEAR(scene.signal(x, "load.z"), -2.0 - deepest, 1e-8);
}

TEST(ElasticRope, KeepsMomentum) {
  // Three free bodies, two drums and a sheave, without gravity: nothing from outside.
  BlockScene scene(ropeScene(
      R"(<PlanarBody name="a" mass="1" inertia="0.2" angularVelocity="1" velocity="-1 0 0"/>
         <PlanarBody name="b" mass="2" inertia="0.3" position="6 0 0"/>
         <PlanarBody name="c" mass="3" inertia="0.1" position="3 0 4" velocity="0 0 0.5"/>)",
      R"(<ElasticRope name="rope" between="a b" drumA="0.5" drumB="0.3" sideA="-1 0 0" EA="100"
         preload="20" damping="0.05"><Sheave on="c" radius="0.4"/></ElasticRope>)",
      "0.8"));
  const State x = scene.run();
  const auto sum = [&](const State& at) {
    Vec3 out = Vec3::Zero();
    for (const auto& [name, mass, inertia] :
         {std::tuple{"a", 1.0, 0.2}, {"b", 2.0, 0.3}, {"c", 3.0, 0.1}}) {
      const auto of = [&](const char* part) {
        return scene.signal(at, std::string(name) + "." + part);
      };
      out += Vec3(mass * of("vx"), mass * of("vz"),
                  inertia * of("omega") + mass * (of("x") * of("vz") - of("z") * of("vx")));
    }
    return out;
  };
  const Vec3 change = sum(x) - sum(scene.model().initialState());
  EXPECT_LT(change.norm(), 1e-8);  // 10 kg m/s, to the tolerance of some steps
  EXPECT_GT(std::abs(scene.signal(x, "a.omega") - 1.0), 0.1);
}

TEST(ElasticRope, LiesInThePlaneOfItsCarrier) {
  // The same drum and load as a whole turned about x by 0.7 rad, in space and without gravity: the
  // rope shortens as in the plane of the paper.
  const auto drawn = [](const char* turned, const char* place, const char* axis) {
    BlockScene scene(ropeScene(
        std::string(R"(<Ground name="frame" euler=")") + turned +
            R"("/><RigidBody name="drum" euler=")" + turned +
            R"(" mass="1" inertia="0.5 0.5 0.5" angularVelocity="0 -3 0"/>
         <RigidBody name="load" position=")" +
            place + R"(" mass="10" inertia="1 1 1"/>)",
        std::string(
            R"(<ElasticRope name="rope" between="drum load" drumA="0.25" EA="3000" axis=")") +
            axis + R"(" carrier="frame"/>)",
        "0.1", std::string(R"(<Revolute between="frame drum" axis=")") + axis + R"("/>)"));
    const State x = scene.run();
    return scene.signal(x, "rope.force");
  };
  char place[80], axis[80];
  std::snprintf(place, sizeof place, "0.25 %.17g %.17g", 4.0 * std::sin(0.7), -4.0 * std::cos(0.7));
  std::snprintf(axis, sizeof axis, "0 %.17g %.17g", std::cos(0.7), std::sin(0.7));
  const double straight = drawn("0 0 0", "0.25 0 -4", "0 1 0");
  EXPECT_GT(straight, 10.0);
  EXPECT_NEAR(drawn("0.7 0 0", place, axis), straight, 1e-6);  // EA of 1e-10
}

TEST(ElasticRope, BetweenTwoPointsPullsInEveryDirection) {
  // Drawn out straight, without gravity: the load stays on the line through both points, also along the
  // axis that is taken where none is given. A quarter of a period of k = EA/l0 brings it to l0.
  for (const Vec3& n : {Vec3(3.0 / 13.0, 4.0 / 13.0, 12.0 / 13.0), Vec3(0.0, -1.0, 0.0)}) {
    const auto number = [](double x) {
      char text[32];
      std::snprintf(text, sizeof text, "%.17g", x);
      return std::string(text);
    };
    BlockScene scene(
        ropeScene("<PointMass name=\"load\" mass=\"1\" position=\"" + number(13.0 * n.x()) + ' ' +
                      number(13.0 * n.y()) + ' ' + number(13.0 * n.z()) + "\"/>",
                  R"(<ElasticRope name="rope" between="world load" EA="1200" length="12"/>)",
                  number(std::numbers::pi / 20.0)));
    const State x = scene.run();
    const Vec3 r(scene.signal(x, "load.x"), scene.signal(x, "load.y"), scene.signal(x, "load.z"));
    EXPECT_LT((r - 12.0 * n).norm(), 1e-8);  // 13 m, some steps of 1e-10
  }
}

TEST(ElasticRope, KeepsEnergyAndMomentumWhereItLeans) {
  // A carrier with a drum and a sheave floats in space, and the load swings beside their plane.
  BlockScene scene(ropeScene(
      R"(<RigidBody name="c" mass="3" inertia="0.5 0.5 0.5" angularVelocity="0.3 0.2 -0.4"/>
         <RigidBody name="d" mass="1" inertia="0.2 0.2 0.2" position="0 0 1"
                    angularVelocity="0.3 2.2 -0.4" velocity="0.2 -0.3 0"/>
         <RigidBody name="b" mass="2" inertia="0.1 0.1 0.1" position="2.2 1.1 -1.5"
                    velocity="0 0.4 0.2"/>)",
      R"(<ElasticRope name="rope" between="d b" drumA="0.25" sideA="-1 0 0" EA="300" axis="0 1 0"
           carrier="c" preload="20">
           <Sheave on="c" point="1 0 1.5" radius="0.3"/></ElasticRope>)",
      "0.8", R"(<Revolute between="c d" at="0 0 1" axis="0 1 0"/>)"));
  const auto sums = [&](const State& at) {
    Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
    for (const auto& [name, mass, inertia] :
         {std::tuple{"c", 3.0, 0.5}, {"d", 1.0, 0.2}, {"b", 2.0, 0.1}}) {
      const auto of = [&](const char* part) {
        return Vec3(scene.signal(at, std::string(name) + "." + part + "x"),
                    scene.signal(at, std::string(name) + "." + part + "y"),
                    scene.signal(at, std::string(name) + "." + part + "z"));
      };
      const Vec3 p = mass * of("v");
      const Vec3 r(scene.signal(at, std::string(name) + ".x"),
                   scene.signal(at, std::string(name) + ".y"),
                   scene.signal(at, std::string(name) + ".z"));
      out.head<3>() += p, out.tail<3>() += r.cross(p) + inertia * of("Omega_I_");
    }
    return out;
  };
  Simulation run(scene.model());
  const Eigen::Matrix<double, 6, 1> before = sums(run.state());
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  // Some 20 J and 5 kg m/s, in steps that add 1e-10 each. Without the moment of strands that lean the
  // energy is off by 1e-2 J.
  EXPECT_LT(std::abs(run.report().energy.discretisation), 1e-7);
  EXPECT_LT((sums(run.state()) - before).norm(), 1e-7);
  EXPECT_GT(std::abs(scene.signal(run.state(), "b.y") - 1.1), 0.05);
}

TEST(ElasticRope, SaysWhatIsMissing) {
  const std::string load = R"(<PlanarBody name="load" position="0 0 -3" mass="1" inertia="1"/>)";
  EXPECT_NE(
      errorOf(ropeScene(load, R"(<ElasticRope between="world load" EA="1" drumA="0.1"/>)", "1"))
          .find("add name="),
      std::string::npos);
  EXPECT_NE(errorOf(ropeScene(load, R"(<ElasticRope between="world world" EA="1"/>)", "1"))
                .find("nothing that moves"),
            std::string::npos);
  EXPECT_NE(errorOf(ropeScene(R"(<PointMass name="load" mass="1" position="0 0 -3"/>)",
                              R"(<ElasticRope between="world load" EA="1">
                                 <Sheave on="world" point="1 0 0" radius="0.2"/></ElasticRope>)",
                              "1"))
                .find("axis=\"0 1 0\""),
            std::string::npos);
  EXPECT_NE(errorOf(ropeScene(load, R"(<ElasticRope between="world load" EA="1">
                                 <Sheave on="world" point="0.1 0 0" radius="0.2"/></ElasticRope>)",
                              "1"))
                .find("no common tangent"),
            std::string::npos);
}

}  // namespace
}  // namespace dynamy
