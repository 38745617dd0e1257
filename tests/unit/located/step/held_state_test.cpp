#include <gtest/gtest.h>

#include <dynamy/located/step/held_state.hpp>

#include "support/archived_numbers.hpp"
#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

HeldState someState() {
  HeldState out;
  out.pace = {0.125, 1e-4, 0.75, 3};
  out.held.resize(2);
  out.held[0].key = contactKey(0, 7), out.held[0].slips = true, out.held[0].sign = -1.0;
  out.held[1].key = contactKey(0, 9), out.held[1].rows = 2, out.held[1].lambda[1] = 4.5;
  out.missing = {0};
  out.implicit = true, out.counted = {1, 2, 3, 4, 5, 0, 0.01};
  out.jacobian = Eigen::VectorXd::LinSpaced(9, 0.0, 1.0);  // 1 + 2 (nq + nu) numbers
  return out;
}

TEST(HeldState, IsReadAsItWasWritten) {
  const HeldState written = someState();
  const Eigen::VectorXd numbers = numbersOf(written);
  HeldState read;
  NumberArchive a(numbers);
  a(read);
  EXPECT_TRUE(a.good());
  EXPECT_TRUE(a.atEnd());
  EXPECT_EQ(numbersOf(read), numbers);
  EXPECT_EQ(read.pace.empty, 3);
  EXPECT_EQ(read.held[1].key, written.held[1].key);
  EXPECT_EQ(read.held[1].lambda, written.held[1].lambda);
}

TEST(HeldState, FitsOnlyAModelWithItsElementsAndSizes) {
  const fixture::SledgeScene scene({0, 0}, {1, 0}, fixture::SledgeScene::pull(0.0), 0.5);
  const SystemParts& parts = scene.system->parts();
  EXPECT_TRUE(someState().fits(parts));
  HeldState element = someState(), rows = element, first = element, missing = element,
            jacobian = element;
  element.held[0].key = contactKey(1, 7);
  rows.held[1].rows = kMostRows + 1;
  first.held[1].first = -1;
  missing.missing = {1};
  jacobian.jacobian.resize(8);
  for (const HeldState* wrong : {&element, &rows, &first, &missing, &jacobian})
    EXPECT_FALSE(wrong->fits(parts));
}

}  // namespace
}  // namespace dynamy
