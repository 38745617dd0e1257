/// Known defects of joints: in impacts, in minimal coordinates, in the energy ledger.
#include <gtest/gtest.h>

#include <cmath>
#include <support/bounded_run.hpp>

namespace dynamy::defects {
namespace {

// ---- an impact of a jointed body ---------------------------------------------------------------

/// A rod of 1 kg and 1 m on a hinge at one end meets a wall with its tip, at rest but for 1 rad/s.
constexpr const char* kRodAndWall = R"(<dynamy version="1"><systems>
<PlanarBody name="rod" position="0.5 0 0" mass="1" inertia="{1/12}" velocity="0 0 -0.5" angularVelocity="-1"><Point position="0.5 0 0" material="steel"/></PlanarBody>
<Ground name="world"><HalfSpace position="0 0 -0.1" material="wall"/></Ground></systems>
<elements><Revolute name="h" between="world rod" at="0 0 0"/><Contact between="steel wall"><Unilateral/></Contact></elements>
<simulation until="0.2" step="1e-3"/><record signals="rod.omega" every="1e-3" frames="0"/></dynamy>)";

TEST(KnownDefects, AnImpactOfAJointedBodyWithoutReboundIsOneImpact) {
  BoundedRun rod(kRodAndWall);
  rod.run();
  ASSERT_TRUE(rod.finished()) << rod.report().reason;
  knownDefect("jointed_impact_in_parts", [&] {
    EXPECT_EQ(rod.report().contacts.impacts, 1);
    ASSERT_FALSE(rod.events().empty());
    double largest = 0.0;
    for (const ContactEvent& e : rod.events())
      if (e.impact) largest = std::max(largest, e.impulse);
    // (1/12 + 1/4) kg m² · 1 rad/s at an arm cos φ of 1 m, sin φ = 0.1: 0.33501 N s; where in the
    // step the wall is met changes φ by Δt, the arm by 0.1 Δt.
    EXPECT_NEAR(largest, 1.0 / 3.0 / std::cos(std::asin(0.1)), 1e-4);
  });
}

// ---- the ledger of a motor ---------------------------------------------------------------------

TEST(KnownDefects, AJointMotorIsNoFriction) {
  // A flywheel of 0.1 kg m² is brought to 10 rad/s by a motor of at most 2 N m; nothing rubs, and
  // nothing but the motor does work: J ω²/2 = 5 J.
  BoundedRun motor(R"(<dynamy version="1"><systems><Ground name="world"/>
<PlanarBody name="wheel" mass="1" inertia="0.1"/></systems>
<elements><Revolute between="world wheel"/><JointMotor between="world wheel" speed="10" limit="2"/></elements>
<simulation until="1" step="1e-3"/><record signals="wheel.omega" every="0.1" frames="0"/></dynamy>)");
  motor.run();
  ASSERT_TRUE(motor.finished()) << motor.report().reason;
  ASSERT_NEAR(motor.last(), 10.0, 1e-9);  // the limit is passed after half a second; rounding
  const EnergyReport& e = motor.report().energy;
  ASSERT_NEAR(e.works(), 5.0, 1e-9);
  EXPECT_EQ(e.friction, 0.0);
  EXPECT_EQ(e.boundaries, 0.0);  // the world stands still
  EXPECT_NEAR(e.nonPotential, 5.0, 1e-9);
}

// ---- minimal coordinates -----------------------------------------------------------------------

/// A heavy top on a ball joint: m = 1 kg, l = 0.5 m, J1 = 0.5 kg m² about the joint, J3 = 0.2; its
/// axis at 0.5 rad from the vertical, spin 40 rad/s, at rest otherwise.
std::string heavyTop(double until) {
  return R"(<dynamy version="1"><systems><Ground name="world"/>
<RigidBody name="top" position="{0.5*sin(0.5)} 0 {0.5*cos(0.5)}" euler="0 0.5 0" mass="1" inertia="0.25 0.25 0.2"
  angularVelocity="0 0 40"/></systems><forces><Gravity/></forces>
<elements><Spherical between="world top" at="0 0 0"/></elements>
<simulation until=")" +
         std::to_string(until) +
         R"(" tolerance="1e-8"/><record signals="top.x top.y top.z" frames="0"/></dynamy>)";
}

