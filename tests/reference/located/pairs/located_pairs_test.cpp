// Pairs of boxes and of polygons to a tolerance: instants in closed form, energy of transitions
// that are no impacts, and random flights of two cubes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <random>
#include <reference/located/located_run.hpp>
#include <support/gravity.hpp>
#include <tuple>

namespace dynamy::reference {
namespace {

std::string pairScene(const std::string& systems, const std::string& law,
                      const std::string& forces = "<forces><Gravity/></forces>") {
  return R"xml(<dynamy version="1">
    <parameter name="a" value="0"/><parameter name="b" value="0"/><parameter name="c" value="0"/>
    <parameter name="e" value="0"/><parameter name="mu" value="0"/>
    <systems>)xml" +
         systems + "</systems>" + forces + R"xml(<elements><Contact between="stone stone">)xml" +
         law + R"xml(</Contact></elements><simulation until="1" step="1"/></dynamy>)xml";
}

const std::string kCoulomb = R"xml(<UnilateralCoulomb mu="{mu}" epsilonN="{e}"/>)xml";

std::vector<double> allImpacts(const LocatedRun& run) {
  std::vector<double> out;
  for (const ContactEvent& e : run.events)
    if (e.impact) out.push_back(e.t);
  return out;
}

// ---- closed forms -----------------------------------------------------------------------------

TEST(LocatedPairs, CornerHitsAFaceWhenItHasFallenThere) {
  // The lowest corner of a cube turned by any angles is |A₃·|(h, h, h) below its middle.
  const std::string model = pairScene(R"xml(
    <RigidBody name="die" position="0.1 0.05 1" euler="{a} {b} {c}">
      <Box size="0.2 0.2 0.2" mass="1" material="stone"/></RigidBody>
    <Ground name="world"><Box size="2 2 0.1" position="0 0 -0.05" material="stone"/></Ground>)xml",
                                      kCoulomb);
  for (const auto& [a, b, c] : {std::array{0.3, 0.7, 0.2}, std::array{1.0, -0.9, 2.0}}) {
    LocatedRun run(model, 1e-9, 0.5,
                   {{"a", std::to_string(a)},
                    {"b", std::to_string(b)},
                    {"c", std::to_string(c)},
                    {"e", "0.5"}});
    const Eigen::VectorXd q = run.model().initialState().q;
    const Mat3 A = rotationMatrix(q.data() + 3);
    const double low = 1.0 - 0.1 * A.row(2).cwiseAbs().sum();
    run.run();
    ASSERT_EQ(run.report().ended, RunReport::Ended::finished) << run.report().reason;
    const std::vector<double> hits = allImpacts(run);
    ASSERT_FALSE(hits.empty());
    // A parabola: located to rounding of g over the speed there.
    EXPECT_NEAR(hits[0], std::sqrt(2.0 * low / kG), 1e-13);
  }
}

TEST(LocatedPairs, EdgeHitsAnEdgeWhenItHasFallenThere) {
  // Two bars turned by 45° about their long axes, which cross: edges upon edges.
  LocatedRun run(pairScene(R"xml(
    <RigidBody name="bar" position="0.03 0.01 1" euler="{pi/4} 0 0">
      <Box size="2 0.2 0.2" mass="1" material="stone"/></RigidBody>
    <Ground name="world"><Box size="0.2 2 0.2" euler="0 {pi/4} 0"
      material="stone"/></Ground>)xml",
                           kCoulomb),
                 1e-9, 0.46, {{"e", "0.5"}});
  run.run();
  ASSERT_EQ(run.report().ended, RunReport::Ended::finished) << run.report().reason;
  const std::vector<double> hits = allImpacts(run);
  ASSERT_FALSE(hits.empty());
  EXPECT_NEAR(hits[0], std::sqrt(2.0 * (1.0 - 0.2 * std::sqrt(2.0)) / kG), 1e-13);
}

