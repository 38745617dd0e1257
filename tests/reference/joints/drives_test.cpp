/// Gears, racks, ropes, drives, motors and controllers in joints against closed forms.
#include <gtest/gtest.h>

#include <reference/joints/joint_scene.hpp>
#include <reference/located/located_run.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

const char* const kSchemes[] = {"<EnergyMomentum/>", "<StaggeredMoreau/>", "<MoreauMidpoint/>"};

/// Steps as the program does: elements remember what they need.
void run(Scene& s, double t, double dt) {
  s.run(t, dt, [&] { s.system().remember(s.state()); });
  EXPECT_TRUE(s.solved());
}

/// A wheel in the x-y plane in a bearing.
std::string wheel(const std::string& name, double J, double x = 0.0) {
  return "<PlanarBody name=\"" + name + "\" plane=\"xy\" mass=\"1\" inertia=\"" +
         std::to_string(J) + "\" position=\"" + std::to_string(x) + " 0 0\"/>";
}
std::string bearing(const std::string& name, const std::string& of = "world") {
  return "<Revolute between=\"" + of + ' ' + name + "\"/>";
}

// Constant accelerations are met exactly by every scheme here: rounding and the solver's 1e-10 a
// step in the velocities, 100 steps.
constexpr double kExact = 1e-7;

TEST(Gear, TurnsBothWheelsByTheReducedInertia) {
  // φ_A = i φ_B:  (J_A + J_B/i²) φ̈_A = M. In 1 s the wheel A turns more than twice.
  const double i = -2.5, a = 3.0 / (0.02 + 0.5 / (i * i));
  for (const char* scheme : kSchemes) {
    SCOPED_TRACE(scheme);
    Scene s("gear",
            {.text = jointScene(wheel("a", 0.02) + wheel("b", 0.5, 1.0),
                                "<ForceInput on=\"a\" moment=\"0; 0; 3\"/>",
                                bearing("a") + bearing("b") +
                                    "<Gear between=\"a b\" carrier=\"world\" ratio=\"-2.5\"/>",
                                scheme)});
    run(s, 1.0, 1e-2);
    EXPECT_NEAR(s.u("a")[2], a, kExact * a);
    EXPECT_NEAR(s.q("a")[2], 0.5 * a, kExact * a);
    EXPECT_NEAR(s.q("b")[2], 0.5 * a / i, kExact * a);
  }
}

TEST(Gear, WithBevelWheelsTurnsAboutTwoAxes) {
  const double i = 0.5, a = 1.0 / (0.1 + 0.3 / (i * i));
  Scene s("bevel", {.text = jointScene(
                        "<RigidBody name=\"a\" mass=\"1\" inertia=\"0.1 0.2 0.2\"/>"
                        "<RigidBody name=\"b\" mass=\"1\" inertia=\"0.2 0.2 0.3\" position=\"1 0 "
                        "1\"/>",
                        "<ForceInput on=\"a\" moment=\"1; 0; 0\"/>",
                        "<Revolute between=\"world a\" axis=\"1 0 0\"/><Revolute between=\"world "
                        "b\" axis=\"0 0 1\"/><Gear between=\"a b\" carrier=\"world\" "
                        "ratio=\"0.5\" axisA=\"1 0 0\" axisB=\"0 0 1\"/>")});
  run(s, 1.0, 1e-2);
  EXPECT_NEAR(s.u("a")[3], a, kExact);
  EXPECT_NEAR(s.u("b")[5], a / i, kExact);
}

TEST(Gear, OnACarrierIsAPlanetaryGear) {
  // Willis: ω_S − ω_C = i (ω_R − ω_C). With J u̇ = h + wλ, w = (1, −i, i − 1): λ = −w·J⁻¹h/wᵀJ⁻¹w.
  const Vec3 J(0.02, 0.3, 0.1), w(1.0, 3.0, -4.0), h(1.0, 0.0, 0.5);
  const Vec3 free = h.cwiseQuotient(J);
  const Vec3 a = free - w.dot(free) / w.dot(w.cwiseQuotient(J)) * w.cwiseQuotient(J);
  for (const char* scheme : kSchemes) {
    SCOPED_TRACE(scheme);
    Scene s("willis",
            {.text = jointScene(wheel("sun", J[0]) + wheel("ring", J[1]) + wheel("arm", J[2]),
                                "<ForceInput on=\"sun\" moment=\"0; 0; 1\"/><ForceInput on=\"arm\" "
                                "moment=\"0; 0; 0.5\"/>",
                                bearing("sun") + bearing("ring") + bearing("arm") +
                                    "<Gear between=\"sun ring\" carrier=\"arm\" ratio=\"-3\"/>",
                                scheme)});
    run(s, 1.0, 1e-2);
    const double angles[] = {s.q("sun")[2], s.q("ring")[2], s.q("arm")[2]};
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(angles[k], 0.5 * a[k], kExact * a.norm()) << k;
  }
}

