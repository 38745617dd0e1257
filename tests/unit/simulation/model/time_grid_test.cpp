#include <gtest/gtest.h>
#include <dynamy/simulation/model/time_grid.hpp>

namespace dynamy {
namespace {

TEST(TimeGrid, DecimalStepsGiveDecimalInstants) {
  const TimeGrid grid(1e-3);
  EXPECT_EQ(grid.at(300), 0.3);
  EXPECT_EQ(grid.at(1001), 1.001);
}

TEST(TimeGrid, OtherStepsAreMultiplied) {
  const TimeGrid grid(0.03);
  EXPECT_EQ(grid.at(7), 7 * 0.03);
  EXPECT_EQ(TimeGrid(2.5).at(3), 7.5);
}

}  // namespace
}  // namespace dynamy
