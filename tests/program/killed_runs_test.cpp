/// Runs killed at random instants: a part of bench/trust/killed_runs.py.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cstdlib>
#include <string>

namespace dynamy {
namespace {

#ifdef DYNAMY_PYTHON
TEST(LongKilledRuns, CanBeReadAndGoOnBitForBit) {
  const std::string command = std::string("'") + DYNAMY_PYTHON + "' '" + DYNAMY_SOURCE_DIR +
                              "/bench/trust/killed_runs.py' --count 100 --program '" +
                              DYNAMY_BINARY_DIR + "/bin/dynamy'";
  EXPECT_EQ(std::system(command.c_str()), 0);
}
#endif

}  // namespace
}  // namespace dynamy
