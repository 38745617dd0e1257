// Runs to a tolerance with preloaded springs, whose set lives on displacements, against closed
// forms of their linear pieces.
#include <gtest/gtest.h>

#include <cmath>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

/// A body of 2 kg on a line with `force` [N], a formula, a spring of 50 N/m with the preload 3 N
/// and Coulomb friction; its start.
std::string notchBody(const std::string& force, const std::string& start, const std::string& law,
                      double friction = 0.0) {
  return R"xml(<dynamy version="1"><systems><Coordinates name="body" q="x" q0=")xml" + start +
         R"xml(" M="2" h=")xml" + force + R"xml("/></systems><elements>
  <CoordinateContact name="spring" on="body" gap="x">)xml" +
         law + R"xml(</CoordinateContact>)xml" +
         (friction > 0.0
              ? R"xml(<CoordinateContact name="rail" on="body" slipVelocity="x_dot"><GivenFriction force=")xml" +
                    numberText(friction) + R"xml("/></CoordinateContact>)xml"
              : "") +
         R"xml(</elements><simulation until="1" step="1"/></dynamy>)xml";
}

constexpr double kMass = 2.0, kStiffness = 50.0, kPreload = 3.0;
constexpr const char* kBoth = R"(<PreloadedSpring stiffness="50" preload="3"/>)";
constexpr const char* kOne = R"(<PreloadedSpring stiffness="50" preload="3" sides="one"/>)";
const double kOmega = std::sqrt(kStiffness / kMass);

TEST(LocatedNotch, IsPassedWithAJumpOfTheForceAndKeepsTheEnergy) {
  // From the turning point A the way to the middle takes acos(a/(c A + a))/w, the period four of
  // it; behind 40 passes and an eighth of a swing x = (A + a/c) cos(w t) − a/c.
  constexpr double A = 0.3;
  const double quarter = std::acos(kPreload / (kStiffness * A + kPreload)) / kOmega;
  const double rest = 0.5 * quarter, until = 80.0 * quarter + rest;
  for (const double tol : {1e-6, 1e-10}) {
    LocatedRun run(notchBody("0", "0.3", kBoth), tol, until);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    const double x = (A + kPreload / kStiffness) * std::cos(kOmega * rest) - kPreload / kStiffness;
    EXPECT_NEAR(run.state().q[0], x, 10.0 * tol);  // calibration; nothing amplifies
    const double v = -(A + kPreload / kStiffness) * kOmega * std::sin(kOmega * rest);
    EXPECT_NEAR(run.state().u[0], v, 10.0 * kOmega * tol);
    EXPECT_EQ(run.report().contacts.switches, 40);
    EXPECT_EQ(run.report().contacts.impacts, 0);
    EXPECT_EQ(run.report().located.undecided, 0);
    // V = c x²/2 + a |x| comes back whole: the work of the law is that between the ends.
    const double stored = 0.5 * kStiffness * (0.09 - x * x) + kPreload * (0.3 - std::abs(x));
    EXPECT_NEAR(run.report().energy.friction, stored, 200.0 * tol) << tol;  // 18 N · 10 tol
    EXPECT_NEAR(run.report().energy.discretisation, 0.0, 200.0 * tol) << tol;
  }
}

