#include <gtest/gtest.h>
#include <dynamy/core/version.hpp>

#include <string>

namespace dynamy {

TEST(Version, LibraryReportsTheVersionOfItsHeaders) {
  const std::string expected = std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor) +
                               "." + std::to_string(kVersionPatch);
  EXPECT_EQ(versionString(), expected);
}

}  // namespace dynamy
