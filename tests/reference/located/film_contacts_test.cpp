// Pictures within a step show contacts where they are then, with their forces then.
#include <gtest/gtest.h>

#include <cmath>
#include <reference/located/located_run.hpp>
#include <string>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

TEST(FilmContacts, OfASlidingBodyAreUnderItWithItsForces) {
  // A puck slides to rest in a few long steps: it begins with 3 m/s, μ = 0.2, m = 2 kg.
  for (const char* clocks : {"one", "islands"}) {
    const std::string text = std::string(R"xml(<dynamy version="1"><systems>
      <PointMass name="puck" mass="2" position="0 0 0" velocity="3 0 0"><Point material="ice"/></PointMass>
      <PointMass name="other" mass="1" position="0 9 1"><Point material="ice"/></PointMass>
      <Ground name="world"><HalfSpace material="floor"/></Ground></systems>
      <forces><Gravity/></forces><elements>
      <Contact between="ice floor"><UnilateralCoulomb mu="0.2" epsilonN="0.5"/></Contact></elements>
      <simulation until="1" tolerance="1e-8"/></dynamy>)xml");
    LocatedRun run(text, 1e-8, 2.0, {}, {},
                   std::make_unique<LocatedDormandPrince>(Parameters::of<LocatedDormandPrince>(
                       "LocatedDormandPrince", "", {{"clocks", clocks}})));
    run.record(2.0, 50.0);
    const RunReport& r = run.run();
    ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
    ASSERT_LT(r.steps, 60);  // fewer steps than pictures
    const double rest = 3.0 / (0.2 * kG);
    int seen = 0;
    for (const LocatedRun::Picture& p : run.film) {
      const double x = p.t < rest ? 3.0 * p.t - 0.1 * kG * p.t * p.t : 1.5 * rest;
      for (const ContactRecord& c : p.contacts) {
        if (c.point.y() > 1.0) continue;  // of the other body, which bounces
        ++seen;
        EXPECT_NEAR(c.point.x(), x, 1e-10) << p.t;  // constant forces: steps are exact
        EXPECT_NEAR(c.force.z(), 2.0 * kG, 1e-10) << p.t;
        EXPECT_NEAR(c.limit, 0.4 * kG, 1e-10);
        if (p.t < rest) {
          EXPECT_NEAR(c.force.x(), -0.4 * kG, 1e-10) << p.t;
          EXPECT_EQ(c.status, Status::slip) << p.t;
        } else {
          EXPECT_NEAR(c.force.x(), 0.0, 1e-10) << p.t;
          EXPECT_EQ(c.status, Status::stick) << p.t;
        }
      }
    }
    // All but the first picture, also those of the other one's impacts.
    EXPECT_EQ(seen, static_cast<int>(run.film.size()) - 1) << clocks;
    EXPECT_GT(run.film.size(), 101u);
  }
}

TEST(FilmContacts, OfImpactsHaveAPictureAtTheirInstant) {
  LocatedRun run(R"xml(<dynamy version="1"><systems>
    <PointMass name="ball" mass="2" position="0 0 1"><Sphere radius="0.1" material="ball"/></PointMass>
    <Ground name="world"><HalfSpace material="floor"/></Ground></systems><forces><Gravity/></forces>
    <elements><Contact between="ball floor"><Unilateral epsilonN="0.5"/></Contact></elements>
    <simulation until="1" tolerance="1e-9"/></dynamy>)xml",
                 1e-9, 1.0);
  run.record(1.0, 10.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  // Let go 0.9 m above the floor: impacts after t₁ = √(1.8/g) and 2 t₁, then with half the speed
  // each. Between them are the eleven pictures of the film.
  const double first = std::sqrt(1.8 / kG);
  int found = 0;
  for (const LocatedRun::Picture& p : run.film)
    for (const ContactRecord& c : p.contacts) {
      if (!c.impact) continue;
      EXPECT_NEAR(p.t, ++found * first, 1e-12);
      EXPECT_NEAR(p.poses[0].r_OS_I.z(), 0.1, 1e-12);
    }
  EXPECT_EQ(found, 2);
  EXPECT_EQ(run.film.size(), 13u);
}

}  // namespace
}  // namespace dynamy::reference
