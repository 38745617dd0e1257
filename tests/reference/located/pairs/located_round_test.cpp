// Capsules, cylinders, cones and tori on boxes, on polyhedra and on each other,
// whose pairs of features are followed one by one while they touch (theory 50.9).
#include <gtest/gtest.h>

#include <random>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

enum class RoundPair { capsule, cylinder, cone, torus };

/// A round body that flies at another one, `other`: a shape without its last attributes.
std::string thrownAt(unsigned seed, const std::string& other, RoundPair kind = RoundPair::capsule) {
  std::mt19937 random(seed);
  const auto one = [&](double a, double b) {
    return std::to_string(a + (b - a) * static_cast<double>(random()) / 4294967296.0);
  };
  const auto three = [&](double a, double b) {
    const std::string x = one(a, b), y = one(a, b);
    return x + " " + y + " " + one(a, b);
  };
  std::string text = R"(<dynamy version="1"><systems><RigidBody name="a" position="-1.3 )";
  text += one(-0.2, 0.2) + " " + one(-0.2, 0.2) + R"(" euler=")" + three(-3.0, 3.0);
  text += R"(" velocity=")" + one(0.5, 2.0) + " " + one(-0.2, 0.2) + " " + one(-0.2, 0.2);
  text += R"(" angularVelocity=")" + three(-4.0, 4.0) + R"("><)";
  constexpr std::array<const char*, 4> kKinds{"Capsule", "Cylinder", "Cone", "Torus"};
  text += kKinds[static_cast<std::size_t>(kind)];
  if (kind == RoundPair::torus)
    text += R"( radius="0.4" tube=")" + one(0.05, 0.2);
  else
    text += R"( radius=")" + one(0.1, 0.3) + R"(" length=")" + one(0.3, 1.0);
  text += R"(" mass="1" material="a"/></RigidBody>)";
  text += R"(<RigidBody name="b" position="0 0 0" euler=")" + three(-3.0, 3.0);
  text += R"(" angularVelocity=")" + three(-4.0, 4.0) + R"(" mass="1" )";
  text += R"(inertia="0.06 0.07 0.08">)" + other + R"( material="a"/></RigidBody></systems>)";
  constexpr std::array<const char*, 3> kRebound{"0", "0", "0.8"};
  return text + R"(<elements><Contact between="a a"><UnilateralCoulomb mu="0.3" epsilonN=")" +
         kRebound[random() % 3] +
         R"("/></Contact></elements><simulation until="1" step="1"/></dynamy>)";
}

struct Throws {
  long impacts = 0;
  int told = 0;
};

/// Each flight ends as with a tighter tolerance: impacts and contacts that go on amplify errors of
/// 1e-6 L to 1.4e-4 at most, of those that went wrong silently the least was off by 9e-4
/// (located_jumping_test.cpp).
Throws throwAt(const std::string& other, unsigned count, RoundPair kind = RoundPair::capsule) {
  Throws flights;
  for (unsigned seed = 0; seed < count; ++seed) {
    const std::string scene = thrownAt(seed, other, kind);
    LocatedRun loose(scene, 1e-6, 2.5), tight(scene, 1e-9, 2.5);
    loose.run(), tight.run();
    for (const LocatedRun* run : {&loose, &tight})
      EXPECT_EQ(run->report().ended, RunReport::Ended::finished) << run->report().reason;
    flights.impacts += loose.report().contacts.impacts;
    if (loose.report().stepping.periods + tight.report().stepping.periods > 0)
      ++flights.told, std::printf("told: %u\n", seed);
    else
      EXPECT_LT((loose.state().q - tight.state().q).cwiseAbs().maxCoeff(), 3e-4) << seed;
  }
  std::printf("%u flights: %ld impacts, %d told\n", count, flights.impacts, flights.told);
  return flights;
}

constexpr unsigned kFlights = 60;
const std::string kBox = R"(<Box size="0.5 0.7 0.4")";
const std::string kSame = R"(<Polyhedron points="-0.25 -0.35 -0.2 0.25 -0.35 -0.2 -0.25 0.35 -0.2
    0.25 0.35 -0.2 -0.25 -0.35 0.2 0.25 -0.35 0.2 -0.25 0.35 0.2 0.25 0.35 0.2")";

const std::string kWedge =
    R"(<Polyhedron points="-0.4 -0.4 -0.3 0.5 -0.3 -0.4 0 0.5 -0.2 0.1 0.1 0.5")";

