// An arch of stones that neither pull nor slide, against its limit thickness.
#include <gtest/gtest.h>

#include <dynamy/core/declared/attributes.hpp>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

TEST(Arch, AboveItsLimitThicknessStandsAtAMillisecond) {
  // Eleven stones stand from t/R = 0.10491034304 on, by linear programming of their equilibrium
  // (theory 57.3).
  for (const double more : {1.001, 1.01}) {
    BoundedRun arch("models/masonry_arch.xml", {.set = {{"t", numberText(more * 0.10491034304)}}});
    arch.run();
    for (const CheckResult& r : arch.simulation().checks())
      EXPECT_TRUE(r.pass) << more << " of the limit: " << r.measure << " of " << r.signal << " is "
                          << r.got << ", expected " << r.expected;
  }
}

}  // namespace
}  // namespace dynamy
