// Trees of joints: the same mechanism in minimal and in absolute coordinates, and against numbers
// from outside.
#include <gtest/gtest.h>

#include <dynamy/testing/check_element.hpp>
#include <numbers>

#include "reference/located/located_run.hpp"
#include "support/bounded_run.hpp"

namespace dynamy::reference {
namespace {

/// `body` of a model in the coordinates wanted.
std::string model(const std::string& body, const std::string& coordinates) {
  return "<dynamy version=\"1\">" + body + "<simulation coordinates=\"" + coordinates +
         "\" until=\"1\" tolerance=\"1e-6\"/></dynamy>";
}

class Signals {
 public:
  Signals(const std::string& body, const std::string& coordinates, double tolerance, double until,
          const std::vector<std::string>& names)
      : run_(model(body, coordinates), tolerance, until) {
    run_.run();
    const State& x = run_.state();
    for (const std::string& name : names) {
      const NamedSignal* s = run_.model().signal(name);
      const SystemHandle& h = run_.model().topology().system(s->system);
      values.push_back(
          s->signal.value({.t = x.t, .q = slice(x.q, h.q0, h.nq), .u = slice(x.u, h.u0, h.nu)}));
    }
  }
  double energy() {
    MechanicalSystem s = run_.model().mechanicalSystem();
    const State& x = run_.state();
    return s.evaluate(x).mass.kineticEnergy(view(x.u)) + s.potentialEnergy(x);
  }
  std::vector<double> values;

 private:
  LocatedRun run_;
};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double out = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) out = std::max(out, std::abs(a[i] - b[i]));
  return out;
}

/// Both forms are consistent, so that they differ by the sum of their own errors. Each error is
/// measured by a run with a hundredth of the tolerance, worth 2 for what that run misses itself.
void expectSameMotion(const std::string& body, double until, const std::vector<std::string>& names,
                      double atMost) {
  constexpr double kTolerance = 1e-9;
  const Signals minimal(body, "minimal", kTolerance, until, names),
      absolute(body, "absolute", kTolerance, until, names),
      tightMinimal(body, "minimal", 1e-2 * kTolerance, until, names),
      tightAbsolute(body, "absolute", 1e-2 * kTolerance, until, names);
  const double bound = 2.0 * (distance(minimal.values, tightMinimal.values) +
                              distance(absolute.values, tightAbsolute.values));
  ASSERT_FALSE(minimal.values.empty());
  EXPECT_LE(distance(minimal.values, absolute.values), bound);
  EXPECT_LE(bound, atMost);  // the comparison says something
}

const char* const kRods = R"(
  <systems>
    <PlanarBody name="upper" position="0.5 0 0" mass="1" inertia="{1/12}"/>
    <PlanarBody name="lower" position="1.5 0 0" mass="1" inertia="{1/12}"/>
    <Ground name="world"/>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements>
    <Revolute name="top" between="world upper" at="0 0 0"/>
    <Revolute name="middle" between="upper lower" at="1 0 0"/>
  </elements>)";

TEST(Trees, SwingTwoRodsAsTaylorSeriesDo) {
  // Angles from straight down after 2 s: Lagrange's equations as Taylor series of order 20 in 25
  // digits (bench/work_precision). At 1e-12 the error is about a hundred tolerances of angles of
  // size 1 (measured 3e-13 and 2e-12 at 1e-11 … 1e-12).
  const Signals s(kRods, "minimal", 1e-12, 2.0, {"upper.phi", "lower.phi"});
  const double a = -0.08275830682057325, b = 0.4073620749119121;
  EXPECT_NEAR(s.values[0], a - std::numbers::pi / 2, 1e-10);
  EXPECT_NEAR(s.values[1], b - std::numbers::pi / 2, 1e-10);
}

TEST(Trees, SwingTwoRodsAsInAbsoluteCoordinates) {
  expectSameMotion(kRods, 1.0, {"upper.phi", "lower.x", "lower.omega"}, 1e-6);
}

