// Directions of slips that start at once, whose iteration overshoots.
#include <gtest/gtest.h>

#include <dynamy/located/phase/frozen_phase.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

/// A plate of 1 kg on four corners, drawn aside by gravity, with 5 N of friction: all of its corners
/// begin to slip.
struct Plate {
  explicit Plate(const std::string& gravity)
      : scene("plate", {.text = R"xml(<dynamy version="1"><systems>
    <RigidBody name="plate"><Box size="1 1 1e-6" mass="1" material="a"/></RigidBody>
    <Ground name="floor"><HalfSpace material="a" position="0 0 -5e-7"/></Ground></systems>
  <forces><Gravity acceleration=")xml" +
                                gravity +
                                R"xml("/></forces>
  <elements><Contact between="a a"><UnilateralCoulomb epsilonN="0" mu="0.5"/></Contact></elements>
  <simulation until="1" step="1"/></dynamy>)xml"}),
        x(scene.state()) {
    phase.request.keys = scene.system().evaluate(x).contacts.key;
    std::sort(phase.request.keys.begin(), phase.request.keys.end());
    EXPECT_EQ(phase.request.keys.size(), 4u);
    for (const ContactKey key : phase.request.keys) {
      Held h;
      h.key = key, h.slips = h.starts = true, h.direction = {0.8, 0.6};
      phase.held.push_back(h);
    }
  }
  Eigen::VectorXd accelerations() {
    Eigen::VectorXd a;
    EXPECT_TRUE(phase.accelerate(scene.system().evaluate(x, phase.request.in(0)), x.u, a))
        << phase.fault();
    return a;
  }
  Scene scene;
  State x;
  FrozenPhase phase;
};

TEST(StartingSlips, FourThatPushEachOtherFindTheirDirections) {
  // t ← (F − 3 μN t)/|…| with F = 4.2 μN and N = mg/4: a deviation aside grows by 3/1.2 in each
  // turn, whatever it is at first.
  Plate plate("5.25 0 -10");
  const Eigen::VectorXd a = plate.accelerations();
  // Friction acts 5e-7 m below the centre, and turns nothing as long as the corners press. Rounding
  // of forces of 5 N.
  EXPECT_NEAR(a[0], 0.25, 1e-13);
  for (Eigen::Index i = 1; i < a.size(); ++i) EXPECT_NEAR(a[i], 0.0, 1e-12) << i;
  for (const Held& h : plate.phase.held)
    EXPECT_NEAR(std::abs(h.direction[0]) + std::abs(h.direction[1]), 1.0, 1e-12);
}

TEST(StartingSlips, AreTheSameToTheLastDigitInTheNextEvaluation) {
  // A run that goes on from a checkpoint evaluates its start once more. Each of these pulls ends the
  // iteration with other roundings.
  for (int k = 0; k < 20; ++k) {
    Plate plate(std::to_string(5.25 + 0.1 * k) + " " + std::to_string(0.37 * k) + " -10");
    const Eigen::VectorXd first = plate.accelerations();
    EXPECT_EQ(plate.accelerations(), first) << k;
  }
}

}  // namespace
}  // namespace dynamy::reference