TEST(LocatedCapsules, StayInTouchWithBoxes) {
  const Throws flights = throwAt(kBox, kFlights);
  EXPECT_GT(flights.impacts, 60);
  EXPECT_EQ(flights.told, 0);
}

TEST(LocatedCapsules, StayInTouchWithPolyhedra) {
  const Throws flights = throwAt(kWedge, kFlights);
  EXPECT_GT(flights.impacts, 60);
  EXPECT_EQ(flights.told, 0);
}

TEST(LocatedCapsules, StayInTouchWithEachOther) {
  const Throws flights = throwAt(R"(<Capsule radius="0.2" length="0.6")", kFlights);
  EXPECT_GT(flights.impacts, 60);
  EXPECT_EQ(flights.told, 0);
}

/// The ends of a capsule on a box and on the polyhedron of its corners are found by two searches,
/// with features of other numbers.
TEST(LocatedCapsules, FeelABoxAsThePolyhedronOfItsCorners) {
  for (unsigned seed = 100; seed < 120; ++seed) {
    LocatedRun box(thrownAt(seed, kBox), 1e-9, 2.5), same(thrownAt(seed, kSame), 1e-9, 2.5);
    box.run(), same.run();
    EXPECT_EQ(box.report().stepping.periods + same.report().stepping.periods, 0) << seed;
    // Both have errors of 1e-9 L, amplified by 1.4e2 at most (as above).
    EXPECT_LT((box.state().q - same.state().q).cwiseAbs().maxCoeff(), 3e-7) << seed;
  }
}

/// Throws at a box and at a polyhedron, of which `told` at most are stepped in time.
void expectLocated(RoundPair kind, int told) {
  for (const std::string& other : {kBox, kWedge}) {
    const Throws flights = throwAt(other, kFlights, kind);
    EXPECT_GT(flights.impacts, 60);
    EXPECT_LE(flights.told, told);
  }
}

TEST(LocatedDiscs, CylindersStayInTouchWithFlatFaces) { expectLocated(RoundPair::cylinder, 0); }

// A base that lies on an edge slides over it: two crossings of the rim come together.
TEST(LocatedDiscs, ConesStayInTouchWithFlatFaces) { expectLocated(RoundPair::cone, 1); }

TEST(LocatedDiscs, ToriStayInTouchWithFlatFaces) { expectLocated(RoundPair::torus, 1); }

/// Throws at one of each kind.
void expectLocatedAmongRound(RoundPair kind, int told) {
  for (const std::string other :
       {R"(<Capsule radius="0.2" length="0.6")", R"(<Cylinder radius="0.3" length="0.4")",
        R"(<Cone radius="0.35" length="0.6")", R"(<Torus radius="0.35" tube="0.12")"}) {
    const Throws flights = throwAt(other, kFlights, kind);
    EXPECT_GT(flights.impacts, 60) << other;
    EXPECT_LE(flights.told, told) << other;
  }
}

TEST(LocatedDiscs, CapsulesStayInTouchWithRoundBodies) {
  expectLocatedAmongRound(RoundPair::capsule, 0);
}

TEST(LocatedDiscs, CylindersStayInTouchWithRoundBodies) {
  expectLocatedAmongRound(RoundPair::cylinder, 1);
}

// The tip of one slides over the border of the base of the other.
TEST(LocatedDiscs, ConesStayInTouchWithRoundBodies) { expectLocatedAmongRound(RoundPair::cone, 1); }

TEST(LocatedDiscs, ToriStayInTouchWithRoundBodies) { expectLocatedAmongRound(RoundPair::torus, 0); }

