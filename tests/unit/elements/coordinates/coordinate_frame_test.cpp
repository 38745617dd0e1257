// Forces on a frame whose orientation is a formula: closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

/// phi at t = 1 s of a rotor (J = 1 kg m²) under `force`.
double angleAfter(const std::string& force, const std::string& how) {
  BlockScene scene(R"(<dynamy version="1"><systems><Ground name="world"/>
    <Coordinates name="arm" q="phi" M="1"><CoordinateFrame name="body" angle="phi" axis="0 1 0"/>
    </Coordinates></systems><forces>)" +
                   force + R"(</forces><simulation until="1" )" + how + "/></dynamy>");
  return scene.signal(scene.run(), "arm.phi");
}

TEST(CoordinateFrame, TurnsUnderAMomentByItsLaw) {
  // φ̈ = 1: φ = t²/2, of second degree, so that every scheme is exact. The rotation's Jacobian was
  // added up from one evaluation to the next, and φ was 168 rad.
  for (const char* how : {R"(tolerance="1e-8")", R"(step="1e-2")"})
    EXPECT_NEAR(angleAfter(R"(<ForceInput on="arm.body" force="0; 0; 0" moment="0; 1; 0"/>)", how),
                0.5, 1e-12)
        << how;
}

TEST(CoordinateFrame, TurnsUnderAForceBesideItsOriginAsUnderItsMoment) {
  // A force of 1 N at a point that turns with the frame, across its arm of 1 m: the moment is 1 N m.
  const double phi =
      angleAfter(R"(<ForceInput on="arm.body" point="1 0 0" axes="frame" force="0; 0; -1"/>)",
                 R"(tolerance="1e-8")");
  EXPECT_NEAR(phi, 0.5, 1e-8);
}

}  // namespace
}  // namespace dynamy