TEST(LocatedPairs, BlockThatSlidesOffTipsOverTheRim) {
  // Without friction: 1 m/s, its front corners leave over the rim x = 0.5 after 0.1 s, and it tips
  // when its middle is there, after 0.3 s. Nothing hits anything and nothing rubs.
  const std::string model = pairScene(R"xml(
    <RigidBody name="block" position="0.2 0 0.1" velocity="1 0 0">
      <Box size="0.4 0.2 0.2" mass="2" material="stone"/></RigidBody>
    <Ground name="world"><Box size="1 1 0.1" position="0 0 -0.05" material="stone"/></Ground>)xml",
                                      "<Unilateral/>");
  LocatedRun run(model, 1e-9, 0.3), on(model, 1e-9, 0.6);
  run.run();
  ASSERT_EQ(run.report().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_EQ(run.report().stepping.periods, 0);
  EXPECT_LT(run.state().u.tail<3>().norm(), 1e-9);
  EXPECT_NEAR(run.state().q[2], 0.1, 1e-12);
  on.run();
  ASSERT_EQ(on.report().ended, RunReport::Ended::finished) << on.report().reason;
  EXPECT_TRUE(allImpacts(on).empty());
  EXPECT_GT(on.state().u.tail<3>().norm(), 1.0);
  const State& x = on.state();
  const double J[3] = {2.0 / 12.0 * (0.04 + 0.04), 2.0 / 12.0 * (0.16 + 0.04),
                       2.0 / 12.0 * (0.16 + 0.04)};
  double T = x.u.head<3>().squaredNorm();
  for (int k = 0; k < 3; ++k) T += 0.5 * J[k] * x.u[3 + k] * x.u[3 + k];
  // Energy, to ten times the tolerance: 2·9.81·L of it is carried by every part of z.
  EXPECT_NEAR(T + 2.0 * kG * (x.q[2] - 0.1), 1.0, 1e-7);
}

TEST(LocatedPairs, TowerOfCubesStandsStill) {
  LocatedRun run("tower", 1e-5, 10.0);
  run.run();
  ASSERT_EQ(run.report().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_EQ(run.report().stepping.periods, 0);
  // What the solver of the decision leaves, 1e-10 of what gravity gives in its step of 1e-5 T, over
  // ten cubes; the same as before pairs of features were followed.
  EXPECT_LT(run.state().u.lpNorm<Eigen::Infinity>(), 1e-9);
  EXPECT_LT(run.report().steps, 200);
}

// ---- a second formulation ---------------------------------------------------------------------

TEST(LocatedPairs, BoxThrownOnABoxMovesAsOnAHalfSpace) {
  const auto thrown = [](const std::string& ground) {
    return R"xml(<dynamy version="1">
      <parameter name="z" value="1"/><parameter name="a" value="0"/><parameter name="b" value="0"/>
      <parameter name="v" value="0"/><parameter name="w" value="0"/>
      <parameter name="mu" value="0"/><parameter name="e" value="0"/>
      <systems><RigidBody name="box" position="0 0 {z}" euler="{a} {b} 0.3" velocity="{v} 0.3 0"
        angularVelocity="{w} 1 0.5"><Box size="0.4 0.3 0.15" mass="2" material="stone"/>
      </RigidBody><Ground name="world">)xml" +
           ground + R"xml(</Ground></systems><forces><Gravity/></forces><elements>
      <Contact between="stone floor"><UnilateralCoulomb mu="{mu}" epsilonN="{e}"/></Contact>
      </elements><simulation until="1" step="1"/></dynamy>)xml";
  };
  const std::string flat = thrown(R"xml(<HalfSpace material="floor"/>)xml"),
                    box = thrown(
                        R"xml(<Box size="20 20 1" position="0 0 -0.5" material="floor"/>)xml");
  constexpr unsigned kSeed = 41;
  std::mt19937 random(kSeed);
  const auto between = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
  };
  constexpr int kRuns = 30;
  constexpr double kTolerance = 1e-7, kUntil = 4.0;
  int alike = 0, told = 0;
  for (int i = 0; i < kRuns; ++i) {
    Overrides set;
    for (const auto& [name, low, high] :
         {std::tuple{"z", 0.3, 0.8}, std::tuple{"a", -1.5, 1.5}, std::tuple{"b", -1.5, 1.5},
          std::tuple{"v", -1.0, 1.0}, std::tuple{"w", -4.0, 4.0}, std::tuple{"mu", 0.05, 1.0},
          std::tuple{"e", 0.0, 0.5}})
      set.emplace_back(name, std::to_string(between(low, high)));
    LocatedRun onBox(box, kTolerance, kUntil, set), onFlat(flat, kTolerance, kUntil, set);
    const RunReport& r = onBox.run();
    onFlat.run();
    ASSERT_EQ(r.ended, RunReport::Ended::finished)
        << "seed " << kSeed << ", run " << i << ": " << r.reason;
    EXPECT_EQ(r.located.undecided, 0) << "seed " << kSeed << ", run " << i;
    told += r.stepping.periods > 0;
    // It has come to rest on one of its faces: half of an edge above the floor.
    const double z = onBox.state().q[2];
    EXPECT_LT(std::min({std::abs(z - 0.2), std::abs(z - 0.15), std::abs(z - 0.075)}), 1e-4)
        << "seed " << kSeed << ", run " << i;
    alike += (onBox.state().q - onFlat.state().q).head<3>().lpNorm<Eigen::Infinity>() < 1e-4;
  }
  // Each impact amplifies errors of 1e-7; percussions of two corners at once need not be unique.
  EXPECT_GE(alike, kRuns - 1) << "seed " << kSeed;
  EXPECT_LE(told, 1) << "seed " << kSeed;
}

