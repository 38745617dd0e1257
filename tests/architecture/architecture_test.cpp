/// Rules of the layout that no compiler checks, read from the sources themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "architecture/source_tree.hpp"

namespace dynamy::architecture {
namespace {

// The part before the first '/' of what follows `prefix`; empty for a file directly under it.
std::string folderBelow(const std::string& prefix, const std::string& path) {
  const auto end = path.find('/', prefix.size());
  return end == std::string::npos ? "" : path.substr(prefix.size(), end - prefix.size());
}

// A position in this row: a room includes itself and what stands before it.
int layer(const std::string& folder) {
  static constexpr std::array kLayers = {"core",       "system", "law",     "contact",
                                         "solver",     "stages", "schemes", "located",
                                         "simulation", "io",     "testing"};
  const auto found = std::find(kLayers.begin(), kLayers.end(), folder);
  return found == kLayers.end() ? -1 : static_cast<int>(found - kLayers.begin());
}

}  // namespace

TEST(Architecture, TreeWasRead) { ASSERT_GT(filesUnder({"framework/"}, kCode).size(), 2u); }

TEST(Architecture, FrameworkFoldersAreTheAgreedLayers) {
  for (const SourceFile* file : filesUnder({"framework/dynamy/"}, kCode)) {
    if (file->path == "framework/dynamy/dynamy.hpp") continue;
    EXPECT_GE(layer(folderBelow("framework/dynamy/", file->path)), 0) << file->path;
  }
}

TEST(Architecture, FrameworkIncludesPointToEarlierLayers) {
  for (const SourceFile* file : filesUnder({"framework/dynamy/"}, kCode)) {
    if (file->path == "framework/dynamy/dynamy.hpp") continue;  // the one include of a plug-in
    const std::string own = folderBelow("framework/dynamy/", file->path);
    for (const Include& include : includesOf(*file)) {
      const std::string where = place(*file, include.line) + " includes " + include.name;
      EXPECT_FALSE(include.name.starts_with("dynamy_elements/")) << where;
      if (!include.name.starts_with("dynamy/")) continue;
      const std::string other = folderBelow("dynamy/", include.name);
      EXPECT_GE(layer(other), 0) << where;
      EXPECT_LE(layer(other), layer(own)) << where;
    }
  }
}

TEST(Architecture, ElementsAndPluginsIncludeNothingThatAUserCannot) {
  for (const SourceFile* file : filesUnder({"elements/", "plugins/"}, kCode)) {
    for (const Include& include : includesOf(*file)) {
      const std::string where = place(*file, include.line) + " includes " + include.name;
      EXPECT_FALSE(std::regex_search(include.name, std::regex("^(app|tests|bench|plugins)/")))
          << where;
      EXPECT_EQ(include.name.find("framework/"), std::string::npos) << where;
      if (file->path.starts_with("elements/")) {
        EXPECT_FALSE(include.name.starts_with("../")) << where;
      }
    }
  }
}

TEST(Architecture, FilesHaveAtMost500Lines) {
  for (const SourceFile& file : sourceTree()) {
    const bool counted = std::regex_search(file.path, std::regex(R"(\.(cpp|hpp|ts|js|py)$)"));
    // The built viewer script is made by a tool from app/viewer/*.ts.
    const bool built = std::regex_search(file.path, std::regex("^app/viewer/(dist|built)/"));
    if (counted && !built) {
      EXPECT_LE(file.lines.size(), 500u) << file.path;
    }
  }
}

TEST(Architecture, NoLineBreakCutsAnEquationInAComment) {
  // A line of an indented block that ends with an operator: its other side went to the next line.
  const std::regex pattern("^ *///? {2,}[^ ].* (=|\\+|−|·|×|∈|≤|≥|⇔|[0-9.]*½)$");
  for (const SourceFile* file :
       filesUnder({"framework/", "elements/", "app/", "plugins/", "bench/", "tests/"}, kCode))
    for (std::size_t i = 0; i < file->lines.size(); ++i)
      EXPECT_FALSE(std::regex_search(file->lines[i], pattern))
          << place(*file, static_cast<int>(i) + 1);
}

TEST(Architecture, Tinyxml2StaysInTheXmlReader) {
  for (const SourceFile* file :
       filesUnder({"framework/", "elements/", "plugins/", "app/"}, kCode)) {
    if (file->path.starts_with("framework/dynamy/io/xml")) continue;
    for (std::size_t i = 0; i < file->lines.size(); ++i) {
      EXPECT_EQ(withoutComment(file->lines[i]).find("tinyxml2"), std::string::npos)
          << place(*file, static_cast<int>(i) + 1);
    }
  }
}

TEST(Architecture, DynamicCastStaysInIo) {
  for (const SourceFile* file :
       filesUnder({"framework/", "elements/", "plugins/", "app/"}, kCode)) {
    if (file->path.starts_with("framework/dynamy/io/")) continue;
    for (std::size_t i = 0; i < file->lines.size(); ++i) {
      EXPECT_EQ(withoutComment(file->lines[i]).find("dynamic_cast<"), std::string::npos)
          << place(*file, static_cast<int>(i) + 1);
    }
  }
}

TEST(Architecture, HeadersBeginWithPragmaOnce) {
  for (const SourceFile* file : filesUnder({"framework/", "elements/", "plugins/"}, {".hpp"})) {
    EXPECT_NE(std::find(file->lines.begin(), file->lines.end(), "#pragma once"), file->lines.end())
        << file->path;
  }
}

TEST(Architecture, TopLevelHoldsNothingButTheAgreedFolders) {
  const std::set<std::string> agreed = {"CMakeLists.txt",
                                        "CMakePresets.json",
                                        "README.md",
                                        "LICENSE",
                                        "CITATION.cff",
                                        "CHANGELOG.md",
                                        "CONTRIBUTING.md",
                                        "framework",
                                        "elements",
                                        "plugins",
                                        "models",
                                        "tests",
                                        "doc",
                                        "app",
                                        "bench",
                                        "cmake",
                                        "scripts"};
  std::set<std::string> surplus;
  for (const SourceFile& file : sourceTree()) {
    const std::string top = file.path.substr(0, file.path.find('/'));
    if (!top.starts_with(".") && !agreed.contains(top)) surplus.insert(top);
  }
  EXPECT_TRUE(surplus.empty()) << *surplus.begin();
}

TEST(Architecture, NoFileNamesAFolderOfSomebodysMachine) {
  // A leading / that does not continue a longer path, URL or word.
  const std::regex pattern(R"((^|[^A-Za-z0-9_./>})~-])/(work|tmp|root|home|Users)/[A-Za-z0-9_])");
  for (const SourceFile& file : sourceTree()) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (file.lines[i].size() > 2000) continue;  // built scripts, data
      EXPECT_FALSE(std::regex_search(file.lines[i], pattern))
          << place(file, static_cast<int>(i) + 1);
    }
  }
}

}  // namespace dynamy::architecture
