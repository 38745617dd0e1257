// Runs to a tolerance with friction in several rows, and what such runs refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <reference/located/located_run.hpp>
#include <support/table.hpp>

namespace dynamy::reference {
namespace {

// ---- sets in several rows ----------------------------------------------------------------------

/// Tippe-top with sliding and drilling friction of one ellipsoid, mu = 0.3, (2/3) a = 1/3 mm.
std::string tippeTop() {
  return R"xml(<dynamy version="1">
  <systems>
    <RigidBody name="top" position="0 0 {15mm - 3mm*cos(0.1)}" euler="0 0.1 0"
      angularVelocity="0 0 180" mass="6e-3" inertia="8e-7 8e-7 7e-7">
      <Sphere radius="15mm" position="0 0 3mm" material="wood"/>
      <Sphere radius="5mm" position="0 0 16mm" material="wood"/>
    </RigidBody>
    <Ground name="table"><HalfSpace material="table"/></Ground>
  </systems>
  <forces><Gravity/></forces>
  <elements><Contact between="wood table"><UnilateralDrilling mu="0.3" radius="0.5mm" set="ellipsoid"/>
  </Contact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";
}

/// Angle of the figure axis to the vertical [rad], from the unit quaternion (w, x, y, z).
double inclination(const State& x) {
  const auto p = x.q.tail<4>();
  return 2.0 * std::atan2(std::hypot(p[1], p[2]), std::hypot(p[0], p[3]));
}

TEST(LocatedTippeTop, TurnsOverAsTheIntegrationOfItsOwnEquationsSays) {
  // Runge-Kutta 4 at 1e-5 and 4e-5 s, 8 digits.
  const double truth[][2] = {{0.25, 0.13600192},
                             {0.5, 0.50627368},
                             {0.75, 1.05807826},
                             {1.0, 1.57128303},
                             {1.25, 2.24142470}};
  for (const auto& [t, theta] : truth) {
    LocatedRun top(tippeTop(), 1e-10, t);
    ASSERT_EQ(top.run().ended, RunReport::Ended::finished) << top.report().reason;
    EXPECT_NEAR(inclination(top.state()), theta, 2e-8) << t;  // two in the last digit given
    EXPECT_EQ(top.report().located.undecided, 0);
  }
}

TEST(LocatedTippeTop, TouchesWithItsStemWhenTheIntegrationDoes) {
  LocatedRun top(tippeTop(), 1e-9, 1.4);
  ASSERT_EQ(top.run().ended, RunReport::Ended::finished) << top.report().reason;
  double first = 0.0;
  for (const ContactEvent& e : top.events)
    if (e.impact && first == 0.0) first = e.t;
  EXPECT_NEAR(first, 1.3733177, 1e-7);  // 8 digits, one in the last
}

TEST(LocatedPuck, SlidesOverBrushedMetalAsTheQuadratureSays) {
  // models/orthotropic_puck.xml, 10 digits.
  LocatedRun half("orthotropic_puck", 1e-10, 0.1863447432);
  ASSERT_EQ(half.run().ended, RunReport::Ended::finished) << half.report().reason;
  EXPECT_NEAR(half.state().u[0], 0.9258747123, 2e-9);  // 1e-10 s of 3 m/s², and the tolerance
  EXPECT_NEAR(half.state().u[1], 0.5, 2e-9);
  LocatedRun puck("orthotropic_puck", 1e-9, 1.3);
  ASSERT_EQ(puck.run().ended, RunReport::Ended::finished) << puck.report().reason;
  EXPECT_NEAR(puck.state().q[0], 0.6679106377, 1e-8);
  EXPECT_NEAR(puck.state().q[1], 0.2045723940, 1e-8);
  EXPECT_NEAR(puck.state().u[0], 0.0, 1e-15);  // at rest, but for the rounding of 1 m/s
}

TEST(LocatedPuck, StaysOnBrushedMetalUpToTheEllipseAndNoFurther) {
  // On a plate tilted by 0.2 about both axes friction has to hold (m g sin …) along both; the puck
  // starts to slip where (Fx/μ1)² + (Fy/μ2)² passes N².
  const auto slides = [](double mu1) {
    LocatedRun puck(R"xml(<dynamy version="1"><parameter name="mu1" value="0.1"/>
      <systems><PointMass name="puck" mass="0.2"><Point material="rubber"/></PointMass>
      <Ground name="plate"><HalfSpace material="brushed"/></Ground></systems>
      <forces><Gravity acceleration="1 2 -9.81"/></forces>
      <elements><Contact between="rubber brushed"><UnilateralOrthotropic mu1="{mu1}" mu2="0.3"/>
      </Contact></elements><simulation until="1" step="1"/></dynamy>)xml",
                    1e-8, 0.5, {{"mu1", numberText(mu1)}});
    EXPECT_EQ(puck.run().ended, RunReport::Ended::finished) << puck.report().reason;
    return puck.state().u.norm() > 1e-6;
  };
  const double limit = 1.0 / std::sqrt(9.81 * 9.81 - 4.0 / 0.09);
  EXPECT_TRUE(slides(limit - 1e-3));
  EXPECT_FALSE(slides(limit + 1e-3));
}

// ---- elements that tell a wrong bias -----------------------------------------------------------

enum class Tells { bias, nothing, half };

/// Inside of a bowl of radius 1 m; its bias is Wᵀ's own change, which it may leave out.
template <Tells kTells>
class Bowl final : public SimpleContact {
 public:
  static void declare(Attributes&) {}
  using SimpleContact::SimpleContact;
  double g(double, ConstVec q) const override { return 1.0 - q.norm(); }
  void gamma(double, ConstVec q, ConstVec u, Vec gamma) const override {
    gamma[0] = -q.dot(u) / q.norm();
  }
  bool bias(const Kinematics& k, Vec w) const override {
    w.setZero();
    if (kTells == Tells::half) w[0] = -0.5 * k.u(systemOfTests()).squaredNorm();
    return kTells != Tells::bias;
  }

