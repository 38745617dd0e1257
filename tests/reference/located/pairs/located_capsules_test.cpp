// Capsules on boxes, polyhedra and each other, whose pairs of features are followed one by one while
// they touch (theory 50.11).
#include <gtest/gtest.h>

#include <random>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

/// A capsule that flies at another body, `other`: a shape without its last attributes.
std::string thrownAt(unsigned seed, const std::string& other) {
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
  text += R"(" angularVelocity=")" + three(-4.0, 4.0) + R"("><Capsule radius=")" + one(0.1, 0.3);
  text += R"(" length=")" + one(0.3, 1.0) + R"(" mass="1" material="a"/></RigidBody>)";
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
Throws throwAt(const std::string& other, unsigned count) {
  Throws flights;
  for (unsigned seed = 0; seed < count; ++seed) {
    const std::string scene = thrownAt(seed, other);
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

TEST(LocatedCapsules, StayInTouchWithBoxes) {
  const Throws flights = throwAt(kBox, kFlights);
  EXPECT_GT(flights.impacts, 60);
  EXPECT_EQ(flights.told, 0);
}

TEST(LocatedCapsules, StayInTouchWithPolyhedra) {
  const Throws flights = throwAt(
      R"(<Polyhedron points="-0.4 -0.4 -0.3 0.5 -0.3 -0.4 0 0.5 -0.2 0.1 0.1 0.5")", kFlights);
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

}  // namespace
}  // namespace dynamy::reference
