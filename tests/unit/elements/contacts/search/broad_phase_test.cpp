// Pairs of balls that are near each other, against comparing all.
#include <dynamy_elements/contacts/search/broad_phase.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace dynamy {
namespace {

using Ball = BroadPhase::Ball;

std::vector<BroadPhase::Pair> compared(const std::vector<Ball>& balls) {
  std::vector<BroadPhase::Pair> out;
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      const double R = balls[i].radius + balls[j].radius;
      if (balls[i].radius < 0.0 || balls[j].radius < 0.0) continue;
      if ((balls[i].c - balls[j].c).squaredNorm() <= R * R)
        out.emplace_back(static_cast<int>(i), static_cast<int>(j));
    }
  return out;
}

/// `size(random)`: radius of a ball in a cube of edge 2.
template <class Size>
std::vector<Ball> scattered(int n, unsigned seed, Size&& size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  std::vector<Ball> out;
  for (int i = 0; i < n; ++i)
    out.push_back({Vec3(at(random), at(random), at(random)), size(random)});
  return out;
}

TEST(BroadPhase, FindsThePairsThatComparingAllFinds) {
  BroadPhase broad;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const auto equal = scattered(600, seed, [](auto&) { return 0.08; });
    EXPECT_EQ(broad.near(equal), compared(equal));
    EXPECT_GT(compared(equal).size(), 100u);
    // Sizes over four decades: many levels, up to 190 cells for each, more than 8 · 190 balls.
    const auto mixed =
        scattered(2000, seed, [&](auto& r) { return 0.5 * std::pow(1e-4, uniform(r)); });
    EXPECT_EQ(broad.near(mixed), compared(mixed));
    // Few, and with some that take no part.
    const auto few = scattered(10, seed, [&](auto& r) { return uniform(r) - 0.2; });
    EXPECT_EQ(broad.near(few), compared(few));
    const auto parts = scattered(1000, seed, [&](auto& r) { return 0.2 * uniform(r) - 0.05; });
    EXPECT_EQ(broad.near(parts), compared(parts));
  }
}

TEST(BroadPhase, FindsThePairsOfBoxesThatComparingAllFinds) {
  using Box = BroadPhase::Box;
  BroadPhase broad;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(-1.0, 1.0), size(0.0, 0.3);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Box> boxes;
    for (int i = 0; i < 300; ++i) {
      const Vec3 low(at(random), 3.0 * at(random), at(random));
      boxes.emplace_back(low, low + Vec3(size(random), size(random), size(random)));
    }
    const double infinity = std::numeric_limits<double>::infinity();
    boxes[7] = Box(), boxes[100] = Box();                                  // take no part
    boxes[20] = Box(Vec3::Constant(-infinity), Vec3::Constant(infinity));  // is everywhere
    std::vector<BroadPhase::Pair> pairs;
    for (int i = 0; i < 300; ++i)
      for (int j = i + 1; j < 300; ++j) {
        const Box &a = boxes[static_cast<std::size_t>(i)], &b = boxes[static_cast<std::size_t>(j)];
        if (!a.isEmpty() && !b.isEmpty() && (a.min().array() <= b.max().array()).all() &&
            (b.min().array() <= a.max().array()).all())
          pairs.emplace_back(i, j);
      }
    EXPECT_EQ(broad.near(boxes), pairs);
    EXPECT_GT(pairs.size(), 300u);
  }
  EXPECT_TRUE(broad.near(std::vector<Box>(50)).empty());
  EXPECT_EQ(broad.near(std::vector<Box>(50, Box(Vec3::Zero(), Vec3::Zero()))).size(), 25u * 49);
}

TEST(BroadPhase, LeavesOutMillionsThatTakeNoPart) {
  // Grains that wait to be fed: comparing all of them takes an hour.
  BroadPhase broad;
  EXPECT_TRUE(broad.near(std::vector<Ball>(2000000, {Vec3::Zero(), -1.0})).empty());
}

TEST(BroadPhase, EndsWhereEachIsNearThousands) {
  // A hundred thousand bodies in one place: 5e9 pairs, which would take all memory.
  BroadPhase broad;
  const std::vector<Ball> all(100000, {Vec3::Zero(), 1.0});
  EXPECT_LT(broad.near(all, BroadPhase::kNeighbours).size(), 200u * all.size());
  EXPECT_TRUE(broad.overfull());
  // Balls widened by the way of a fast step are near many: 300 each are an answer.
  const std::vector<Ball> crowd(10000, {Vec3::Zero(), 1.0});  // 5e7 pairs, 5000 each
  broad.near(crowd);
  EXPECT_TRUE(broad.overfull());
  std::vector<Ball> groups;
  for (int i = 0; i < 12000; ++i) groups.push_back({Vec3(10.0 * (i / 600), 0.0, 0.0), 1.0});
  EXPECT_EQ(broad.near(groups).size(), 20u * 300 * 599);
  EXPECT_FALSE(broad.overfull());
  // Two thousand in one place are a scene: n (n − 1)/2.
  const std::vector<Ball> some(2000, {Vec3::Zero(), 1.0});
  EXPECT_EQ(broad.near(some).size(), 1000u * 1999);
  EXPECT_FALSE(broad.overfull());
}

TEST(BroadPhase, StandsWhatLiesOnItsCells) {
  // A lattice of balls that touch: all middles lie on edges of cells, all distances are equal.
  std::vector<Ball> lattice;
  for (int i = 0; i < 1000; ++i) lattice.push_back({Vec3(i % 10, i / 10 % 10, i / 100), 0.5});
  BroadPhase broad;
  EXPECT_EQ(broad.near(lattice).size(), 3u * 10 * 10 * 9);
}

TEST(BroadPhase, StandsBodiesThatFlyAwayAndPointsWithoutSize) {
  BroadPhase broad;
  std::vector<Ball> balls = scattered(300, 3, [](auto&) { return 0.2; });
  balls[7].c.x() = 1e300, balls[8].c.y() = -std::numeric_limits<double>::infinity();
  balls[9].c.z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(broad.near(balls), compared(balls));
  for (Ball& b : balls) b.radius = 0.0;
  EXPECT_TRUE(broad.near(balls).empty());
  EXPECT_TRUE(broad.near(std::vector<Ball>{}).empty());
  balls.assign(50, {Vec3::Zero(), std::numeric_limits<double>::infinity()});
  EXPECT_EQ(broad.near(balls).size(), 50u * 49 / 2);
}

}  // namespace
}  // namespace dynamy
