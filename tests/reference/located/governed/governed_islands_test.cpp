// Where some islands switch too densely, the others go on being located.
#include <gtest/gtest.h>

#include <algorithm>
#include <reference/located/bounce.hpp>
#include <reference/located/located_run.hpp>
#include <string>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

/// Eighty balls that do not see each other and bounce until their switches are too dense at 5e-3;
/// and what `other` adds.
std::string ballsAnd(const std::string& other, const std::string& forces = "") {
  std::string text = "<dynamy version=\"1\"><systems>";
  for (int i = 0; i < 80; ++i)
    text += "<PointMass name=\"p" + std::to_string(i) + "\" mass=\"1\" position=\"0 0 " +
            std::to_string(0.5 + 0.01 * i) + "\"><Point material=\"ball\"/></PointMass>";
  return text + other + R"xml(
  <Ground name="world"><HalfSpace material="floor"/></Ground></systems><forces><Gravity/>)xml" +
         forces + R"xml(</forces><elements>
  <Contact between="ball floor"><Unilateral epsilonN="0.9"/></Contact>
  <Contact between="drop floor"><Unilateral epsilonN="0.8"/></Contact>
  <Contact between="stone floor"><Unilateral epsilonN="0.9"/></Contact>
  <Contact between="stone stone"><Unilateral epsilonN="0.5"/></Contact>
  <Contact between="slide floor"><UnilateralCoulomb mu="0.3"/></Contact>
  <NoContact between="ball drop"/><NoContact between="ball stone"/>
  <NoContact between="drop stone"/><NoContact between="drop drop"/>
  <NoContact between="ball slide"/></elements>
  <simulation until="1" step="1"/></dynamy>)xml";
}

constexpr double kGovernedTolerance = 5e-3;
/// A force that acts on two systems by what both do, without their names.
class Unnamed final : public ExternalForce {
 public:
  static void declare(Attributes& a) { a.about("For tests."); }
  explicit Unnamed(const Parameters& x) : ExternalForce(x) {}
  void connect(Topology& topology) override { topology_ = &topology; }
  void addTo(const Kinematics& k, ForceSink& sink) const override {
    const SystemHandle &a = topology_->system(5), &b = topology_->system(80);
    const double pull = 1e-3 * (k.q(b)[0] - k.q(a)[0]);
    sink.generalised(a, 0, pull), sink.generalised(b, 0, -pull);
  }

 private:
  const Topology* topology_ = nullptr;
};

/// It bounces rarely, so that it owes least: after 0.68 and 1.77 s. Its place among q: behind the
/// 80 balls.
const std::string kDrop =
    R"xml(<PointMass name="drop" mass="1" position="9 0 2.28"><Point material="drop"/></PointMass>)xml";
constexpr int kDropZ = 3 * 80 + 2;

TEST(GovernedIslands, ABallThatBouncesRarelyBesideOthersKeepsItsDigits) {
  constexpr double kUntil = 2.5;
  // One clock, with which the others' impacts are dense for this ball, too.
  LocatedRun run(ballsAnd(kDrop), kGovernedTolerance, kUntil, {}, {},
                 LocatedRun::withClocks("one"));
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_GE(r.stepping.periods, 1);
  EXPECT_GE(r.stepping.steps, 3);
  EXPECT_LT(r.stepping.systems, 80);
  // Its second impact falls into steps in time. Parabolas are exact and impacts located to
  // rounding.
  EXPECT_NEAR(run.state().q[kDropZ], bounceHeight(2.28, 0.8, kUntil), 1e-10);
  // Of 730 J: an impact of a quiet ball whose work was not told would leave 1 J. Stepped balls that
  // are lifted out of an overlap leave some mJ.
  EXPECT_NEAR(r.energy.discretisation, 0.0, 0.1);
  EXPECT_NEAR(r.energy.imbalance, 0.0, 1e-9);
  // A step ends with an overlap e tol L at most, and the next one sees it half a step later, at a
  // speed with h/2 (1 + 0.9) v ≤ e tol L: e (1 + 1/1.9) of it together. Quiet balls have none.
  EXPECT_LE(r.gaps.penetration.value,
            std::max(1.0, r.stepping.error) * 1.53 * kGovernedTolerance * run.model().length());
}

