/// Joints at places that are also contacts: the joint holds the contact, which bears nothing (theory
/// 34.4).
#include <gtest/gtest.h>

#include <cmath>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

/// A block of 15 g on a hinge at its lower right corner, which is a contact, too; it turns away
/// from the floor under the other corner with 4 rad/s. CONTACT: its rule, or none.
std::string hingedBlock(const std::string& contact) {
  return R"(<dynamy version="1"><systems>
<PlanarBody name="b" position="0 0 0.025" velocity="0.1 0 0.016" angularVelocity="-4"><Box size="0.008 0.024 0.05" mass="15e-3" material="bone"/></PlanarBody>
<Ground name="g"><HalfSpace material="floor"/></Ground></systems><forces><Gravity/></forces>
<elements><Revolute name="h" between="g b" at="0.004 0 0"/><)" +
         contact + R"(</elements><simulation until="0.1" step="1e-3"/>
<record signals="b.phi" every="0.01" frames="0"/></dynamy>)";
}
constexpr const char* kTouches = "Contact between=\"bone floor\"><Unilateral/></Contact>";
constexpr const char* kPasses = "NoContact between=\"bone floor\"/>";
/// (I + m r²) φ'' = −m g (a cos φ − b sin φ), r = (a, b) = (−4, 25) mm from hinge to centre,
/// I = m (8² + 50²)/12 mm², φ(0) = 0, φ'(0) = −4 rad/s: Runge and Kutta's method, all digits.
constexpr double kAngle = -0.3321107957;

TEST(JointsAtContacts, ABlockSwingsAboutAHingeThatIsAlsoAContact) {
  for (const double dt : {4e-3, 2e-3, 1e-3, 5e-4}) {
    BoundedRun free(hingedBlock(kPasses), {.step = dt});
    BoundedRun touching(hingedBlock(kTouches), {.step = dt});
    free.run(), touching.run();
    // Order one at least: the rate changes by 5 rad/s in all (|φ''| ≤ 50 /s², 0.1 s), and a step is
    // off by at most its length times the change of the rate in it.
    ASSERT_NEAR(free.last(), kAngle, 5.0 * dt) << dt;
    // A contact that the hinge holds bears nothing: the same motion up to rounding of 200 steps.
    EXPECT_NEAR(touching.last(), free.last(), 1e-12) << "step " << dt;
    EXPECT_EQ(touching.report().solver.unconverged, 0) << "step " << dt;
  }
}

/// A box of 2 kg whose corners stand on a floor, held by a joint, with a MOTION that it allows.
std::string heldBox(const std::string& joint, const std::string& motion,
                    const std::string& contact) {
  return R"(<dynamy version="1"><systems><RigidBody name="b" position="0 0 0.05" )" + motion +
         R"(><Box size="0.2 0.2 0.1" mass="2" material="bone"/></RigidBody>
<Ground name="g"><HalfSpace material="floor"/></Ground></systems><forces><Gravity/></forces>
<elements><)" +
         joint + " between=\"g b\"/><" + contact + R"(</elements>
<simulation until="0.06" step="1e-3"/><record signals="b.z" every="0.01" frames="0"/></dynamy>)";
}

TEST(JointsAtContacts, CornersThatJointsHoldBearNothing) {
  const std::string rubs =
      R"(Contact between="bone floor"><UnilateralCoulomb mu="0.5"/></Contact>)";
  struct Case {
    const char *joint, *motion;
  };
  // Two corners on an axis, one at a ball joint, all four of a body that is fixed; the others leave.
  for (const Case& held :
       {Case{R"(Revolute axis="0 1 0" at="0.1 0 0")",
             R"(velocity="0.1 0 0.2" angularVelocity="0 2 0")"},
        Case{R"(Spherical at="0.1 0.1 0")", R"(velocity="0.1 0.15 0.5" angularVelocity="-3 2 0")"},
        Case{R"(Fixed at="0 0 0")", ""}})
    for (const double dt : {2e-3, 1e-3, 5e-4}) {
      BoundedRun free(heldBox(held.joint, held.motion, kPasses), {.step = dt});
      BoundedRun touching(heldBox(held.joint, held.motion, rubs), {.step = dt});
      free.run(), touching.run();
      // Positions are brought to 1e-11 m or so in each of 120 steps.
      EXPECT_NEAR(touching.last(), free.last(), 1e-9) << held.joint << ", step " << dt;
      EXPECT_EQ(touching.report().solver.unconverged, 0) << held.joint << ", step " << dt;
    }
}

TEST(JointsAtContacts, ABlockOnAHingeAtItsContactCostsNoMoreThanOneWithoutContact) {
  BoundedRun free(hingedBlock(kPasses), {.tolerance = 1e-8});
  BoundedRun touching(hingedBlock(kTouches), {.tolerance = 1e-8, .evaluations = 20'000});
  free.run(), touching.run();
  ASSERT_TRUE(free.finished()) << free.report().reason;
  ASSERT_NEAR(free.last(), kAngle, 1e-7);  // ten tolerances (theory 50.6)
  ASSERT_TRUE(touching.finished()) << touching.report().reason;
  EXPECT_NEAR(touching.last(), kAngle, 1e-7);
  // The contact neither opens nor bears: ten times the work leaves room for its switches.
  EXPECT_LE(touching.report().cost.evaluations, 10 * free.report().cost.evaluations);
}

}  // namespace
}  // namespace dynamy