TEST(RackAndPinion, MovesTheRackByTheReducedMass) {
  // z = r φ:  (m + J/r²) z̈ = F, several turns.
  const double r = -0.05, a = 4.0 / (2.0 + 0.01 / (r * r));
  for (const char* scheme : kSchemes) {
    SCOPED_TRACE(scheme);
    Scene s("rack",
            {.text = jointScene(
                 wheel("pinion", 0.01) +
                     "<PlanarBody name=\"rack\" plane=\"xy\" mass=\"2\" inertia=\"1\" "
                     "position=\"0 -0.05 0\"/>",
                 "<ForceInput on=\"rack\" force=\"4; 0; 0\"/>",
                 bearing("pinion") + "<Prismatic between=\"world rack\" axis=\"1 0 0\"/>"
                                     "<RackAndPinion between=\"pinion rack\" carrier=\"world\" "
                                     "radius=\"-0.05\" direction=\"1 0 0\"/>",
                 scheme)});
    run(s, 1.0, 1e-2);
    EXPECT_NEAR(s.q("rack")[0], 0.5 * a, kExact);
    EXPECT_NEAR(s.q("pinion")[2], 0.5 * a / r, kExact / std::abs(r));
  }
}

TEST(Rope, OfAtwoodsMachineAcceleratesBothMasses) {
  const double g = 9.81, a = g * (3.0 - 2.0) / (3.0 + 2.0);
  for (const char* scheme : kSchemes) {
    SCOPED_TRACE(scheme);
    Scene s("atwood",
            {.text = jointScene("<PointMass name=\"a\" mass=\"2\" position=\"-1 0 0\"/>"
                                "<PointMass name=\"b\" mass=\"3\" position=\"1 0 1\"/>",
                                "<Gravity/>",
                                "<Rope through=\"a world world b\" points=\"0 0 0  -1 0 9  1 "
                                "0 9  0 0 0\"/>",
                                scheme)});
    run(s, 1.0, 1e-2);
    EXPECT_NEAR(s.q("a")[2], 0.5 * a, kExact);
    EXPECT_NEAR(s.q("b")[2], 1.0 - 0.5 * a, kExact);
    // The tension, Λ/Δt of the last step.
    EXPECT_NEAR(s.Lambda()[0] / 1e-2, 2.0 * (g + a), kExact * 100.0);
  }
}

TEST(Rope, ThroughAMovingPulleyPullsTwice) {
  // l1 + 2 l2 = L:  T = 3 m1 m2 g/(4 m1 + m2) on m1, 2T on m2.
  const double g = 9.81, m1 = 2.0, m2 = 3.0, T = 3.0 * m1 * m2 * g / (4.0 * m1 + m2);
  Scene s("tackle",
          {.text = jointScene("<PointMass name=\"a\" mass=\"2\" position=\"-1 0 5\"/>"
                              "<PointMass name=\"b\" mass=\"3\" position=\"0 0 1\"/>",
                              "<Gravity/>",
                              "<Rope through=\"a world world b world\" points=\"0 0 0  -1 0 9 "
                              " 0 0 9  0 0 0  0 0 9\"/>")});
  run(s, 1.0, 1e-2);
  EXPECT_NEAR(s.q("a")[2] - 5.0, 0.5 * (T / m1 - g), kExact);
  EXPECT_NEAR(s.q("b")[2] - 1.0, 0.5 * (2.0 * T / m2 - g), kExact);
}