 private:
  /// The one system of the scene: two coordinates from the first on.
  static SystemHandle systemOfTests() {
    SystemHandle s;
    s.nq = s.nu = 2;
    return s;
  }
};

std::string bowl(const std::string& type) {
  return "<dynamy version=\"1\"><systems><Coordinates name=\"bead\" q=\"x y\" units=\"m m\" "
         "q0=\"1 0\" u0=\"0 -1\" M=\"1 ; 0 ; 1\" potential=\"9.81*y\"/></systems><elements><" +
         type +
         " name=\"bowl\" on=\"bead\"/></elements><simulation until=\"1\" step=\"1\"/></dynamy>";
}

TEST(LocatedBias, IsAskedOfElementsThatTellAWrongOne) {
  const auto types = [](Registry& r) {
    r.add<Bowl<Tells::bias>>("Bowl"), r.add<Bowl<Tells::nothing>>("SilentBowl");
    r.add<Bowl<Tells::half>>("WrongBowl");
  };
  LocatedRun wrong(bowl("WrongBowl"), 1e-6, 1.0, {}, types);
  EXPECT_EQ(wrong.run().ended, RunReport::Ended::failed);
  EXPECT_TRUE(wrong.report().refused);
  EXPECT_NE(wrong.report().reason.find("<WrongBowl name=\"bowl\"> tells a wrong bias"),
            std::string::npos)
      << wrong.report().reason;

  // Energy of the frictionless bead; of one that tells none, too.
  for (const char* type : {"Bowl", "SilentBowl"}) {
    LocatedRun run(bowl(type), 1e-9, 1.0, {}, types);
    EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    const State& x = run.state();
    EXPECT_NEAR(0.5 * x.u.squaredNorm() + 9.81 * x.q[1], 0.5, 1e-7) << type;
  }
}

// ---- both sides of an impact -------------------------------------------------------------------

TEST(LocatedRecording, HasARowOnEachSideOfAnImpact) {
  LocatedRun ball("bouncing_ball", 1e-10, 1.0);
  Table table;
  ball.simulation().record(table);
  ASSERT_EQ(ball.run().ended, RunReport::Ended::finished) << ball.report().reason;
  std::vector<std::size_t> pairs;
  for (std::size_t i = 1; i < table.t.size(); ++i) {
    EXPECT_GE(table.t[i], table.t[i - 1]);
    if (table.t[i] == table.t[i - 1]) pairs.push_back(i);
  }
  ASSERT_EQ(static_cast<long>(pairs.size()), ball.report().contacts.impacts);
  const double speed = std::sqrt(2.0 * 9.81);  // of a fall of 1 m; e = 0.5
  EXPECT_NEAR(table.rows[pairs[0] - 1][1], -speed, 1e-9);
  EXPECT_NEAR(table.rows[pairs[0]][1], 0.5 * speed, 1e-9);
}

TEST(LocatedChecks, SeeTheSpeedRightBeforeAnImpact) {
  LocatedRun ball("bouncing_ball", 1e-10, 1.0);
  CheckSettings lowest;
  lowest.signal = "ball.vz", lowest.measure = CheckSettings::Measure::min;
  ball.model().checks.push_back(lowest);
  Simulation simulation(ball.model());
  ASSERT_EQ(simulation.run().ended, RunReport::Ended::finished) << simulation.report().reason;
  ASSERT_EQ(simulation.checks().size(), 1u);
  EXPECT_NEAR(simulation.checks().front().got, -std::sqrt(2.0 * 9.81), 1e-9);
}

}  // namespace
}  // namespace dynamy::reference
