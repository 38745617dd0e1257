/// What README.md shows is what the tests build.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "architecture/source_tree.hpp"

namespace dynamy::architecture {
namespace {

// The lines of the first block of the language, without its fences.
std::vector<std::string> firstBlock(const SourceFile& file, const std::string& language) {
  std::vector<std::string> block;
  bool inside = false;
  for (const std::string& line : file.lines) {
    if (inside && line == "```") break;
    if (inside) block.push_back(line);
    if (line == "```" + language) inside = true;
  }
  return block;
}

}  // namespace

TEST(Readme, ShowsThePluginThatTheInstallTestBuilds) {
  const std::vector<std::string> shown = firstBlock(sourceFile("README.md"), "cpp");
  EXPECT_EQ(shown, sourceFile("plugins/template/pendulum_wall.cpp").lines);
  EXPECT_LE(shown.size(), 40u) << "a user element with registration fits in 40 lines";
}

}  // namespace dynamy::architecture
