/// A class is one idea: few functions, few data, its functions in at most two files. Tables state
/// the classes that are larger, and why. A row that has become wrong fails, in both directions: a
/// class of the table may not grow, and one that has become smaller leaves it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "architecture/class_parser.hpp"
#include "architecture/source_tree.hpp"

namespace dynamy::architecture {
namespace {

const std::vector<std::string> kFolders = {"framework/", "elements/", "app/", "plugins/"};

constexpr int kMostFunctions = 20, kMostData = 20, kMostFiles = 2;

struct LargeClass {
  std::string name;
  int functions, data;
  std::string why;
};

/// What holds a whole model or a whole run may have 40 functions.
constexpr int kMostOfAWhole = 40;
const std::set<std::string> kWholes = {"Model", "Simulation"};

const std::vector<LargeClass> kLarge = {};

struct SpreadClass {
  std::string name;
  int files;
  std::string why;
};

const std::vector<SpreadClass> kSpread = {};

bool isTest(const SourceFile& file) { return file.path.ends_with("_test.cpp"); }

std::string textOf(const SourceFile& file) {
  std::string text;
  for (const std::string& line : file.lines) text += line + '\n';
  return text;
}

struct Placed {
  ClassSize size;
  std::string path;
};

std::vector<Placed> allClasses() {
  std::vector<Placed> out;
  for (const SourceFile* file : filesUnder(kFolders, {".hpp", ".cpp"})) {
    if (isTest(*file)) continue;
    for (ClassSize& size : classesIn(tokensOf(textOf(*file))))
      out.push_back({std::move(size), file->path});
  }
  return out;
}

std::string row(const ClassSize& c) {
  return '{' + c.name + ", " + std::to_string(c.functions) + ", " + std::to_string(c.data) + '}';
}

/// The length of what two paths have in common at their beginning.
std::size_t common(const std::string& a, const std::string& b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first -
                                  a.begin());
}

/// The .cpp files with member functions of each class, by the class and the file that defines it.
/// Of classes with the same name the one nearest to the .cpp counts.
std::map<std::pair<std::string, std::string>, std::set<std::string>> filesOfClasses() {
  std::map<std::string, std::vector<std::string>> homes;
  for (const Placed& p : allClasses()) homes[p.size.name].push_back(p.path);
  std::map<std::pair<std::string, std::string>, std::set<std::string>> out;
  for (const SourceFile* file : filesUnder(kFolders, {".cpp"})) {
    if (isTest(*file)) continue;
    for (const std::string& name : classesDefinedOutside(tokensOf(textOf(*file)))) {
      const auto found = homes.find(name);
      if (found == homes.end()) continue;
      const auto nearest = std::max_element(found->second.begin(), found->second.end(),
                                            [&](const std::string& a, const std::string& b) {
                                              return common(a, file->path) < common(b, file->path);
                                            });
      out[{name, *nearest}].insert(file->path);
    }
  }
  return out;
}

}  // namespace

TEST(ClassSize, AClassHasAtMost20FunctionsAnd20Data) {
  std::set<std::string> seen;
  for (const auto& [size, path] : allClasses()) {
    const int functions = kWholes.contains(size.name) ? kMostOfAWhole : kMostFunctions;
    const bool large = size.functions > functions || size.data > kMostData;
    const auto stated = std::find_if(kLarge.begin(), kLarge.end(),
                                     [&](const LargeClass& c) { return c.name == size.name; });
    if (stated == kLarge.end()) {
      EXPECT_FALSE(large) << path << ": " << row(size) << ": divide it by what it is about";
    } else if (large) {
      seen.insert(size.name);
      EXPECT_TRUE(size.functions <= stated->functions && size.data <= stated->data)
          << path << ": " << row(size) << " has grown";
      EXPECT_FALSE(size.functions < stated->functions || size.data < stated->data)
          << path << ": " << row(size) << " is smaller than its row: correct the row";
    }
  }
  for (const LargeClass& c : kLarge)
    EXPECT_TRUE(seen.contains(c.name)) << c.name << " is not large: take its row off";
}

TEST(ClassSize, AClassHasItsFunctionsInAtMostTwoFiles) {
  std::set<std::string> seen;
  for (const auto& [of, files] : filesOfClasses()) {
    const auto& [name, path] = of;
    const int count = static_cast<int>(files.size());
    if (count <= kMostFiles) continue;
    std::string list;
    for (const std::string& file : files) list += "\n  " + file;
    const auto stated = std::find_if(kSpread.begin(), kSpread.end(),
                                     [&, &n = name](const SpreadClass& c) { return c.name == n; });
    EXPECT_NE(stated, kSpread.end()) << name << " of " << path << " stands in" << list;
    if (stated == kSpread.end()) continue;
    seen.insert(name);
    EXPECT_EQ(count, stated->files) << name << " of " << path << " stands in" << list;
  }
  for (const SpreadClass& c : kSpread)
    EXPECT_TRUE(seen.contains(c.name)) << c.name << " stands in two files: take its row off";
}

}  // namespace dynamy::architecture