/// A body that slides without friction off the top of a fixed one, whose middles stay R apart, leaves
/// it where m v²/R = m g cos θ: cos θ = 2/3 cos θ₀ from rest at θ₀. From there on its velocity to the
/// side is √(g R) cos^{3/2} θ.
TEST(LocatedDiscs, SlideOffEachOtherWhereNoForceIsLeft) {
  struct Slide {
    const char *below, *above;
    double R;
  };
  for (const Slide& slide :
       {Slide{R"(<Cylinder radius="0.4" length="1")", R"(<Cylinder radius="0.2" length="0.3")",
              0.6},
        Slide{R"(<Cylinder radius="0.4" length="1")", R"(<Capsule radius="0.1" length="0.3")", 0.5},
        Slide{R"(<Cylinder radius="0.4" length="1")", R"(<Torus radius="0.2" tube="0.05")", 0.65},
        Slide{R"(<Torus radius="0.3" tube="0.1")", R"(<Torus radius="0.2" tube="0.05")", 0.65}}) {
    const double start = 0.3, g = 9.81, cosine = 2.0 / 3.0 * std::cos(start);
    const std::string scene =
        R"(<dynamy version="1"><parameter name="s" value="0.3"/><systems><Ground>)" +
        std::string(slide.below) +
        R"( euler="90deg 0 0" material="a"/></Ground><RigidBody name="b" position="{R*sin(s)} 0 {R*cos(s)}">)" +
        slide.above + R"( euler="90deg 0 0" mass="1" material="a"/></RigidBody></systems>
        <parameter name="R" value=")" +
        std::to_string(slide.R) + R"("/><forces><Gravity/></forces>
        <elements><Contact between="a a"><Unilateral epsilonN="0"/></Contact></elements>
        <simulation until="1" step="1"/></dynamy>)";
    LocatedRun run(scene, 1e-9, 0.8);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    EXPECT_EQ(run.report().stepping.periods, 0) << slide.above;
    // Errors of some tolerances of positions below 1 m and speeds below 10 m/s.
    EXPECT_NEAR(run.state().u[0], std::sqrt(g * slide.R) * std::pow(cosine, 1.5), 1e-7)
        << slide.above;
  }
}

/// The face of a large box is the plane of a half space, over which features are others.
TEST(LocatedDiscs, RollAndLieOnABoxAsOnAHalfSpace) {
  int told = 0;
  for (const char* shape :
       {R"(<Cylinder radius="0.2" length="0.3")", R"(<Cylinder radius="0.3" length="0.1")",
        R"(<Cone radius="0.3" length="0.5")", R"(<Torus radius="0.3" tube="0.1")"})
    for (const char* euler : {"0 0 0", "0.3 0.2 0", "1.2 0.1 0.4", "1.5707963267948966 0 0"}) {
      const auto scene = [&](const char* ground) {
        return std::string(
                   R"(<dynamy version="1"><systems><RigidBody name="a" position="0 0 0.8" euler=")") +
               euler + R"(" velocity="0.5 0.2 0" angularVelocity="0.5 1 -0.3">)" + shape +
               R"( mass="1" material="a"/></RigidBody>
               <Ground>)" +
               ground +
               R"(</Ground></systems><forces><Gravity/></forces><elements><Contact between="a a">
               <UnilateralCoulomb mu="0.4" epsilonN="0.3"/></Contact></elements><simulation until="1" step="1"/></dynamy>)";
      };
      const char* box = R"(<Box size="20 20 2" position="0 0 -1" material="a"/>)";
      LocatedRun flat(scene(R"(<HalfSpace material="a"/>)"), 1e-8, 2.0), top(scene(box), 1e-8, 2.0);
      flat.run(), top.run();
      told += top.report().stepping.periods > 0 ? 1 : 0;
      // Some ten impacts amplify errors of 1e-8 L by 1.4e2 each three (located_jumping_test.cpp).
      EXPECT_LT((flat.state().q - top.state().q).cwiseAbs().maxCoeff(), 1e-4) << shape << euler;
    }
  EXPECT_LE(told, 1);  // a cone that falls with its axis level
}

TEST(LocatedDiscs, AWheelRollsOverAKerbAsItsClosedForm) {
  // Angular momentum about the edge at the plastic impact, energy from there on.
  const double r = 0.3, h = 0.04, J = 0.5, m = 10.0, v = 1.2;
  const double w = (J * v / r + m * v * (r - h)) / (J + m * r * r);
  const double top = std::sqrt(r * w * r * w - 2.0 * 9.81 * h / (1.0 + J / (m * r * r)));
  for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
    LocatedRun run("kerb", tolerance, 0.8);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    EXPECT_EQ(run.report().stepping.periods, 0);
    // Two switches and the way between: an error of some tolerances, of L < 10 m and v < 10 m/s.
    EXPECT_NEAR(run.state().u[0], top, 1e1 * tolerance);
    EXPECT_NEAR(run.state().q[2], h + r, 1e1 * tolerance);
  }
}

TEST(LocatedDiscs, AMotorbikeLandsWithoutStepsInTime) {
  LocatedRun run("motorbike_jump", 1e-5, 3.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_EQ(run.report().stepping.periods, 0);
}

}  // namespace
}  // namespace dynamy::reference
