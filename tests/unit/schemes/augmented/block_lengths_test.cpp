// Lengths of blocks of augmented time-stepping, against what they should be by hand.
#include <gtest/gtest.h>

#include <dynamy/schemes/augmented/block_lengths.hpp>

namespace dynamy {
namespace {

constexpr double kDt = 0.5, kShortest = 1.0 / 64.0;  // powers of two: all results are exact

BlockLengths begun(double t = 0.0) {
  BlockLengths lengths(4, kShortest);
  lengths.begin(t, kDt);
  return lengths;
}

TEST(BlockLengths, BeginWithTheLargestStep) {
  const BlockLengths lengths = begun();
  EXPECT_EQ(lengths.next(), kDt);
  EXPECT_EQ(lengths.shortest(), kShortest);
  EXPECT_FALSE(lengths.plain());
}

TEST(BlockLengths, TakeAQuarterOfTheStepsPowerIfNoShortestIsGiven) {
  BlockLengths lengths(4, 0.0);
  lengths.begin(0.0, kDt);
  EXPECT_EQ(lengths.shortest(), 1.0 / 64.0);  // (1/2)^4/4
}

TEST(BlockLengths, HalveWhereABlockFailsDownToTheShortest) {
  BlockLengths lengths = begun();
  for (double H = kDt; H > kShortest; H /= 2) {
    lengths.failed(H);
    EXPECT_EQ(lengths.next(), H / 2);
  }
  lengths.failed(kShortest);
  EXPECT_EQ(lengths.next(), kShortest);
}

TEST(BlockLengths, BisectUpToTheEndOfTheBlockThatFailed) {
  BlockLengths lengths = begun();
  lengths.failed(kDt);
  lengths.accepted(kDt / 2, kDt / 2);  // the switch lies in the second half
  EXPECT_EQ(lengths.next(), kDt / 4);
  lengths.begin(kDt / 2, kDt);
  lengths.accepted(kDt, kDt / 2);  // the end is reached without a switch
  EXPECT_EQ(lengths.next(), kDt);
}

TEST(BlockLengths, DoubleAfterASwitch) {
  BlockLengths lengths = begun();
  lengths.stepped(kShortest);
  EXPECT_EQ(lengths.next(), 2 * kShortest);
}

TEST(BlockLengths, TakePlainStepsAfterTooManySwitches) {
  BlockLengths lengths = begun();
  for (int i = 0; i < 32; ++i) EXPECT_FALSE(lengths.countSwitch());
  EXPECT_EQ(lengths.countSwitch(), kDt);
  EXPECT_EQ(lengths.plain(), kDt / 32);
  lengths.begin(kDt, kDt);  // that time is over
  EXPECT_FALSE(lengths.plain());
}

TEST(BlockLengths, AreTheSameAfterStoringAndRestoring) {
  BlockLengths lengths = begun();
  lengths.failed(kDt);
  Eigen::VectorXd data = Eigen::VectorXd::Zero(BlockLengths::kSize + 2);
  lengths.store(data);
  BlockLengths same(4, kShortest);
  ASSERT_TRUE(same.restore(data));
  same.begin(0.0, kDt);
  EXPECT_EQ(same.next(), kDt / 2);
  data[5] = 1e9;  // more switches than are ever counted
  EXPECT_FALSE(same.restore(data));
}

}  // namespace
}  // namespace dynamy
