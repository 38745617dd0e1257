#include <gtest/gtest.h>

#include <dynamy/core/kept_text.hpp>

namespace dynamy {
namespace {

TEST(KeptText, OutlivesItsSourceAndIsKeptOnce) {
  std::string_view first;
  {
    const std::string source = "a text that is longer than what a string holds itself";
    first = keptText(source);
  }
  EXPECT_EQ(first, "a text that is longer than what a string holds itself");
  EXPECT_EQ(keptText(std::string(first)).data(), first.data());
}

}  // namespace
}  // namespace dynamy