TEST(Trees, TurnAHeavyTopOnABallJointAsEulerAnglesDo) {
  // 1 kg at 0.5 m from the foot, 0.5 and 0.6 kg m² about the centre of mass; about the foot 0.75.
  // Spin 10 rad/s, 30° from the vertical, axis at rest. Lagrange's equations in Euler angles are
  // the second formulation; the precession is turned back after some nutations.
  const std::string body = R"(
    <systems>
      <RigidBody name="top" position="0 {-0.5*sin(pi/6)} {0.5*cos(pi/6)}" euler="{pi/6} 0 0" mass="1"
                 inertia="0.5 0.5 0.6" angularVelocity="0 0 10"/>
      <Ground name="world"/>
    </systems>
    <forces><Gravity acceleration="0 0 -9.81"/></forces>
    <elements><Spherical name="foot" between="world top" at="0 0 0"/></elements>)";
  const std::string angles = R"xml(
    <systems>
      <Coordinates name="top" q="phi theta psi" units="rad rad rad" q0="0 {pi/6} 0" u0="0 0 10"
                   kineticEnergy="0.375*(theta_dot^2 + (phi_dot*sin(theta))^2) + 0.3*(psi_dot + phi_dot*cos(theta))^2"
                   potential="4.905*cos(theta)"/>
    </systems>)xml";
  const Signals a(angles, "absolute", 1e-12, 2.0, {"top.phi", "top.theta"}),
      s(body, "minimal", 1e-12, 2.0, {"top.x", "top.y", "top.z"});
  const double phi = a.values[0], theta = a.values[1];
  // A hundred times 1e-12 of angles up to 20 rad (the spin).
  EXPECT_NEAR(s.values[0], 0.5 * std::sin(theta) * std::sin(phi), 2e-9);
  EXPECT_NEAR(s.values[1], -0.5 * std::sin(theta) * std::cos(phi), 2e-9);
  EXPECT_NEAR(s.values[2], 0.5 * std::cos(theta), 2e-9);
}

TEST(Trees, MoveAChainOfBallJointsAsInAbsoluteCoordinates) {
  // 18 velocities: M⁻¹ by articulated bodies.
  const std::string chain = R"(
    <systems>
      <replicate count="6">
        <RigidBody name="link" position="{0.1*i + 0.05} 0 0" velocity="0 {0.1*i + 0.05} 0" angularVelocity="3 0 1"
                   mass="0.2" inertia="1e-4 2e-4 2.5e-4"/>
      </replicate>
      <Ground name="world"/>
    </systems>
    <forces><Gravity/></forces>
    <elements>
      <Spherical name="hook" between="world link[0]" at="0 0 0"/>
      <replicate count="5"><Spherical name="ball" between="link[{i}] link[{i+1}]" at="{0.1*(i+1)} 0 0"/></replicate>
    </elements>)";
  expectSameMotion(chain, 0.3,
                   {"link[5].x", "link[5].y", "link[5].z", "link[1].Omega_x", "link[2].qw"}, 1e-5);
}

/// A body on a joint to the world, `joint` with its attributes, and a rod that hangs from the body.
std::string onJoint(const std::string& joint) {
  return R"(
    <systems>
      <RigidBody name="first" position="0.3 0.1 -0.2" mass="1" inertia="0.02 0.03 0.04"/>
      <RigidBody name="second" position="0.6 0.1 -0.5" mass="0.5" inertia="0.01 0.01 0.002"/>
      <Ground name="world"/>
    </systems>
    <forces><Gravity acceleration="0 0 -9.81"/></forces>
    <elements>)" +
         joint + R"(<Spherical name="s" between="first second" at="0.6 0.1 -0.2"/></elements>)";
}

TEST(Trees, MoveUniversalCylindricalScrewAndPlanarJointsAsInAbsoluteCoordinates) {
  const std::string between = R"( name="j" between="world first" at="0 0 0" )";
  for (const char* joint :
       {R"(<Universal axis="0 1 0" axisB="0.6 0 0.8")", R"(<Cylindrical axis="0.6 0 0.8")",
        R"(<Screw axis="0.6 0 0.8" pitch="0.4")", R"(<PlanarJoint axis="0.6 0 0.8")"}) {
    SCOPED_TRACE(joint);
    expectSameMotion(onJoint(joint + between + "/>"), 0.5,
                     {"first.x", "first.y", "first.z", "second.x", "second.y", "second.z"}, 1e-6);
  }
}