TEST(LocatedNotch, HoldsUpToThePreloadAndYieldsBeyond) {
  // A force that grows by 4 N/s passes the preload after 0.75 s: m ẍ + c x = k τ from rest,
  // x = k/c (τ − sin(w τ)/w).
  LocatedRun run(notchBody("4*t", "0", kBoth), 1e-10, 2.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  const double tau = 2.0 - 0.75;
  EXPECT_NEAR(run.state().q[0], 4.0 / kStiffness * (tau - std::sin(kOmega * tau) / kOmega), 1e-9);
  const auto yields = run.changes("spring", Status::lower);
  ASSERT_EQ(yields.size(), 1u);
  EXPECT_NEAR(yields[0], 0.75, 1e-9);  // the tolerance over the rate 4/3 of the force

  LocatedRun held(notchBody("2.9*sin(3*t)", "0", kBoth), 1e-8, 5.0);
  ASSERT_EQ(held.run().ended, RunReport::Ended::finished) << held.report().reason;
  EXPECT_EQ(held.state().q[0], 0.0);
  EXPECT_EQ(held.state().u[0], 0.0);
  EXPECT_EQ(held.report().contacts.switches, 0);
}

TEST(LocatedNotch, IsTouchedAndLeftAgainUnderALoadBeyondThePreload) {
  // Loaded with 5 N at once from rest: about (5 − a)/c with the period 2π/w, back at the middle
  // without speed each time.
  for (const double periods : {0.5, 3.0, 3.5}) {
    LocatedRun run(notchBody("5", "0", kBoth), 1e-9,
                   periods * 2.0 * 3.14159265358979323846 / kOmega);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    const double middle = (5.0 - kPreload) / kStiffness;
    const double x = periods == 3.0 ? 0.0 : 2.0 * middle;
    EXPECT_NEAR(run.state().q[0], x, 1e-8) << periods;
  }
}

TEST(LocatedNotch, CatchesWithFrictionAfterInfinitelyManyPasses) {
  // Without stiffness: a pass with v takes v m (1/(a + f) + ρ/(a − f)), ρ² = (a − f)/(a + f), until
  // the next with ρ v. Their sum ends at T = v m (1/(a + f) + ρ/(a − f))/(1 − ρ).
  const double f = 1.0, v = 1.5, rho = std::sqrt((kPreload - f) / (kPreload + f));
  const double T = v * kMass * (1.0 / (kPreload + f) + rho / (kPreload - f)) / (1.0 - rho);
  const std::string scene =
      notchBody("0", R"(0" u0="1.5)", R"(<PreloadedSpring stiffness="0" preload="3"/>)", f);
  for (const double tol : {1e-4, 1e-6, 1e-8, 1e-10}) {
    LocatedRun run(scene, tol, 2.0 * T);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    const auto caught = run.changes("spring", Status::locked);
    ASSERT_EQ(caught.size(), 1u) << tol;
    // What is left of the sequence at a height of z tol, z = 0.1, a pass before: T − t is T v'/v
    // with v'² = 2 (a + f) z tol/m at most, and at least a pass earlier.
    const double left = T / v * std::sqrt(2.0 * (kPreload + f) * 0.1 * tol / kMass);
    EXPECT_LE(T - caught[0], 1.01 * left) << tol;
    EXPECT_GE(T - caught[0], 0.99 * rho * left) << tol;
    EXPECT_EQ(run.report().located.accumulations, 1);
    EXPECT_NEAR(run.state().q[0], 0.0, 1e-12);
    EXPECT_EQ(run.state().u[0], 0.0);
    EXPECT_EQ(run.report().located.undecided, 0);
  }
}

TEST(LocatedNotch, ThrowsBackFromOneSideOrHoldsTheWeight) {
  // Falls with 1 m/s on a buffer, m g = 19.62 N over its preload: x = −d + R cos(w t + φ),
  // R cos φ = d = (m g − a)/c, R sin φ = 1/w; deepest at w t + φ = π, off again in twice that time
  // with 1 m/s, and as a throw behind.
  const double d = (kMass * 9.81 - kPreload) / kStiffness, R = std::hypot(d, 1.0 / kOmega);
  const double away = 2.0 * (3.14159265358979323846 - std::atan2(1.0 / kOmega, d)) / kOmega;
  LocatedRun deepest(notchBody("-19.62", R"(0" u0="-1)", kOne), 1e-10, 0.5 * away);
  ASSERT_EQ(deepest.run().ended, RunReport::Ended::finished) << deepest.report().reason;
  EXPECT_NEAR(deepest.state().q[0], -d - R, 1e-9);
  EXPECT_NEAR(deepest.state().u[0], 0.0, 1e-8);
  LocatedRun thrown(notchBody("-19.62", R"(0" u0="-1)", kOne), 1e-10, away + 1.0 / 9.81);
  ASSERT_EQ(thrown.run().ended, RunReport::Ended::finished) << thrown.report().reason;
  EXPECT_NEAR(thrown.state().q[0], 0.5 / 9.81, 1e-9);
  EXPECT_NEAR(thrown.state().u[0], 0.0, 1e-8);

  LocatedRun rests(notchBody("-2.5", "0", kOne), 1e-8, 1.0);  // below the preload
  ASSERT_EQ(rests.run().ended, RunReport::Ended::finished) << rests.report().reason;
  EXPECT_EQ(rests.state().q[0], 0.0);
  EXPECT_EQ(rests.report().contacts.switches, 0);
}

TEST(LocatedNotch, IsFollowedInRotations) {
  // models/preloaded_stop.xml: turning points and periods there.
  LocatedRun run("preloaded_stop", 1e-10, 3.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  // The first arm, from the middle at 10 rad/s: 3 s are n quarters of its period and a rest; beside
  // the middle φ = (A + a/c) cos(w t) − a/c with t from its turning point.
  const double a = 2.0, c = 5.0, J = 0.1, w = std::sqrt(c / J);
  const double A = (std::sqrt(a * a + c * J * 100.0) - a) / c;
  const double quarter = std::acos(a / (c * A + a)) / w, n = std::floor(3.0 / quarter);
  const double rest = 3.0 - n * quarter;
  const auto even = static_cast<long>(n) % 2 == 0;
  const double side = static_cast<long>(n) % 4 < 2 ? 1.0 : -1.0;
  const double out = even ? quarter - rest : rest;  // from the turning point
  EXPECT_NEAR(run.signal("arm[0].phi"), side * ((A + a / c) * std::cos(w * out) - a / c), 1e-8);
}

TEST(LocatedNotch, ARopeWithASpringSwingsLikeOne) {
  // 2 kg on an elastic rope of 1 m with 800 N/m, let go 30 mm stretched, 5.475 mm below its rest: it
  // never becomes slack, z = −1.024525 − 0.005475 cos 20t.
  const std::string scene = R"xml(<dynamy version="1"><systems>
    <PointMass name="car" mass="2" position="0 0 -1.03"/><Ground name="world"/></systems>
    <forces><Gravity/></forces><elements><Rope name="rope" through="world car" length="1">
    <PreloadedSpring stiffness="800" sides="one"/></Rope></elements>
    <simulation until="0.7" step="1e-3"/></dynamy>)xml";
  const double exact = -1.024525 - 0.005475 * std::cos(14.0);
  LocatedRun run(scene, 1e-10, 0.7);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  // An undamped oscillator keeps the errors of its steps, of which there are some forty.
  EXPECT_NEAR(run.state().q[2], exact, 4e-9);

  Registry registry;
  PluginLoader plugins({DYNAMY_BINARY_DIR "/lib/dynamy"});
  registerFramework(registry);
  plugins.load(kStandardElements, {}, registry);
  Model model = loadModelText(scene, "scene.xml", registry, plugins, {});
  Simulation simulation(model);
  ASSERT_EQ(simulation.run().ended, RunReport::Ended::finished);
  // The force of a step is that at its end, implicit Euler's: it damps by ω²Δt/2 = 0.2 1/s, of which
  // 13 % of the amplitude are gone after 0.7 s, and shifts the phase by less.
  EXPECT_NEAR(simulation.state().q[2], exact, 0.15 * 0.005475);
}

}  // namespace
}  // namespace dynamy::reference
