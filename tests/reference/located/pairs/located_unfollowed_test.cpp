// What no gap follows while it touches is stepped in time there, located everywhere else, and
// reported.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/contact/simple_contact.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

/// A scene of bodies in space with gravity, plastic contacts and friction between all of them.
std::string plasticScene(const std::string& bodies, const std::string& ground,
                         const std::string& law = R"(mu="0.5")") {
  return R"(<dynamy version="1"><systems>)" + bodies + R"(<Ground name="world">)" + ground +
         R"(</Ground></systems><forces><Gravity/></forces><elements><Contact between="a a">)" +
         "<UnilateralCoulomb " + law +
         R"(/></Contact></elements><simulation until="1" step="1"/>)" + "</dynamy>";
}

std::string plasticBody(const std::string& name, const std::string& attributes,
                        const std::string& shape) {
  return "<RigidBody name=\"" + name + "\" " + attributes + "><" + shape +
         R"( mass="1" material="a"/></RigidBody>)";
}

bool warnsOfStepping(const RunReport& r) {
  for (const Warning& w : r.warnings)
    if (w.kind == "time stepping" || w.kind == "stepped") return true;
  return false;
}

TEST(LocatedUnfollowed, BodiesThatTumbleApartFromEachOtherAreLocated) {
  // A capsule, a cylinder and a box fall side by side: nearer features follow each other at any
  // distance, and nothing touches. Free flight in closed form.
  const std::string bodies = plasticBody("rod", R"(position="0 0 5" angularVelocity="3 2 1")",
                                         R"(Capsule radius="0.1" length="0.4")") +
                             plasticBody("can", R"(position="0.6 0 5" angularVelocity="5 -2 4")",
                                         R"(Cylinder radius="0.1" length="0.3")") +
                             plasticBody("box", R"(position="0 0.6 5" angularVelocity="1 7 2")",
                                         R"(Box size="0.2 0.3 0.1")");
  LocatedRun run(plasticScene(bodies, R"(<HalfSpace normal="0 0 1" material="a"/>)"), 1e-9, 0.9);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_EQ(run.report().stepping.periods, 0);
  EXPECT_FALSE(warnsOfStepping(run.report()));
  for (const int i : {2, 9, 16})  // z of the three
    EXPECT_NEAR(run.state().q[i], 5.0 - 0.5 * 9.81 * 0.81, 1e-8);
}

TEST(LocatedUnfollowed, ARodThatFallsFlatOnABoxIsLocated) {
  // Its two ends touch at once, and stay the contacts of the pair: by 0.5 m in √(2·0.5/g), where it
  // comes to rest without rebound. Instants of impacts are as far off as positions over the speed
  // there: 1e-6 L/v, L < 10 m.
  const std::string rod = plasticBody("rod", R"(position="0 0 0.6")",
                                      R"(Capsule radius="0.1" length="0.4" euler="90deg 0 0")");
  LocatedRun run(plasticScene(rod, R"(<Box size="2 2 0.2" position="0 0 -0.1" material="a"/>)"),
                 1e-6, 0.6);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_EQ(run.report().stepping.periods, 0);
  const double touch = std::sqrt(2.0 * 0.5 / 9.81), v = 9.81 * touch;
  std::vector<double> hits;
  for (const ContactEvent& e : run.events)
    if (e.impact) hits.push_back(e.t);
  ASSERT_FALSE(hits.empty());
  for (const double t : hits) EXPECT_NEAR(t, touch, 1e-5 / v);
  EXPECT_NEAR(run.state().q[2], 0.1, 1e-5);
  EXPECT_NEAR(run.state().u[2], 0.0, 1e-6);
}

/// An element that takes its contact back without a word.
class Curtain final : public SimpleContact {
 public:
  static void declare(Attributes&) {}
  explicit Curtain(const Parameters& x) : SimpleContact(x) {}
  double g(double, ConstVec q) const override { return q[0]; }
  void gamma(double, ConstVec, ConstVec u, Vec gamma) const override { gamma[0] = u[0]; }
  void contacts(const Kinematics& k, ContactSink& sink) const override {
    if (k.t() < 0.5) SimpleContact::contacts(k, sink);
  }
};

TEST(LocatedUnfollowed, AnElementThatReportsItsContactNowAndThenIsNamed) {
  LocatedRun run(
      R"xml(<dynamy version="1"><systems><Coordinates name="body" q="x" q0="1" M="1" h="-1"/>
      </systems><elements><Curtain name="curtain" on="body"/></elements>
      <simulation until="1" step="1"/></dynamy>)xml",
      1e-5, 1.0, {}, [](Registry& r) { r.add<Curtain>("Curtain"); });
  // Without it the body falls on: closed form.
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_TRUE(warnsOfStepping(run.report()));
  EXPECT_EQ(run.report().stepping.first.name, "curtain");
  EXPECT_NEAR(run.state().q[0], 0.5, 1e-5);
  EXPECT_NEAR(run.state().u[0], -1.0, 1e-5);
}

TEST(LocatedUnfollowed, SpareBarsThatPassTheirFlatPosition) {
  // One of 14 rows is redundant there (truth S02, extended precision), and beside it the bars are a
  // hundred times as fast as at the start. Velocities of the start times 1 + 1e-5 move the crank by
  // 2.3e-5 m in these 10 s: K = 2.3.
  constexpr double kTip = 0.32845811154124, K = 2.3;
  for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7}) {
    LocatedRun bars("four_bar", tolerance, 10.0);
    ASSERT_EQ(bars.run().ended, RunReport::Ended::finished) << bars.report().reason;
    EXPECT_NEAR(bars.state().q[0], 0.5 * kTip, 10.0 * K * tolerance) << tolerance;
  }
  // Steps become too short there for tolerances below 1e-9: the flat position is passed in time, and
  // the rest is located again. Steps of 1e-5 T in time of some 1e-2 s leave errors of about 1e-9; all of the
  // rest in time, 2e-4.
  LocatedRun bars("four_bar", 1e-10, 10.0);
  ASSERT_EQ(bars.run().ended, RunReport::Ended::finished) << bars.report().reason;
  EXPECT_TRUE(warnsOfStepping(bars.report()));
  EXPECT_LT(bars.report().stepping.time, 0.5);
  EXPECT_NEAR(bars.state().q[0], 0.5 * kTip, 1e-7);
}

}  // namespace
}  // namespace dynamy::reference