TEST(Trees, RunDownAScrewWithConstantAcceleration) {
  // s = p phi/2 pi: (m + J (2 pi/p)^2) s'' = m g. The end is 0.6 m below the start; every step is
  // exact but for rounding, of some 1e3 steps at most.
  const std::string body = R"(
    <systems>
      <RigidBody name="nut" mass="2" inertia="0.01 0.01 0.004"/>
      <Ground name="world"/>
    </systems>
    <forces><Gravity acceleration="0 0 -9.81"/></forces>
    <elements><Screw name="j" between="world nut" axis="0 0 1" pitch="0.3"/></elements>)";
  const double turns = 2.0 * std::numbers::pi / 0.3, a = 2.0 * 9.81 / (2.0 + 0.004 * turns * turns);
  const Signals s(body, "minimal", 1e-10, 0.4, {"nut.z", "nut.vz", "nut.Omega_z"});
  EXPECT_NEAR(s.values[0], -a * 0.4 * 0.4 / 2.0, 1e-11);
  EXPECT_NEAR(s.values[1], -a * 0.4, 1e-11);
  EXPECT_NEAR(s.values[2], -a * 0.4 * turns, 1e-10);
}

TEST(Trees, SlideDownAPlaneAndTurnAsAFreePuckDoes) {
  // A plane inclined by 30 degrees about y: g sin(30) along it; the turn about its normal stays.
  const std::string body = R"(
    <systems>
      <RigidBody name="puck" mass="2" inertia="0.01 0.01 0.02" euler="0 {pi/6} 0" angularVelocity="0 0 3"/>
      <Ground name="world"/>
    </systems>
    <forces><Gravity acceleration="0 0 -9.81"/></forces>
    <elements><PlanarJoint name="j" between="world puck" axis="{sin(pi/6)} 0 {cos(pi/6)}"/></elements>)";
  const double way = 9.81 * 0.5 * 0.16 / 2.0;  // g sin(30) t^2/2 at 0.4 s, rounding as above
  const Signals s(body, "minimal", 1e-10, 0.4, {"puck.x", "puck.y", "puck.z", "puck.Omega_z"});
  EXPECT_NEAR(s.values[0], way * std::cos(std::numbers::pi / 6), 1e-11);
  EXPECT_NEAR(s.values[1], 0.0, 1e-11);
  EXPECT_NEAR(s.values[2], -way / 2.0, 1e-11);
  EXPECT_NEAR(s.values[3], 3.0, 1e-11);
}

TEST(Trees, MoveASliderCrankAsInAbsoluteCoordinates) {
  // A loop: the slider's hinge or its guide closes it.
  const std::string crank = R"(
    <systems>
      <PlanarBody name="crank" position="0.1 0 0" velocity="0 0 2" angularVelocity="20" mass="0.3" inertia="1e-3"/>
      <PlanarBody name="rod" position="0.4 0 0" velocity="0 0 2" angularVelocity="-10" mass="0.2" inertia="4e-3"/>
      <PlanarBody name="slider" position="0.6 0 0" mass="0.5" inertia="1e-3"/>
      <Ground name="world"/>
    </systems>
    <forces><Gravity/></forces>
    <elements>
      <Revolute name="A" between="world crank" at="0 0 0"/>
      <Revolute name="B" between="crank rod" at="0.2 0 0"/>
      <Revolute name="C" between="rod slider" at="0.6 0 0"/>
      <Prismatic name="guide" between="world slider" axis="1 0 0"/>
    </elements>)";
  expectSameMotion(crank, 0.3, {"crank.phi", "slider.x", "slider.vx", "rod.omega"}, 1e-5);
}

