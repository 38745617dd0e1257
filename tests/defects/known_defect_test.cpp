/// The mark of known defects: it lets wrong results pass and right ones fail.
#include <gtest/gtest-spi.h>

#include <stdexcept>
#include <support/known_defect.hpp>

namespace dynamy {
namespace {

// Not a literal in the calls: names there need a row in doc/trust.md.
const std::string kName = "example";

TEST(KnownDefectMark, PassesWhileAnExpectationFails) {
  knownDefect(kName, [] {
    EXPECT_EQ(1, 1);
    EXPECT_EQ(1, 2);
  });
  knownDefect(kName, [] { ASSERT_TRUE(false); });
}

TEST(KnownDefectMark, FailsOnceAllExpectationsHold) {
  EXPECT_NONFATAL_FAILURE(knownDefect(kName, [] { EXPECT_EQ(1, 1); }),
                          "the known defect example is gone");
}

TEST(KnownDefectMark, LetsExceptionsPass) {
  EXPECT_THROW(knownDefect(kName, [] { throw std::runtime_error("no model"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace dynamy