/// Place of the centre by Euler angles (Lagrange): θ'' from the two momenta that are kept,
/// φ' = (p_φ − p_ψ cos θ)/(J1 sin² θ); Runge and Kutta's method with 2^16 steps: 1e-13.
Vec3 heavyTopAt(double until) {
  constexpr double kJ1 = 0.5, kMgl = 9.81 * 0.5, kSpin = 0.2 * 40.0;
  const double c0 = std::cos(0.5), p = kSpin * c0;  // φ' = θ' = 0: p_ψ = J3 ω3, p_φ = p_ψ cos θ0
  using Y = Eigen::Vector3d;                        // θ, θ', φ
  const auto rate = [&](const Y& y) {
    const double s = std::sin(y[0]), c = std::cos(y[0]);
    const double a = p - kSpin * c, b = kSpin - p * c;
    return Y(y[1], kMgl * s / kJ1 - a * b / (kJ1 * kJ1 * s * s * s), a / (kJ1 * s * s));
  };
  Y y(0.5, 0.0, 0.0);
  constexpr int kSteps = 1 << 16;
  const double h = until / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const Y k1 = rate(y), k2 = rate(y + h / 2 * k1), k3 = rate(y + h / 2 * k2),
            k4 = rate(y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return 0.5 *
         Vec3(std::sin(y[0]) * std::cos(y[2]), std::sin(y[0]) * std::sin(y[2]), std::cos(y[0]));
}

TEST(KnownDefects, ABallJointInMinimalCoordinatesIsAsAccurateAsInAbsoluteOnes) {
  constexpr double kUntil = 4.0;  // ten nutations of J1/(J3 ω3) 2π = 0.39 s
  const Vec3 truth = heavyTopAt(kUntil);
  double error[2];
  for (const bool minimal : {false, true}) {
    BoundedRun top(heavyTop(kUntil), {.coordinates = minimal ? JointCoordinates::minimal
                                                             : JointCoordinates::absolute});
    top.run();
    ASSERT_TRUE(top.finished()) << top.report().reason;
    error[minimal] = (Vec3(top.last(0), top.last(1), top.last(2)) - truth).norm();
  }
  ASSERT_LT(error[0], 1e-6);  // a hundred tolerances: order and motion are right
  // With angular velocities in axes of the body itself it was off by 17 tolerances.
  EXPECT_LT(error[1], 3e-8);
  // The same motion to the same tolerance; three: what the choice of coordinates may do to a norm.
  knownDefect("ball_joint_in_minimal_coordinates",
              [&] { EXPECT_LE(error[1], 3.0 * error[0]) << "absolute: " << error[0]; });
}

/// Runs a model of models/ in minimal coordinates; its own checks are to hold.
void checksInMinimalCoordinates(const std::string& name) {
  BoundedRun run("models/" + name + ".xml", {.coordinates = JointCoordinates::minimal});
  run.run();
  EXPECT_TRUE(run.finished()) << run.report().reason;
  EXPECT_EQ(run.report().solver.unconverged, 0);
  for (const CheckResult& r : run.simulation().checks())
    EXPECT_TRUE(r.pass) << r.measure << " of " << r.signal << " is " << r.got << ", expected "
                        << r.expected;
}

TEST(KnownDefects, ARobotArmInMinimalCoordinatesPassesItsChecks) {
  knownDefect("robot_arm_minimal", [] { checksInMinimalCoordinates("robot_arm"); });
}

TEST(KnownDefects, AChainInMinimalCoordinatesFallsOnAFloor) {
  BoundedRun chain("models/chain_on_floor.xml",
                   {.until = 0.6, .evaluations = 3'000, .coordinates = JointCoordinates::minimal});
  chain.run();
  knownDefect("chain_on_floor_minimal", [&] {
    EXPECT_TRUE(chain.finished()) << chain.report().reason;
    EXPECT_EQ(chain.report().solver.unconverged, 0);
  });
}

}  // namespace
}  // namespace dynamy::defects
