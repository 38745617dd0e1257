// Every part of a task is done once, whatever the number of threads.
#include <dynamy/core/workers.hpp>

#include <gtest/gtest.h>

namespace dynamy {
namespace {

TEST(Workers, DoEveryPartOnceBeforeTheyReturn) {
  for (const int threads : {1, 2, 5}) {
    Workers workers(threads);
    EXPECT_EQ(workers.threads(), threads);
    for (int task = 0; task < 2000; ++task) {
      std::vector<int> done(static_cast<std::size_t>(task % 9), 0);
      workers.run(task % 9, [&](int part) { ++done[static_cast<std::size_t>(part)]; });
      for (const int times : done) ASSERT_EQ(times, 1) << threads << ' ' << task;
    }
  }
}

TEST(Workers, MayRestBetweenTasks) {
  Workers workers(2);
  std::vector<double> sum(4, 0.0);
  for (int task = 0; task < 3; ++task) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // longer than they look
    workers.run(4, [&](int part) { sum[static_cast<std::size_t>(part)] += part; });
  }
  EXPECT_EQ(sum, (std::vector<double>{0.0, 3.0, 6.0, 9.0}));
}

}  // namespace
}  // namespace dynamy
