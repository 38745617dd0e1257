/// AllocationCounter: counts how often memory is allocated in a scope.
///
///   AllocationCounter counter;
///   simulate(1000);
///   EXPECT_EQ(counter.count(), 0);
///
/// Counting needs `<dynamy/testing/counting_allocation.hpp>` in exactly one source file of the test
/// program; without it active() is false. Rejected: counting inside of the library, which would
/// slow and surprise every program that links it.
#pragma once
#include <atomic>

namespace dynamy {

namespace detail {
inline std::atomic<long> allocations{0};
inline std::atomic<bool> allocationsAreCounted{false};
}  // namespace detail

class AllocationCounter {
 public:
  AllocationCounter() : before_(detail::allocations.load()) {}
  /// Allocations since construction, of all threads.
  long count() const { return detail::allocations.load() - before_; }
  /// False: nothing is counted in this program.
  static bool active() { return detail::allocationsAreCounted.load(); }

 private:
  long before_;
};

}  // namespace dynamy
