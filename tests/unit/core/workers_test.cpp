// Every part of a task is done once, whatever the number of threads.
#include <dynamy/core/workers.hpp>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <new>

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

TEST(Workers, HandTheFirstExceptionOfAPartToTheCaller) {
  for (const int threads : {1, 4}) {
    Workers workers(threads);
    EXPECT_THROW(workers.run(50,
                             [](int part) {
                               if (part == 7) throw std::bad_alloc();
                             }),
                 std::bad_alloc);
    int sum = 0;
    workers.run(1, [&](int) { ++sum; });  // and go on
    EXPECT_EQ(sum, 1);
  }
}

#ifndef DYNAMY_SANITIZED  // sanitizers need more addresses than any limit leaves
TEST(Workers, AreFewerWhereTheSystemGivesNoMore) {
  const pid_t child = ::fork();
  if (child == 0) {
    // Room for the stacks of a few threads, 8 MB each as a rule, not for those of 64.
    struct rlimit stack {};
    ::getrlimit(RLIMIT_STACK, &stack);
    std::ifstream statm("/proc/self/statm");
    rlim_t pages = 0;
    statm >> pages;
    const rlim_t each = std::min<rlim_t>(stack.rlim_cur, rlim_t{8} << 20);
    const rlim_t most = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + 6 * each;
    const struct rlimit limit { most, most };
    ::setrlimit(RLIMIT_AS, &limit);
    Workers workers(64);
    std::atomic<int> sum{0};
    workers.run(100, [&](int part) { sum += part; });
    ::_exit(sum == 4950 && workers.threads() < 64 ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));  // was: terminate called
  EXPECT_EQ(WEXITSTATUS(status), 0);
}
#endif

}  // namespace
}  // namespace dynamy