TEST(Rope, GoesSlackAndTaut) {
  // Thrown up at 2 m/s from the taut rope: back at t = 2v/g, then held.
  Scene s("tether",
          {.text = jointScene("<PointMass name=\"a\" mass=\"2\" position=\"0 0 -1\" "
                              "velocity=\"0 0 2\"/>",
                              "<Gravity/>", "<Rope through=\"world a\"><Unilateral/></Rope>")});
  run(s, 0.2, 1e-3);
  EXPECT_NEAR(s.q("a")[2], -1.0 + 0.4 - 0.5 * 9.81 * 0.04, 1e-9);
  run(s, 1.0, 1e-3);
  EXPECT_NEAR(s.q("a")[2], -1.0, 2.0 * 1e-3);  // way of one step at the impact
  EXPECT_NEAR(s.u("a")[2], 0.0, 1e-9);
}

TEST(JointDrive, NeedsTheMomentOfTheMotion) {
  // φ = 0.8 sin²(2t):  M = (J + m l²) φ̈ + m g l cos φ, at the middle of the step.
  const double m = 2.0, l = 0.4, J = 0.1, g = 9.81;
  for (const auto& [scheme, tolerance] :
       {std::pair{"<EnergyMomentum/>", 1e-4}, std::pair{"<StaggeredMoreau/>", 5e-3}}) {
    SCOPED_TRACE(scheme);
    Scene s("arm",
            {.text = jointScene("<PlanarBody name=\"arm\" plane=\"xy\" mass=\"2\" "
                                "inertia=\"0.1\" position=\"0.4 0 0\"/>",
                                "<Gravity acceleration=\"0 -9.81 0\"/>",
                                "<JointDrive between=\"world arm\" motion=\"0.8*sin(2*t)^2\"/>"
                                "<Revolute between=\"world arm\" at=\"0 0 0\"/>",
                                scheme)});
    constexpr double dt = 1e-3;
    run(s, 1.0, dt);
    const double t = 1.0 - 0.5 * dt, phi = 0.8 * std::sin(2.0 * t) * std::sin(2.0 * t),
                 phiDDot = 0.8 * 8.0 * std::cos(4.0 * t);
    const double M = (J + m * l * l) * phiDDot + m * g * l * std::cos(phi);
    EXPECT_NEAR(s.q("arm")[2], 0.8 * std::sin(2.0) * std::sin(2.0), 1e-5);
    // Second order in Δt: (4 rad/s Δt)²/24 of the 3 N m of φ̈ and what the arm is off; staggered
    // steps hold velocities at their ends: half a step of dM/dt = 8 N m/s.
    EXPECT_NEAR(s.Lambda()[0] / dt, M, tolerance);
  }
}

TEST(JointMotor, RunsUpAtItsLimitAndHoldsItsSpeed) {
  Scene s("motor",
          {.text = jointScene(
               wheel("a", 0.5), "",
               bearing("a") + "<JointMotor between=\"world a\" speed=\"6\" limit=\"2\"/>")});
  run(s, 1.0, 1e-2);
  EXPECT_NEAR(s.u("a")[2], 4.0, kExact);  // M t/J
  EXPECT_NEAR(s.q("a")[2], 2.0, kExact);
  run(s, 2.0, 1e-2);
  EXPECT_NEAR(s.u("a")[2], 6.0, kExact);  // at 1.5 s
  EXPECT_NEAR(s.q("a")[2], 4.5 + 3.0, kExact);
}

TEST(JointFriction, StopsTheWheelAndHoldsIt) {
  Scene s("brake",
          {.text = jointScene("<PlanarBody name=\"a\" plane=\"xy\" mass=\"1\" inertia=\"0.5\" "
                              "angularVelocity=\"2\"/>",
                              "",
                              bearing("a") + "<JointFriction between=\"world a\"><GivenFriction "
                                             "force=\"2\"/></JointFriction>")});
  run(s, 1.0, 1e-2);  // stops at Jω/M = 0.5 s, after ω²J/2M = 0.5
  EXPECT_NEAR(s.q("a")[2], 0.5, kExact);
  EXPECT_NEAR(s.u("a")[2], 0.0, 1e-10);
}