/// A chain of three links with balls at their ends, the last one on the floor and near the first.
std::string touching(const std::string& law, const std::string& plane) {
  const bool planar = !plane.empty();
  const std::string body = planar ? "PlanarBody" : "RigidBody";
  std::string out = "<systems>";
  const char* const at[] = {"0 0 0.5", "0.3 0 0.5", "0.2 0 0.1"};
  for (int i = 0; i < 3; ++i)
    out += "<" + body + " name=\"b" + std::to_string(i) + "\" position=\"" + at[i] + "\" " +
           (planar ? "plane=\"xz\" " : "") + "><Sphere radius=\"" + (i == 2 ? "0.1" : "0.05") +
           "\" mass=\"1\" material=\"m" + std::to_string(i) + "\"/></" + body + ">";
  out += R"(<Ground name="world"><HalfSpace material="floor"/></Ground></systems>
    <forces><Gravity/></forces>
    <elements>
      <Spherical between="world b0" at="-0.2 0 0.5"/>
      <Spherical between="b0 b1" at="0.1 0 0.5"/>
      <Spherical between="b1 b2" at="0.3 0 0.3"/>
      <NoContact between="m0 m1"/><NoContact between="m1 m2"/><NoContact between="m0 floor"/>
      <NoContact between="m1 floor"/>)";
  return out + "<Contact between=\"m0 m2\">" + law + "</Contact><Contact between=\"m2 floor\">" +
         law + "</Contact></elements>";
}

int closedRows(LocatedRun& run) {
  MechanicalSystem s = run.model().mechanicalSystem();
  return s.evaluate(run.model().initialState()).contacts.rows();
}

TEST(Trees, HaveTheContactsOfTheirBodies) {
  // One row without friction, two in a plane, three in space; every entry of W, χ and the bias as
  // differences say, also between two bodies of one tree.
  const std::string slippery = "<Unilateral epsilonN=\"0\"/>",
                    rough = "<UnilateralCoulomb epsilonN=\"0\" mu=\"0.3\"/>";
  const auto rows = [](const std::string& body) {
    LocatedRun run(model(body, "minimal"), 1e-6, 1.0);
    const Verdict check = checkContacts(run.model());
    EXPECT_TRUE(check) << check.message();
    return closedRows(run);
  };
  EXPECT_EQ(rows(touching(slippery, "xz")), 1);
  EXPECT_EQ(rows(touching(rough, "xz")), 2);
  EXPECT_EQ(rows(touching(slippery, "")), 1);
  EXPECT_EQ(rows(touching(rough, "")), 3);
}

TEST(Trees, KeepTheEnergyOfATreeToItsTolerance) {
  // Two rods from rest at the height 0: T + V = 0. The energy of 9.81·2 J moves with the error of
  // the angles, at 1e-12 about a hundred tolerances.
  Signals s(kRods, "minimal", 1e-12, 5.0, {"upper.phi"});
  EXPECT_NEAR(s.energy(), 0.0, 100.0 * 1e-12 * 19.62);
}

TEST(Trees, TurnLooselyInFixedStepsWithErrorsOfSecondOrder) {
  // Three bodies at a ball joint and a hinge, turning with up to 40 rad/s. Nothing acts on them: T
  // is kept up to c Δt² of the mean velocity (39.8). With h at the velocity of the start it grew
  // by 186 J of 105.
  const auto change = [](double step) {
    BoundedRun run(R"xml(<dynamy version="1"><systems>
      <RigidBody name="a" mass="1" inertia="0.1 0.2 0.3" angularVelocity="3 40 1"/>
      <RigidBody name="b" mass="2" inertia="0.2 0.1 0.3" position="1 0 0" angularVelocity="1 2 1"/>
      <RigidBody name="c" mass="1" inertia="0.1 0.2 0.3" position="1 1 0" velocity="0 0 3"/>
      </systems><elements><Spherical between="a b" at="0.5 0 0"/>
      <Revolute between="b c" at="1 0.5 0" axis="1 0 0"/></elements>
      <simulation coordinates="minimal" until="2" step="1e-3"><StaggeredMoreau/></simulation>
      </dynamy>)xml",
                   {.step = step});
    run.run();
    EXPECT_TRUE(run.finished());
    return run.report().energy.kineticEnd - run.report().energy.kineticStart;
  };
  const double coarse = change(2e-3), fine = change(1e-3);
  // Δt·40 rad/s = 0.08: errors of third order are a tenth of those of second order, on each side.
  EXPECT_NEAR(coarse / fine, 4.0, 0.4);
  // (40 rad/s Δt)² = 6e-3 of T at most in 1000 steps that turn to and fro; a sixth of it.
  EXPECT_LT(std::abs(coarse), 1e-3 * 105.0);
}

}  // namespace
}  // namespace dynamy::reference