// ---- random flights ---------------------------------------------------------------------------

/// Largest separation of two cubes along the 15 axes, written anew.
double apart(const Vec3& cA, const Mat3& RA, const Vec3& cB, const Mat3& RB, double half) {
  double most = -1e300;
  const auto along = [&](const Vec3& axis) {
    if (axis.norm() < 1e-6) return;
    const Vec3 n = axis.normalized();
    most =
        std::max(most, std::abs(n.dot(cB - cA)) - half * ((RA.transpose() * n).cwiseAbs().sum() +
                                                          (RB.transpose() * n).cwiseAbs().sum()));
  };
  for (int i = 0; i < 3; ++i) {
    along(RA.col(i)), along(RB.col(i));
    for (int j = 0; j < 3; ++j) along(RA.col(i).cross(RB.col(j)));
  }
  return most;
}

/// The deepest overlap of two cubes at the ends of steps.
class Overlap final : public Observer {
 public:
  explicit Overlap(double half) : Observer(Parameters()), half_(half) {}
  void step(const StepView& view) override {
    const State& x = view.after;
    deepest_ =
        std::max(deepest_, -apart(x.q.head<3>(), rotationMatrix(x.q.data() + 3), x.q.segment<3>(7),
                                  rotationMatrix(x.q.data() + 10), half_));
  }
  double deepest() const { return deepest_; }

 private:
  double half_, deepest_ = 0.0;
};

const std::string kFlight = R"xml(<dynamy version="1">
  <parameter name="a" value="0"/><parameter name="b" value="0"/><parameter name="c" value="0"/>
  <parameter name="x" value="0"/><parameter name="y" value="0"/>
  <parameter name="p" value="0"/><parameter name="r" value="0"/><parameter name="s" value="0"/>
  <parameter name="e" value="0"/><parameter name="mu" value="0"/>
  <systems>
    <RigidBody name="A" position="0 0 0" euler="{a} {b} {c}" angularVelocity="{p} {r} {s}">
      <Box size="1 1 1" mass="1" material="stone"/></RigidBody>
    <RigidBody name="B" position="{x} {y} 2.5" euler="{c} {a} {b}" velocity="0 0 -2"
      angularVelocity="{s} {p} {r}"><Box size="1 1 1" mass="1" material="stone"/></RigidBody>
  </systems>
  <elements><Contact between="stone stone"><UnilateralCoulomb mu="{mu}" epsilonN="{e}"/></Contact>
  </elements><simulation until="1" step="1"/></dynamy>)xml";