/// Two wheels in bearings, the first at 10 rad/s, the second loaded with 0.1 N m; what couples
/// them.
std::string coupled(const std::string& law) {
  return jointScene(
      "<PlanarBody name=\"a\" plane=\"xy\" mass=\"1\" inertia=\"0.2\" angularVelocity=\"10\"/>" +
          wheel("b", 0.3),
      "<ForceInput on=\"b\" moment=\"0; 0; -0.1\"/>",
      bearing("a") + bearing("b") + "<JointFriction name=\"clutch\" between=\"a b\">" + law +
          "</JointFriction>");
}

TEST(TorqueLimitedClutch, TakesASecondWheelAlong) {
  // It slips with M = 1.5 N m: ω_a = 10 − M t/J_a, ω_b = (M − 0.1) t/J_b, equal at t_s; then both
  // turn as one wheel of J_a + J_b, and the clutch passes on a share of the load to the first. What
  // slip takes is M φ, φ = 10 t_s/2.
  constexpr double Ja = 0.2, Jb = 0.3, M = 1.5, load = -0.1;
  const double ts = 10.0 / (M / Ja + (M + load) / Jb), end = 1.0;
  const double together = 10.0 - M * ts / Ja + load / (Ja + Jb) * (end - ts);
  for (const char* law :
       {"<ForceLimit lower=\"-1.5\" upper=\"1.5\"/>", "<GivenFriction force=\"1.5\"/>",
        "<OneWayClutch free=\"positive\" limit=\"1.5\"/>"}) {
    SCOPED_TRACE(law);
    LocatedRun run(coupled(law), 1e-10, end);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    const Eigen::VectorXd &q = run.state().q, &u = run.state().u;
    // Constant forces, one switch: the tolerance of the run with room for two phases.
    EXPECT_NEAR(u[2], together, 1e-9);
    EXPECT_NEAR(u[5], together, 1e-9);
    const double slip = q[2] - q[5];
    EXPECT_NEAR(slip, 5.0 * ts, 1e-9);
    const double T = 0.5 * (Ja * u[2] * u[2] + Jb * u[5] * u[5]);
    EXPECT_NEAR(T, 0.5 * Ja * 100.0 + load * q[5] - M * slip, 1e-8);
  }
}

TEST(TorqueLimitedClutch, OfOneWayLetsTheOtherRunAhead) {
  // The first wheel may run ahead: the load is the second's own.
  const std::string text = coupled("<OneWayClutch free=\"negative\" limit=\"1.5\"/>");
  LocatedRun run(text, 1e-10, 1.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_NEAR(run.state().u[2], 10.0, 1e-9);
  EXPECT_NEAR(run.state().u[5], -0.1 / 0.3, 1e-9);
}

TEST(JointStop, ReflectsTheRate) {
  const std::string text = jointScene(
      "<PlanarBody name=\"a\" plane=\"xy\" mass=\"1\" inertia=\"0.5\" "
      "angularVelocity=\"5\"/>",
      "",
      bearing("a") +
          "<JointStop name=\"stop\" between=\"world a\" start=\"1\" "
          "lower=\"-3\" upper=\"9\"><Unilateral "
          "epsilonN=\"0.6\"/></JointStop>");
  // Beyond a whole turn: 8 rad at 5 rad/s, 12 rad back at 3 rad/s, then 1.8 rad/s.
  LocatedRun located(text, 1e-9, 6.0);
  located.run();
  ASSERT_EQ(located.impacts("stop.upper").size(), 1U);
  EXPECT_NEAR(located.impacts("stop.upper")[0], 1.6, 1e-8);
  EXPECT_NEAR(located.state().q[2], -4.0 + 0.4 * 1.8, 1e-8);  // off the lower stop since 5.6 s
  EXPECT_NEAR(located.state().u[2], 1.8, 1e-8);
}

/// Damped oscillation from x = 0 to a constant target, J = 0.5, c = 50, d = 1.
double oscillation(double t) {
  const double delta = 1.0, omega = std::sqrt(100.0 - 1.0);
  return 1.0 - std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t));
}