TEST(GovernedIslands, ASliderBesideOthersStopsWhereItWould) {
  // The last of its slip is one step without an interpolation of its own: a random scene ended in a
  // segmentation fault there.
  const std::string slider =
      R"xml(<PointMass name="slide" mass="1" position="9 0 0" velocity="3 4 0"><Point material="slide"/></PointMass>)xml";
  LocatedRun run(ballsAnd(slider), kGovernedTolerance, 2.5, {}, {}, LocatedRun::withClocks("one"));
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  ASSERT_GE(r.stepping.periods, 1);
  ASSERT_LT(r.stepping.first.t, 1.5);  // it stops after 5/(0.3 g) = 1.7 s
  const double way = 25.0 / (2.0 * 0.3 * kG);
  const Eigen::VectorXd q = run.state().q.segment(3 * 80, 3);
  EXPECT_NEAR(q[0], 9.0 + 0.6 * way, 1e-10);  // constant forces: steps are exact
  EXPECT_NEAR(q[1], 0.8 * way, 1e-10);
  EXPECT_EQ(run.state().u.segment(3 * 80, 2).norm(), 0.0);
}

TEST(GovernedIslands, GoOnFromACheckpointBitForBit) {
  expectToGoOnBitForBit(ballsAnd(kDrop), kGovernedTolerance);
}

TEST(GovernedIslands, AreJoinedByWhatTouchesThem) {
  // One stone bounces low and often, so that it is stepped; another falls on it from 21 m after two
  // seconds, and does not pass through.
  const std::string stones =
      R"xml(<RigidBody name="low" position="9 0 0.25"><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>
  <RigidBody name="late" position="9 0 21"><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>)xml";
  LocatedRun run(ballsAnd(stones), kGovernedTolerance, 2.5);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_GE(r.stepping.periods, 1);
  const Eigen::VectorXd& q = run.state().q;
  const double overlap = kGovernedTolerance * run.model().length();
  EXPECT_GT(q[3 * 80 + 7 + 2] - q[3 * 80 + 2], 0.2 - overlap);
  EXPECT_LE(r.gaps.penetration.value, std::max(1.0, r.stepping.error) * 1.000001 * overlap);
  EXPECT_GT(run.state().u[3 * 80 + 6 + 2], -1.0);  // it falls with 20 m/s before
}

TEST(GovernedIslands, AreOneWhereGrainsComeAndGo) {
  // Of three grains one comes every 0.9 s, the second while others are stepped in time.
  const std::string fed =
      R"xml(<Grains name="fed" count="3" present="0" within="20 0 50 21 1 51" feed="1.1111111111111112"
    seed="1" feedWithin="20 0 50 30 10 50"><Sphere radius="1mm" mass="1" material="drop"/></Grains>)xml";
  LocatedRun run(ballsAnd(fed), kGovernedTolerance, 2.5);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_GE(r.stepping.periods, 1);
  EXPECT_EQ(r.stepping.systems, 81);
  for (int k = 1; k <= 2; ++k) {
    const double t = 2.5 - 0.9 * k;  // falls from 50 m
    EXPECT_NEAR(run.state().q[3 * 80 + 7 * (k - 1) + 2], 50.0 - 0.5 * kG * t * t, 0.1) << k;
  }
}

TEST(GovernedIslands, AreOneWhereAForceMayCoupleWhatItDoesNotName) {
  LocatedRun run(
      ballsAnd(kDrop, "<Unnamed/>"), kGovernedTolerance, 2.5, {},
      [](Registry& r) { r.add<Unnamed>("Unnamed"); }, LocatedRun::withClocks("one"));
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_GE(r.stepping.periods, 1);
  EXPECT_EQ(r.stepping.systems, 81);
}

TEST(GovernedIslands, AreOneWhereAForceCouplesThem) {
  const auto coupled = [](const std::string& forces) {
    LocatedRun run(ballsAnd(kDrop, forces), kGovernedTolerance, 1.0);
    SystemParts parts;
    parts.topology = &run.model().topology();
    for (const auto& c : run.model().contacts()) parts.contacts.push_back(c.get());
    Islands islands;
    EXPECT_TRUE(islands.start(parts));
    return islands.of(80) == islands.of(5);
  };
  EXPECT_FALSE(coupled(""));  // gravity couples nothing, what may touch some time nothing yet
  EXPECT_TRUE(coupled(R"xml(<SpringDamper between="drop p5" stiffness="1" length="4"/>)xml"));
}

}  // namespace
}  // namespace dynamy::reference
