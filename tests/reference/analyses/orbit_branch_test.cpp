// Branches of periodic orbits: instabilities and changes of switches against closed forms, and
// against solutions with 30 digits.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <dynamy/io/model/file_branch.hpp>
#include <dynamy/io/model/file_orbit.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>

namespace dynamy {
namespace {

struct Branches {
  Registry registry;
  PluginLoader plugins{{DYNAMY_BINARY_DIR "/lib/dynamy"}};
  Branches() {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
  }
  OrbitBranch ofModel(const std::string& file, const std::string& over, const Overrides& set = {}) {
    return branch({.orbit = {.file = DYNAMY_SOURCE_DIR "/models/" + file + ".xml", .set = set},
                   .over = over},
                  registry, plugins)
        .branch;
  }
  Orbit orbitOf(const std::string& model, const Overrides& set) {
    return orbit({.file = DYNAMY_SOURCE_DIR "/models/" + model + ".xml", .set = set}, registry,
                 plugins);
  }
  OrbitBranch ofText(const std::string& text, const std::string& name,
                     const BranchRequest& request) {
    return orbitBranch(
        [&](double value, OrbitSection& section) {
          LoadOptions options;
          options.orbit = &section, options.set = {{name, fmt::format("{}", value)}};
          return loadModelText(text, "test.xml", registry, plugins, options);
        },
        request);
  }
};

const BranchPoint* pointOf(const OrbitBranch& b, const std::string& kind) {
  for (const BranchPoint& p : b.points)
    if (p.kind == kind) return &p;
  ADD_FAILURE() << "no " << kind;
  return nullptr;
}

TEST(OrbitBranch, OfTheWalkerDoublesItsPeriodAtThePublishedSlope) {
  const OrbitBranch b = Branches().ofModel("simplest_walker", "gamma=0.008:0.016:12");
  const BranchPoint* flip = pointOf(b, "flip");
  ASSERT_NE(flip, nullptr);
  // Found with 30 digits; its last digit is 1e-13.
  EXPECT_NEAR(flip->p, 0.0150884379411, 1e-9);
  EXPECT_NEAR(flip->multipliers[0].real(), -1.0, 1e-8);
  EXPECT_TRUE(b.points.front().stable);
  EXPECT_FALSE(b.points.back().stable);
  EXPECT_EQ(b.points.front().p, 0.008);
  EXPECT_EQ(b.points.back().p, 0.016);
  // The orbit of the model's own value is one of them, with its period to ten digits.
  EXPECT_EQ(b.points[b.start].p, 0.009);
  EXPECT_NEAR(b.points[b.start].period, 3.88246375285137, 1e-9);
}

TEST(OrbitBranch, OfTheWoodpeckerDoublesItsPeriodWhereverItsPointsLie) {
  // Derivatives on the way are coarse; the place is found by fine ones. Two ranges, and the multiplier
  // by an orbit of its own.
  double found[2] = {0.0, 1.0};
  const char* ranges[] = {"mu=0.3:0.33:12", "mu=0.31:0.32:5"};
  Branches branches;
  for (int i = 0; i < 2; ++i) {
    const OrbitBranch b = branches.ofModel("woodpecker", ranges[i]);
    const BranchPoint* flip = pointOf(b, "flip");
    ASSERT_NE(flip, nullptr) << ranges[i];
    found[i] = flip->p;
  }
  // Multipliers are good to 2e-8 (theory 54.6), and change by 6.6 over a unit of μ: 3e-9.
  EXPECT_NEAR(found[0], found[1], 3e-9);
  // There the orbit itself, found anew, has the multiplier −1; its differences are of fourth order.
  const Orbit o = branches.orbitOf("woodpecker", {{"mu", fmt::format("{:.12g}", found[0])}});
  ASSERT_EQ(o.multipliers.size(), 1);
  EXPECT_NEAR(o.multipliers[0].real(), -1.0, 2e-8);
}

/// A forced oscillator that does not reach its wall: it is first touched where
/// (1 − ω²)² + (2ζω)² = (F/a)², here from both sides.
TEST(OrbitBranch, OfAForcedOscillatorEndsWhereItGrazesTheWall) {
  const std::string text = R"x(<dynamy version="1"><parameter name="omega" value="0.5"/>
    <systems><Coordinates name="m" q="x" q0="1" M="1" h="-x - 0.2*x_dot + cos(omega*t)"/></systems>
    <elements><CoordinateContact name="wall" on="m" gap="1.5 - x"><Unilateral epsilonN="0.7"/></CoordinateContact></elements>
    <simulation until="40" tolerance="1e-9"/>
    <orbit period="{6.283185307179586/omega}"/></dynamy>)x";
  Branches branches;
  const double a = 1.5, zeta = 0.1;
  for (const double side : {-1.0, 1.0}) {
    // ω⁴ − 2(1 − 2ζ²)ω² + 1 − 1/a² = 0
    const double half = 1.0 - 2.0 * zeta * zeta;
    const double exact = std::sqrt(half + side * std::sqrt(half * half - 1.0 + 1.0 / (a * a)));
    const BranchRequest request =
        side < 0.0 ? BranchRequest{.from = 0.5, .to = 0.9, .at = 0.5, .points = 8}
                   : BranchRequest{.from = 1.0, .to = 1.5, .at = 1.5, .points = 8};
    const OrbitBranch b = branches.ofText(text, "omega", request);
    const BranchPoint* grazing = pointOf(b, "grazing");
    ASSERT_NE(grazing, nullptr);
    EXPECT_NEAR(grazing->p, exact, 1e-8);
    EXPECT_NE(grazing->text.find("wall"), std::string::npos) << grazing->text;
    EXPECT_NE(grazing->text.find("is touched"), std::string::npos) << grazing->text;
    EXPECT_TRUE(grazing->stable);
    EXPECT_EQ(grazing, side < 0.0 ? &b.points.back() : &b.points.front());
  }
}

/// A ball that bounces once a period on a table A cos(ωt): with v = gT/2 (1 − ε)/(1 + ε) the speed of
/// the table at the impact, the two such motions meet where Aω = v, with a multiplier of 1, and one
/// of them becomes unstable where (1 + ε)² a/g = −2(1 + ε²), a = ±√(A²ω² − v²) ω.
TEST(OrbitBranch, OfABouncingBallGoesThroughItsFoldAndItsFlip) {
  const double g = 9.81, e = 0.8, omega = 10.0, T = 6.283185307179586 / omega;
  const double v = 0.5 * g * T * (1.0 - e) / (1.0 + e);
  const double A = 0.04, sine = -v / (A * omega);
  const double psi = std::atan2(sine, std::sqrt(1.0 - sine * sine)) - 0.5 * omega * T;
  const double top = A * std::sqrt(1.0 - sine * sine) + g * T * T / 8.0;
  const std::string text =
      "<dynamy version=\"1\"><parameter name=\"A\" value=\"0.04\"/><systems><Coordinates "
      "name=\"ball\" q=\"y\" q0=\"" +
      fmt::format("{:.17g}", top) +
      "\" M=\"1\" h=\"-9.81\"/></systems><elements><CoordinateContact name=\"table\" on=\"ball\" "
      "gap=\"y - A*cos(10*t + " +
      fmt::format("{:.17g}", psi) +
      ")\"><Unilateral epsilonN=\"0.8\"/></CoordinateContact></elements><simulation until=\"1\" "
      "tolerance=\"1e-9\"/><orbit period=\"" +
      fmt::format("{:.17g}", T) + "\"/></dynamy>";
  const OrbitBranch b =
      Branches().ofText(text, "A", {.from = 0.03, .to = 0.12, .at = 0.04, .points = 15});
  const BranchPoint* fold = pointOf(b, "fold");
  const BranchPoint* flip = pointOf(b, "flip");
  ASSERT_TRUE(fold != nullptr && flip != nullptr);
  EXPECT_NEAR(fold->p, v / omega, 1e-8);
  const double a = 2.0 * g * (1.0 + e * e) / ((1.0 + e) * (1.0 + e));
  EXPECT_NEAR(flip->p, std::hypot(v / omega, a / (omega * omega)), 1e-8);
  // Both ends of the branch are at the upper bound.
  EXPECT_EQ(b.points.front().p, 0.12);
  EXPECT_EQ(b.points.back().p, 0.12);
}

TEST(OrbitBranch, FollowsAnOrbitToAValueThatNewtonDoesNotReach) {
  Branches branches;
  FileOrbit wanted;
  wanted.file = DYNAMY_SOURCE_DIR "/models/simplest_walker.xml";
  // The period-one gait at 0.018, which is unstable, with the start for 0.009.
  wanted.set = {{"gamma", "0.018"}, {"theta0", "0.15"}, {"speed0", "-0.15"}};
  const Orbit far = orbit(wanted, branches.registry, branches.plugins);
  const OrbitBranch b = branches.ofModel("simplest_walker", "gamma=0.009:0.018:12");
  EXPECT_NEAR(far.period, b.points.back().period, 1e-9);
}

/// Trials of Newton's method at 0.018 tumble with ever more switches: they end, and the orbit is
/// followed from the model's own slope.
TEST(OrbitBranch, EndsTrialsThatTumbleAndFollowsTheOrbitInstead) {
  Branches branches;
  FileOrbit wanted;
  wanted.file = DYNAMY_SOURCE_DIR "/models/simplest_walker.xml";
  wanted.set = {{"gamma", "0.018"}};
  const Orbit far = orbit(wanted, branches.registry, branches.plugins);
  const OrbitBranch b = branches.ofModel("simplest_walker", "gamma=0.009:0.018:12");
  EXPECT_NEAR(far.period, b.points.back().period, 1e-9);
  EXPECT_LT(far.multipliers[0].real(), -1.0);
}

/// An oscillator with a wall and the damping d: the product of both multipliers is ε² exp(−dT), so
/// that a pair of them passes the unit circle where d = 2 ln ε/T.
TEST(OrbitBranch, OfAnImpactOscillatorPassesTheUnitCircleWhereItsDampingIsNegative) {
  const OrbitBranch b = Branches().ofText(
      R"x(<dynamy version="1"><parameter name="d" value="0"/>
    <systems><Coordinates name="m" q="x" q0="-0.9" u0="-0.4" M="1" h="-x - d*x_dot + cos(2.2*t)"/></systems>
    <elements><CoordinateContact name="wall" on="m" gap="-x"><Unilateral epsilonN="0.8"/></CoordinateContact></elements>
    <simulation until="10" tolerance="1e-9"/><orbit period="{6.283185307179586/2.2}"/></dynamy>)x",
      "d", {.from = -0.2, .to = 0.05, .at = 0.0, .points = 8});
  const BranchPoint* point = pointOf(b, "Neimark-Sacker");
  ASSERT_NE(point, nullptr);
  EXPECT_NEAR(point->p, 2.0 * std::log(0.8) / (6.283185307179586 / 2.2), 1e-8);
  EXPECT_FALSE(b.points.front().stable);
  EXPECT_TRUE(b.points.back().stable);
}

