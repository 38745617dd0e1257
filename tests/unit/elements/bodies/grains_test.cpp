// Populations of grains: like rigid bodies one by one, packed without overlap, reproducible.
#include <dynamy_elements/bodies/grains.hpp>

#include <algorithm>
#include <cmath>
#include <dynamy/schemes/stewart_trinkle.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <dynamy_elements/bodies/packing.hpp>
#include <dynamy_elements/forces/gravity.hpp>
#include <set>

#include "support/load_model.hpp"
#include "unit/elements/contacts/shape_models.hpp"

namespace dynamy {
namespace {

using namespace testing;

std::unique_ptr<Grains> grains(Given given, double radius = 0.05) {
  given.push_back({"within", {-0.5, -0.5, 0.0, 0.5, 0.5, 1.0}});
  return std::make_unique<Grains>(
      Parameters::of<Grains>("Grains", "sand", given)
          .with(std::make_unique<Sphere>(Parameters::of<Sphere>(
              "Sphere", "", {{"radius", radius}, {"density", 2500.0}, {"material", "sand"}}))));
}

struct Start {
  Eigen::VectorXd q, u;
  explicit Start(const Grains& g) : q(7 * g.frames()), u(6 * g.frames()) {
    g.initialState({q.data(), q.size()}, {u.data(), u.size()});
  }
};

/// Radii from the shapes that it places on its frames.
std::vector<double> radii(const Grains& g) {
  Description d;
  g.describe(d);
  std::vector<double> out;
  for (const PlacedShape& p : d.shapes) out.push_back(p.shape->geometry().size[0]);
  return out;
}

void expectNoOverlap(const Grains& g) {
  const Start start(g);
  const std::vector<double> R = radii(g);
  for (std::size_t i = 0; i < R.size(); ++i) {
    const Vec3 a = start.q.segment<3>(7 * static_cast<Eigen::Index>(i));
    EXPECT_GE((a.head<2>().cwiseAbs().array() + R[i]).maxCoeff(), 0.0);
    EXPECT_LE(a.head<2>().cwiseAbs().maxCoeff() + R[i], 0.5 + 1e-12);
    EXPECT_GE(a.z(), R[i] - 1e-12);
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 b = start.q.segment<3>(7 * static_cast<Eigen::Index>(j));
      EXPECT_GE((a - b).norm(), R[i] + R[j]) << i << ' ' << j;
    }
  }
}

TEST(Grains, ArePackedWithoutOverlap) {
  expectNoOverlap(*grains({{"count", 400.0}, {"jitter", 0.01}, {"sizes", {0.5, 1.0}}}));
  expectNoOverlap(
      *grains({{"count", 300.0}, {"packing", "random"}, {"sizes", {0.5, 1.2}}, {"seed", 5.0}}));
}

TEST(Grains, AreTheSameForASeed) {
  const auto state = [](double seed) {
    return Start(*grains({{"count", 50.0}, {"jitter", 0.01}, {"turned", "true"}, {"seed", seed}}))
        .q;
  };
  EXPECT_EQ(state(3.0), state(3.0));
  EXPECT_NE(state(3.0), state(4.0));
}

TEST(Grains, HaveTheSizesOfTheirDistribution) {
  // Mean of s: uniform 3/4·…: byNumber (a+b)/2; byVolume ∫s·s⁻³/∫s⁻³ = 2ab/(a+b); lognormal: median
  // √(ab). 10 000 numbers: the mean of numbers in [0.5, 1] is within 4 · 0.15/100 of it.
  const auto mean = [](const char* distribution) {
    const auto R = radii(
        *grains({{"count", 10000.0}, {"sizes", {0.5, 1.0}}, {"distribution", distribution}}, 1e-3));
    EXPECT_GE(*std::min_element(R.begin(), R.end()), 0.5e-3);
    EXPECT_LE(*std::max_element(R.begin(), R.end()), 1e-3);
    double sum = 0.0;
    for (const double r : R) sum += r;
    return 1e3 * sum / static_cast<double>(R.size());
  };
  EXPECT_NEAR(mean("byNumber"), 0.75, 6e-3);
  EXPECT_NEAR(mean("byVolume"), 2.0 * 0.5 / 1.5, 6e-3);
  // Mean of a lognormal e^(μ + σ²/2) with σ = ln 2/(2 √(2 ln 100)) = 0.1142; its cut tails are
  // symmetric in ln s and move it by less than 1e-3.
  EXPECT_NEAR(mean("lognormal"), std::sqrt(0.5) * std::exp(0.5 * 0.1142 * 0.1142), 6e-3);
}

TEST(Grains, SayWhenThereIsNoPlace) {
  EXPECT_THROW(grains({{"count", 2000.0}, {"packing", "random"}}), ModelError);
  EXPECT_THROW(grains({{"count", 10.0}, {"pitch", 0.09}}), ModelError);
  EXPECT_THROW(grains({{"count", 10.0}}, 0.6), ModelError);
}

/// Runs for 0.3 s with walls; the heights of all balls at the end.
Eigen::VectorXd settled(Model& m) {
  addBody<Ground, HalfSpace>(m, "floor", {}, "HalfSpace", {{"material", "wall"}});
  addRule(m, "sand wall");
  addRule(m, "sand sand");
  m.add(std::make_unique<Gravity>(Parameters::of<Gravity>("Gravity", "", {})));
  m.addCompletion(addShapeContacts);
  m.simulation.until = 0.3, m.simulation.step = 2e-3;
  m.build();
  Simulation simulation(m);
  simulation.run();
  const Eigen::VectorXd& q = simulation.state().q;
  Eigen::VectorXd z(q.size() / 7);
  for (Eigen::Index i = 0; i < z.size(); ++i) z[i] = q[7 * i + 2];
  return z;
}

TEST(Grains, MoveAsRigidBodiesOneByOneDo) {
  Model together, apart;
  together.add(grains({{"count", 40.0}, {"jitter", 0.01}, {"velocity", {0.5, 0.0, -1.0}}}));
  const Start start(*grains({{"count", 40.0}, {"jitter", 0.01}, {"velocity", {0.5, 0.0, -1.0}}}));
  for (Eigen::Index i = 0; i < 40; ++i)
    addBody<RigidBody, Sphere>(
        apart, "ball" + std::to_string(i),
        {{"position", Vec3(start.q.segment<3>(7 * i))}, {"velocity", {0.5, 0.0, -1.0}}}, "Sphere",
        {{"radius", 0.05}, {"density", 2500.0}, {"material", "sand"}});
  const Eigen::VectorXd a = settled(together), b = settled(apart);
  ASSERT_EQ(a.size(), b.size());
  // The same arithmetic in the same order.
  EXPECT_EQ((a - b).cwiseAbs().maxCoeff(), 0.0);
}

/// A block of three layers, 10 mm and more apart, that falls on a floor at 3 m/s.
struct FallingBlock {
  static constexpr double kStep = 5e-3;
  Model m;
  explicit FallingBlock(double floor) {
    m.add(grains({{"count", 243.0}, {"pitch", 0.11}, {"velocity", {0.0, 0.0, -3.0}}}));
    addBody<Ground, HalfSpace>(m, "floor", {}, "HalfSpace",
                               {{"material", "sand"}, {"position", {0.0, 0.0, floor}}});
    addRule(m, "sand sand");
    m.scheme(std::make_unique<StewartTrinkle>());
    m.solver(
        std::make_unique<BlockGaussSeidel>(ProxOptions{.tolerance = 1e-6, .maxIterations = 10000}));
    m.addCompletion(addShapeContacts);
    m.simulation.step = kStep;
    m.build();
  }
  int contacts(const State& x) {
    MechanicalSystem s = m.mechanicalSystem();
    return s.evaluate(x, {.ahead = kStep}).contacts.size();
  }
};

TEST(Grains, ThatFallSideBySideDoNotMeet) {
  FallingBlock block(-1.0);
  State x = block.m.initialState();
  EXPECT_EQ(block.contacts(x), 0);
  // One of the middle layer stops: six may meet it, and be turned towards those next to them. Of
  // 594 pairs of neighbours most are too far from it.
  x.u.segment<3>(6 * (81 + 40)).setZero();
  const int near = block.contacts(x);
  EXPECT_GE(near, 6);
  EXPECT_LT(near, 594 / 2);
}

TEST(Grains, ThatPassSideBySideDoNotMeet) {
  FallingBlock block(-1.0);
  State x = block.m.initialState();
  // The middle layer goes aside at 3 m/s: 30 mm in twice the step, with 10 mm to the layers next to
  // it. Distances do not close, or by 21 mm of 55 mm.
  for (Eigen::Index i = 81; i < 162; ++i) x.u[6 * i] = 3.0;
  EXPECT_EQ(block.contacts(x), 0);
}

/// Bodies that touch within the step, by the blocks of the contacts; −1: the ground.
std::set<std::pair<int, int>> seen(Model& m, const State& x, double dt) {
  MechanicalSystem s = m.mechanicalSystem();
  const ContactSet& c = s.evaluate(x, {.ahead = dt}).contacts;
  std::set<std::pair<int, int>> out;
  for (int i = 0; i < c.size(); ++i) {
    const auto first = static_cast<std::size_t>(c.segment0[static_cast<std::size_t>(i)]);
    const bool two = c.segment0[static_cast<std::size_t>(i) + 1] - static_cast<int>(first) == 2;
    const int a = c.segment[first].block, b = two ? c.segment[first + 1].block : -1;
    out.emplace(std::min(a, b), std::max(a, b));
  }
  return out;
}

TEST(Grains, ThatMeetWithinAStepAreSeen) {
  // 100 balls with velocities at random above a box: all that go straight into each other or into
  // the box, by the least distance on their ways.
  constexpr double kStep = 5e-3, kRadius = 0.05;
  Model m;
  m.add(grains({{"count", 100.0}, {"pitch", 0.105}}));
  const Vec3 half(0.2, 0.15, 0.1), middle(-0.3, -0.3, -0.12);
  addBody<Ground, Box>(m, "block", {}, "Box",
                       {{"size", Vec3(2.0 * half)}, {"material", "sand"}, {"position", middle}});
  addRule(m, "sand sand");
  m.addCompletion(addShapeContacts);
  m.build();
  SeededNumbers numbers(7);
  int expected = 0, onBox = 0;
  for (int trial = 0; trial < 60; ++trial) {
    State x = m.initialState();
    for (Eigen::Index i = 0; i < x.u.size(); ++i)
      x.u[i] = i % 6 < 3 ? numbers.uniform(-5.0, 5.0) : numbers.uniform(-50.0, 50.0);
    const auto found = seen(m, x, kStep);
    const auto r = [&](Eigen::Index i, double t) {
      return Vec3(x.q.segment<3>(7 * i) + t * x.u.segment<3>(6 * i));
    };
    for (int i = 0; i < 100; ++i) {
      double least = 1.0;
      for (int k = 0; k <= 50; ++k) {
        const Vec3 c = r(i, 0.02 * k * kStep) - middle;
        least = std::min(least, (c - c.cwiseMax(-half).cwiseMin(half)).norm() - kRadius);
      }
      if (least < 0.0) {
        EXPECT_TRUE(found.contains({-1, i})) << trial << ' ' << i;
        ++onBox;
      }
      for (int j = 0; j < i; ++j) {
        const Vec3 d = r(i, 0.0) - r(j, 0.0), v = x.u.segment<3>(6 * i) - x.u.segment<3>(6 * j);
        const double t = std::clamp(-d.dot(v) / v.squaredNorm(), 0.0, kStep);
        if ((d + t * v).norm() >= 2.0 * kRadius) continue;
        EXPECT_TRUE(found.contains({j, i})) << trial << ' ' << j << ' ' << i;
        ++expected;
      }
    }
  }
  EXPECT_GT(expected, 500);
  EXPECT_GT(onBox, 20);
}

TEST(Grains, ThatAreStoppedStopThoseBehindThem) {
  FallingBlock block(0.0);
  HandStepper stepper(block.m);
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(stepper.step(FallingBlock::kStep).solved.ok());
  double deepest = 0.0;
  for (Eigen::Index i = 0; i < 243; ++i) {
    const Vec3 a = stepper.x.q.segment<3>(7 * i);
    deepest = std::max(deepest, 0.05 - a.z());
    for (Eigen::Index j = 0; j < i; ++j)
      deepest = std::max(deepest, 0.1 - (a - stepper.x.q.segment<3>(7 * j)).norm());
  }
  // All velocities are vertical and so are the normals that close: gaps at the end of a step are
  // forecast exactly, and what is left is the tolerance of 3 m/s. Unseen, a pair overlaps by 5 mm.
  EXPECT_LE(deepest, 1e-6 * 3.0 * FallingBlock::kStep * 20);
}

}  // namespace
}  // namespace dynamy