TEST(PdController, IsADampedOscillator) {
  const std::string elements = bearing("a");
  for (const char* force :
       {"<PdController between=\"world a\" target=\"1\" stiffness=\"50\" damping=\"1\"/>",
        "<JointSpring between=\"world a\" rest=\"1\" stiffness=\"50\" damping=\"1\"/>",
        "<JointForce between=\"world a\" force=\"50*(1-x)-v\"/>"}) {
    SCOPED_TRACE(force);
    Scene s("pd", {.text = jointScene(wheel("a", 0.5), force, elements, "<StaggeredMoreau/>")});
    run(s, 1.0, 1e-3);
    // The damper at the beginning of a step acts as dΔt/2 less of inertia: ω dΔt/4J = 5e-3 rad of
    // phase in 1 s, times the amplitude e^-1.
    EXPECT_NEAR(s.q("a")[2], oscillation(1.0), 2e-3);
    LocatedRun located(jointScene(wheel("a", 0.5), force, elements), 1e-10, 1.0);
    located.run();
    EXPECT_NEAR(located.state().q[2], oscillation(1.0), 1e-8);
  }
}

TEST(PdController, WithHighGainsIsTakenImplicitly) {
  // ωΔt = 4.5: beyond what explicit steps bear. The implicit midpoint rule takes 0.33 of the slow
  // and 0.82 of the fast part from step to step.
  for (const char* force : {"<PdController between=\"world a\" target=\"1\" stiffness=\"1e5\" "
                            "damping=\"1e3\" stiff=\"true\"/>",
                            "<JointForce between=\"world a\" force=\"1e5*(1-x)-1e3*v\" "
                            "stiff=\"true\"/>"}) {
    Scene s("pd", {.text = jointScene(wheel("a", 0.5), force, bearing("a"), "<StaggeredMoreau/>")});
    run(s, 3.0, 1e-2);
    EXPECT_NEAR(s.q("a")[2], 1.0, 1e-6);
  }
}

TEST(PdController, IsCutOffAtItsLimit) {
  Scene s("pd", {.text = jointScene(
                     wheel("a", 0.5),
                     "<PdController between=\"world a\" target=\"100rad\" stiffness=\"50\" "
                     "limit=\"2\"/>",
                     bearing("a"))});
  run(s, 1.0, 1e-2);
  EXPECT_NEAR(s.q("a")[2], 0.5 * 2.0 / 0.5, kExact);
}

TEST(JointForce, OfQuadraticDragSlowsByItsLaw) {
  // J ω̇ = −k ω²:  φ = (J/k) ln(1 + k ω0 t/J), located runs to their tolerance.
  LocatedRun located(
      jointScene("<PlanarBody name=\"a\" plane=\"xy\" mass=\"1\" inertia=\"0.5\" "
                 "angularVelocity=\"20\"/>",
                 "<JointForce between=\"world a\" force=\"-0.1*v*abs(v)\"/>", bearing("a")),
      1e-10, 2.0);
  located.run();
  EXPECT_NEAR(located.state().q[2], 5.0 * std::log(1.0 + 0.1 * 20.0 * 2.0 / 0.5), 1e-7);
}

TEST(Couplings, RunToATolerance) {
  // Gear and rope in smooth phases of high order.
  const double a = 3.0 / (0.02 + 0.5 / 6.25);
  LocatedRun gear(
      jointScene(
          wheel("a", 0.02) + wheel("b", 0.5, 1.0), "<ForceInput on=\"a\" moment=\"0; 0; 3\"/>",
          bearing("a") + bearing("b") + "<Gear between=\"a b\" carrier=\"world\" ratio=\"-2.5\"/>"),
      1e-9, 1.0);
  gear.run();
  EXPECT_NEAR(gear.state().q[2], 0.5 * a, 1e-7 * a);
  EXPECT_NEAR(gear.state().q[5], -0.2 * a, 1e-7 * a);
  LocatedRun rope(jointScene("<PointMass name=\"a\" mass=\"2\" position=\"-1 0 0\"/>"
                             "<PointMass name=\"b\" mass=\"3\" position=\"1 0 1\"/>",
                             "<Gravity/>",
                             "<Rope through=\"a world world b\" points=\"0 0 0  -1 0 9  1 0 9  0 0 "
                             "0\"/>"),
                  1e-9, 1.0);
  rope.run();
  EXPECT_NEAR(rope.state().q[2], 0.5 * 9.81 / 5.0, 1e-8);
}

}  // namespace
}  // namespace dynamy::reference