/// A mass with dry friction f and the force cos βt moves without stops as long as
/// f² (1/(V − 1)² + (S/(Vβ(1 + C)))²) < 1, V = 1/(1 − β²), C and S of π/β [denhartog1931].
TEST(OrbitBranch, OfAMassWithDryFrictionBeginsToStick) {
  const OrbitBranch b = Branches().ofText(
      R"x(<dynamy version="1"><parameter name="f" value="0.3"/>
    <systems><Coordinates name="m" q="x" q0="1.5" u0="0.5" M="1" h="-x + cos(0.7*t)"/></systems>
    <elements><CoordinateContact name="dry" on="m" slipVelocity="x_dot"><GivenFriction force="{f}"/></CoordinateContact></elements>
    <simulation until="50" tolerance="1e-9"/>
    <orbit period="{6.283185307179586/0.7}" mirror="m.x"/></dynamy>)x",
      "f", {.from = 0.3, .to = 0.85, .at = 0.3, .points = 8});
  const BranchPoint* point = pointOf(b, "sliding");
  ASSERT_NE(point, nullptr);
  const double beta = 0.7, V = 1.0 / (1.0 - beta * beta);
  const double C = std::cos(3.141592653589793 / beta), S = std::sin(3.141592653589793 / beta);
  const double exact = 1.0 / std::hypot(1.0 / (V - 1.0), S / (V * beta * (1.0 + C)));
  // Sticking shorter than the scheme looks ahead, 1e-6 of the period, is one event with the turn.
  EXPECT_NEAR(point->p, exact, 2e-6);
  EXPECT_EQ(b.points.back().p, 0.85);
  EXPECT_TRUE(b.points.back().stable);
  EXPECT_NEAR(b.points.back().period, 6.283185307179586 / beta, 1e-12);
}

/// The branch of the woodpecker goes on through impacts that slip otherwise; at its lower end beak
/// and sleeve touch at one instant.
TEST(LongOrbitBranch, OfTheWoodpeckerHasItsEndsNamed) {
  const OrbitBranch b = Branches().ofModel("woodpecker", "mu=0.25:0.62:40");
  EXPECT_EQ(b.points.front().kind, "coincidence") << b.points.front().text;
  EXPECT_NEAR(b.points.front().p, 0.288577433, 1e-6);
  EXPECT_EQ(b.points.back().p, 0.62) << b.points.back().text;
  EXPECT_NEAR(b.points[b.start].period, 0.145976065144, 1e-10);
}

}  // namespace
}  // namespace dynamy
