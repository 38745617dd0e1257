// Contacts that say the same of one coordinate: a solver may give all of the force to one of them, and
// rounding alone decides which of their gaps is the smallest.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <reference/located/located_run.hpp>
#include <string>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

/// Sums of the forces along z of all contacts, by instants after the start.
std::map<double, double> loads(const LocatedRun& run) {
  std::map<double, double> out;
  for (const LocatedRun::Picture& p : run.film)
    for (const ContactRecord& c : p.contacts)
      if (p.t > 0.0) out[p.t] += std::abs(c.force.z());
  return out;
}

TEST(LocatedCam, CarriesItsFlatFollowerWithBothRims) {
  // A round cam turns about a point e beside its middle; m (z̈ + g) = N with z = e sin ωt + const.
  constexpr double m = 2.0, e = 0.02, omega = 5.0 * std::numbers::pi;
  for (const char* coordinates : {"auto", "absolute"}) {
    LocatedRun run(std::string(R"xml(<dynamy version="1"><systems>
      <Ground name="cam" rotation="5*pi*t" axis="0 -1 0"><Cylinder name="disc" radius="50mm" length="20mm"
        position="20mm 0 0" euler="90deg 0 0" material="steel"/></Ground><Ground name="world"/>
      <RigidBody name="follower" position="0 0 55mm"><Box size="160mm 40mm 10mm" mass="2"
        material="steel"/></RigidBody></systems><forces><Gravity/></forces><elements>
      <Prismatic name="guide" between="world follower" axis="0 0 1"/>
      <Contact between="steel steel"><UnilateralCoulomb mu="0.2"/></Contact></elements>
      <simulation until="1" tolerance="1e-8" coordinates=")xml") +
                       coordinates + R"xml("/></dynamy>)xml",
                   1e-8, 0.8);
    run.record(0.8, 50.0);
    const RunReport& r = run.run();
    ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
    // Two turns; each step that ended where a gap is rounding was a hundredth of a degree.
    EXPECT_LT(r.steps, 40) << coordinates;
    const auto found = loads(run);
    EXPECT_GE(found.size(), 40u);
    for (const auto& [t, N] : found)
      EXPECT_NEAR(N, m * (kG - e * omega * omega * std::sin(omega * t)), 1e-8 * m * kG) << t;
  }
}

TEST(LocatedCam, LiftCarriesATableOfThreeLegs) {
  // The lift moves as told, and the table can move along z alone: N = m (g + z̈), z = −0.02 sin² 5t.
  constexpr double m = 3.0;
  LocatedRun run(R"xml(<dynamy version="1"><systems>
    <Ground name="lift" motion="0; 0; -0.02*sin(5*t)^2"><HalfSpace material="m"/></Ground>
    <Ground name="world"/>
    <RigidBody name="table" position="0 0 0.1" mass="3" inertia="1 1 1">
      <Sphere radius="0.1" position="0.3 0.1 0" material="m"/>
      <Sphere radius="0.1" position="-0.2 0.3 0" material="m"/>
      <Sphere radius="0.1" position="-0.1 -0.4 0" material="m"/></RigidBody></systems>
    <forces><Gravity/></forces><elements><Prismatic between="world table" axis="0 0 1"/>
    <Contact between="m m"><UnilateralCoulomb mu="0.3"/></Contact></elements>
    <simulation until="1" tolerance="1e-8"/></dynamy>)xml",
                 1e-8, 1.0);
  run.record(1.0, 50.0);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_LT(r.steps, 60);
  for (const auto& [t, N] : loads(run))
    EXPECT_NEAR(N, m * (kG - 0.02 * 50.0 * std::cos(10.0 * t)), 1e-8 * m * kG) << t;
}

}  // namespace
}  // namespace dynamy::reference
