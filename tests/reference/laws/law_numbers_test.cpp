/// Laws that no other test compares with a number from outside: friction that weakens with speed on
/// a contact, and a contact that pulls.
#include <gtest/gtest.h>

#include <reference/order.hpp>
#include <reference/scene.hpp>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

/// A block of 1 kg that touches a plane with the outward normal n at its middle.
std::string block(const std::string& normal, const std::string& velocity, const std::string& law,
                  const std::string& force = {}, const std::string& scheme = {}) {
  return R"(<dynamy version="1">
  <systems>
    <PlanarBody name="block" mass="1" inertia="1" velocity=")" +
         velocity + R"("><Point material="wood"/></PlanarBody>
    <Ground name="world"><HalfSpace normal=")" +
         normal + R"(" material="ice"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/>)" +
         (force.empty() ? "" : "<ForceInput on=\"block\" force=\"" + force + "\"/>") +
         R"(</forces>
  <elements><Contact between="wood ice">)" +
         law + R"(</Contact></elements>
  <simulation until="1" step="0.01">)" +
         (scheme.empty() ? "" : "<" + scheme + "/>") + R"(</simulation>
</dynamy>)";
}

// mu(v) = m + d/(1 + x), x = v/s, v̇ = −g mu(v) from v₀:
//   t = s/(g m) [x₀ − x − (d/m) ln((m (1 + x₀) + d)/(m (1 + x) + d))]
constexpr double kM = 0.1, kD = 0.3, kS = 0.2;

double timeDownTo(double v) {
  const auto at = [](double x) { return kM * (1.0 + x) + kD; };
  const double x0 = 1.0 / kS, x = v / kS;
  return kS / (kG * kM) * (x0 - x - kD / kM * std::log(at(x0) / at(x)));
}

double velocityAfter(double t) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double v = 0.5 * (low + high);
    (timeDownTo(v) > t ? low : high) = v;
  }
  return low;
}

TEST(UnilateralStribeck, SlowsABlockAsTheClosedFormSays) {
  const double truth = velocityAfter(0.4);
  const std::string law =
      R"(<UnilateralStribeck mu="0.4" kineticMu="0.1" speed="0.2" decay="rational"/>)";
  std::vector<double> dt = halvings(0.02, 5), v, error;
  for (const double h : dt) {
    Scene scene("weakening", {.text = block("0 0 1", "1 0 0", law)});
    scene.run(0.4, h);
    EXPECT_TRUE(scene.solved());
    v.push_back(scene.u("block")[0]), error.push_back(std::abs(v.back() - truth));
  }
  // The law takes the speed of the beginning of the step: order 1, in whole powers of Δt. Five
  // levels leave Δt⁵ with a constant of the derivatives' size, 15/s each: (15 · 0.02)⁵/2^15 of 1
  // m/s.
  EXPECT_NEAR(fitOrder(dt, error).order, 1.0, 0.1) << fitOrder(dt, error);
  EXPECT_NEAR(richardson(v, 1, 1), truth, 1e-6);
}

TEST(UnilateralStribeck, StopsABlockAfterTheTimeOfTheClosedForm) {
  // s/(g m) [x₀ − (d/m) ln 2.25] = 0.5234 s; an error of the speed of Δt · 15/s, as above, which
  // the friction at rest, 3.9 m/s², takes away: 4 Δt.
  Scene scene("weakening",
              {.text = block("0 0 1", "1 0 0",
                             R"(<UnilateralStribeck mu="0.4" kineticMu="0.1" speed="0.2"
                                          decay="rational"/>)")});
  const double end = timeDownTo(0.0), dt = 1e-4;
  EXPECT_NEAR(end, 0.52339, 1e-5);
  scene.run(end - 4.0 * dt, dt);
  EXPECT_GT(scene.u("block")[0], 0.0);
  scene.run(end + 4.0 * dt, dt);
  // Held: residual of the solver.
  EXPECT_NEAR(scene.u("block")[0], 0.0, 1e-10);
}

// Under a ceiling that pulls with up to 12 N hangs 1 kg.
const char* const kMagnet = R"(<UnilateralAdhesion force="12" mu="0.5"/>)";

// Pulled with 2 t more: off at t_s = (12 − 9.81)/2 s = 1.095 s, then x'' = −(12 + 2 τ), τ = t −
// t_s: x = −(6 τ² + τ³/3), x' = −(12 τ + τ²).
constexpr double kOff = 1.095, kAfter = 0.5;

/// Speed that is missing half a second after the load is torn off [m/s].
double missingSpeed(Scheme scheme, double dt, const std::string& name = {}) {
  Scene scene("magnet",
              {.scheme = scheme, .text = block("0 0 -1", "0 0 0", kMagnet, "0; 0; -2*t", name)});
  // Until a step before it is at rest: residual of the solver.
  const double before = dt * std::floor(kOff / dt - 0.5);
  scene.run(before, dt);
  EXPECT_NEAR(scene.u("block").norm(), 0.0, 1e-10);
  EXPECT_NEAR(scene.q("block").norm(), 0.0, 1e-10);
  scene.run(kOff + kAfter, dt);
  return scene.u("block")[1] + 12.0 * kAfter + kAfter * kAfter;
}

TEST(UnilateralAdhesion, TearsOffWhereThePullEnds) {
  // Let go up to two steps late, of 12 m/s².
  for (const double dt : {1e-2, 1e-3})
    EXPECT_NEAR(missingSpeed(Scheme::moreauMidpoint, dt), 0.0, 2.0 * dt * 13.0);
}

TEST(UnilateralAdhesion, TearsOffWhereThePullEndsWhereGapsAreInTheLaw) {
  // The load that is not held moves away by at least 2 N/s Δt/2 · Δt² in a step: 8e-12 m at 2e-4 s,
  // more than g_tol. It pulls for up to a step as well.
  for (const char* const name : {"StaggeredMoreau", "EnergyMomentum", "PaoliSchatzman", "Ggl",
                                 "NonsmoothRattle", "StewartTrinkle", "AnitescuPotra"})
    for (const double dt : {4e-3, 1e-3, 2e-4})
      EXPECT_NEAR(missingSpeed(Scheme::asTheModelSays, dt, name), 0.0, 3.0 * dt * 13.0)
          << name << ", step " << dt;
}

TEST(UnilateralAdhesion, HasFrictionOfWhatIsLeftOfItsPull) {
  // N + 12 N = 12 − 9.81: at most 0.5 · 2.19 N = 1.095 N sideways. Constant forces are exact but
  // for the solver's residual, 1e-10 of g Δt in each of 100 steps.
  Scene held("magnet", {.text = block("0 0 -1", "0 0 0", kMagnet, "1.09; 0; 0")});
  held.run(1.0, 0.01);
  EXPECT_NEAR(held.q("block")[0], 0.0, 1e-9);
  Scene pushed("magnet", {.text = block("0 0 -1", "0 0 0", kMagnet, "3; 0; 0")});
  pushed.run(1.0, 0.01);
  EXPECT_NEAR(pushed.u("block")[0], 3.0 - 1.095, 1e-9);
  EXPECT_NEAR(pushed.q("block")[0], 0.5 * (3.0 - 1.095), 1e-9);
  EXPECT_NEAR(pushed.q("block")[1], 0.0, 1e-9);
}

}  // namespace
}  // namespace dynamy::reference