struct Flights {
  int runs = 0, failed = 0, told = 0, deep = 0, wrong = 0, hit = 0;
  double deepest = 0.0, worst = 0.0;
};

/// Of a run with impacts: errors grow by an impact at most this much, measured over the seeds here;
/// beyond, it is said to be wrong unless it tells that it was stepped in time.
constexpr double kAmplified = 1e4;
/// Overlaps that are left as they are, over tol L, those held before and those of the step;
/// rounding.
constexpr double kLeftOverlap = 2e-3, kOverlapRounding = 1e-12;

Flights flights(unsigned seed, int first, int last, bool rebounds) {
  std::mt19937 random(seed);
  const auto between = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
  };
  Flights n;
  for (int i = 0; i < last; ++i) {
    Overrides set;
    std::string text;
    const auto draw = [&](const char* name, double low, double high) {
      set.emplace_back(name, std::to_string(between(low, high)));
      text += " --set " + set.back().first + "=" + set.back().second;
    };
    for (const char* angle : {"a", "b", "c"}) draw(angle, -3.0, 3.0);
    for (const char* place : {"x", "y"}) draw(place, -1.0, 1.0);
    for (const char* turn : {"p", "r", "s"}) draw(turn, -4.0, 4.0);
    draw("mu", 0.0, 0.8);
    draw("e", rebounds ? 0.1 : 0.0, rebounds ? 1.0 : 0.0);
    if (i < first) continue;
    constexpr double kTolerance = 1e-6, kUntil = 1.5;
    LocatedRun run(kFlight, kTolerance, kUntil, set),
        finer(kFlight, 1e-2 * kTolerance, kUntil, set);
    Overlap overlap(0.5);
    run.simulation().observe(overlap);
    const RunReport& r = run.run();
    finer.run();
    ++n.runs;
    const bool failed = r.ended != RunReport::Ended::finished,
               told = r.stepping.periods > 0 || finer.report().stepping.periods > 0;
    const double L = run.model().length();
    const double deep = std::max(0.0, overlap.deepest() - kOverlapRounding) / (kTolerance * L);
    const bool sinks = !told && deep > kLeftOverlap;
    const double off = failed ? 0.0 : (run.state().q - finer.state().q).lpNorm<Eigen::Infinity>();
    const bool wrong = !told && off > kAmplified * kTolerance * L;
    n.failed += failed, n.told += told, n.hit += !allImpacts(run).empty();
    n.deep += sinks, n.wrong += wrong;
    if (!told) n.deepest = std::max(n.deepest, deep), n.worst = std::max(n.worst, off);
    if (failed || wrong || sinks)
      std::printf("seed %u, run %d, tolerance 1e-6%s: %s off by %.2g, overlap %.2g tol L\n", seed,
                  i, text.c_str(), r.reason.c_str(), off, deep);
  }
  std::printf(
      "seed %u: %d flights, %d hit, %d failed, %d stepped in time, deepest %.2g tol L, "
      "worst difference %.2g m\n",
      seed, n.runs, n.hit, n.failed, n.told, n.deepest, n.worst);
  return n;
}

void expectSoundFlights(unsigned seed, int last, bool rebounds) {
  const Flights n = flights(seed, 0, last, rebounds);
  EXPECT_EQ(n.failed, 0) << "seed " << seed;
  EXPECT_EQ(n.deep, 0) << "seed " << seed;
  EXPECT_EQ(n.wrong, 0) << "seed " << seed;
  EXPECT_LE(n.told, last / 25 + 1) << "seed " << seed;
}

TEST(LocatedPairs, TumblingCubesHitWithoutOverlap) {
  expectSoundFlights(31, 25, false);
  expectSoundFlights(32, 25, true);
}

TEST(LongLocatedPairs, ThousandsOfTumblingCubesHitWithoutOverlap) {
  for (const unsigned seed : {33u, 34u, 35u, 36u}) {
    expectSoundFlights(seed, 1000, false);
    expectSoundFlights(seed, 1000, true);
  }
}

}  // namespace
}  // namespace dynamy::reference
