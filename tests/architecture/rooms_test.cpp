/// The folders of sources: few files each, a README that names them all and says what the folder
/// may include, no two folders that include each other, kernels compiled as kernels.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "architecture/source_tree.hpp"

namespace dynamy::architecture {
namespace {

const std::string kFramework = "framework/dynamy", kElements = "elements/dynamy_elements";

std::string folderOf(const std::string& path) { return path.substr(0, path.rfind('/')); }

// A header and its source count once; X_kernel.cpp belongs to X.hpp.
std::string stemOf(const std::string& path) {
  std::string name = path.substr(path.rfind('/') + 1);
  const bool source = name.ends_with(".cpp");
  name = name.substr(0, name.rfind('.'));
  if (source && name.ends_with("_kernel")) name.resize(name.size() - std::string("_kernel").size());
  return name;
}

std::map<std::string, std::set<std::string>> stemsByFolder(
    const std::vector<std::string>& folders) {
  std::map<std::string, std::set<std::string>> stems;
  for (const SourceFile* file : filesUnder(folders, kCode))
    stems[folderOf(file->path)].insert(stemOf(file->path));
  return stems;
}

// The two files that include everything: the one include of a plug-in, and the list of elements.
bool includesAll(const std::string& path) {
  return path == kFramework + "/dynamy.hpp" || path == kElements + "/register.cpp";
}

struct Arrow {
  std::string from, to, where;
};

// Includes of our headers from one folder to another.
std::vector<Arrow> arrows() {
  std::vector<Arrow> all;
  for (const SourceFile* file : filesUnder({kFramework + "/", kElements + "/"}, kCode)) {
    if (includesAll(file->path)) continue;
    for (const Include& include : includesOf(*file)) {
      std::string target;
      if (include.name.starts_with("dynamy/")) target = "framework/" + include.name;
      if (include.name.starts_with("dynamy_elements/")) target = "elements/" + include.name;
      if (target.empty() || folderOf(target) == folderOf(file->path)) continue;
      all.push_back({folderOf(file->path), folderOf(target),
                     place(*file, include.line) + " includes " + include.name});
    }
  }
  return all;
}

const SourceFile* readmeOf(const std::string& folder) {
  const auto found = filesUnder({folder + "/README.md"}, {});
  return found.empty() ? nullptr : found.front();
}

// All `words` in lines from the one that begins with `from` on.
std::set<std::string> quoted(const SourceFile& file, const std::string& from = "") {
  static const std::regex pattern("`([^`]+)`");
  std::set<std::string> words;
  bool inside = from.empty();
  for (const std::string& line : file.lines) {
    inside = inside || line.starts_with(from);
    if (!inside) continue;
    for (std::sregex_iterator it(line.begin(), line.end(), pattern), end; it != end; ++it)
      words.insert((*it)[1]);
  }
  return words;
}

// The folder and all that it includes over any number of arrows.
std::set<std::string> reachedFrom(const std::string& folder,
                                  const std::map<std::string, std::set<std::string>>& next) {
  std::set<std::string> reached;
  std::vector<std::string> open{folder};
  while (!open.empty()) {
    const std::string at = open.back();
    open.pop_back();
    if (!reached.insert(at).second || !next.contains(at)) continue;
    open.insert(open.end(), next.at(at).begin(), next.at(at).end());
  }
  return reached;
}

}  // namespace

TEST(Rooms, NoFolderHasMoreThan30Files) {
  for (const auto& [folder, stems] :
       stemsByFolder({"framework/", "elements/", "app/", "tests/", "plugins/"}))
    EXPECT_LE(stems.size(), 30u) << folder << ": find a room for some of them";
}

TEST(Rooms, EachFolderOfTheFrameworkHasAReadmeThatNamesItsFiles) {
  const auto folders = stemsByFolder({kFramework + "/"});
  ASSERT_GT(folders.size(), 20u);
  for (const auto& [folder, stems] : folders) {
    const SourceFile* readme = readmeOf(folder);
    ASSERT_NE(readme, nullptr) << folder << " has no README.md";
    EXPECT_LE(readme->lines.size(), 60u) << readme->path << ": a page";
    const std::set<std::string> named = quoted(*readme);
    for (const std::string& stem : stems)
      EXPECT_TRUE(named.contains(stem) || named.contains(stem + ".hpp"))
          << readme->path << " does not name " << stem;
  }
}

TEST(Rooms, ReadmesListFilesThatExist) {
  const std::regex row("^\\* `([a-z0-9_]+)`");
  for (const auto& [folder, stems] : stemsByFolder({kFramework + "/"})) {
    const SourceFile* readme = readmeOf(folder);
    ASSERT_NE(readme, nullptr) << folder;
    std::smatch match;
    for (const std::string& line : readme->lines)
      if (std::regex_search(line, match, row)) {
        EXPECT_TRUE(stems.contains(match[1])) << readme->path << ": " << line;
      }
  }
}

TEST(Rooms, FilesIncludeWhatTheReadmeOfTheirFolderAllows) {
  for (const Arrow& arrow : arrows()) {
    if (!arrow.from.starts_with(kFramework)) continue;
    const SourceFile* readme = readmeOf(arrow.from);
    ASSERT_NE(readme, nullptr) << arrow.from;
    const std::string other = arrow.to.substr(kFramework.size() + 1);
    // `solver` allows the folder solver, not the folders in it.
    EXPECT_TRUE(quoted(*readme, "May include: ").contains(other))
        << arrow.where << ", which \"May include\" in " << readme->path << " does not name";
  }
}

TEST(Rooms, NoTwoFoldersIncludeEachOther) {
  std::map<std::string, std::set<std::string>> next;
  for (const Arrow& arrow : arrows()) next[arrow.from].insert(arrow.to);
  for (const Arrow& arrow : arrows())
    EXPECT_FALSE(reachedFrom(arrow.to, next).contains(arrow.from))
        << arrow.where << ": part of a circle";
}

/// Sources of a line of compile_commands.json: the one that it names, or those of its batch.
std::vector<std::string> compiledBy(const std::string& line) {
  const std::string before = " -c ";
  const std::size_t at = line.rfind(before);
  if (at == std::string::npos) return {};
  // A path with blanks stands between quotes, which JSON writes as \".
  const std::string quote = "\\\"";
  const std::size_t first = at + before.size();
  const bool quoted = line.compare(first, quote.size(), quote) == 0;
  const std::size_t begin = quoted ? first + quote.size() : first;
  const std::size_t end = quoted ? line.find(quote, begin) : line.find_first_of(" \"", begin);
  const std::string source = line.substr(begin, end - begin);
  if (source.find("/Unity/") == std::string::npos) return {source};
  std::vector<std::string> out;
  std::ifstream batch(source);
  for (std::string text; std::getline(batch, text);)
    if (text.starts_with("#include \"")) out.push_back(text.substr(10, text.rfind('"') - 10));
  return out;
}

// Where there is no compiler cache, the tests of a folder are compiled as one source.
TEST(Rooms, TestsOfAFolderGiveANameToOneThing) {
  const std::regex named(
      R"(^(?:inline )?(?:constexpr|const) [^=({]*?\b(k[A-Z]\w*)\b|^(?:struct|class) (\w+))");
  std::map<std::string, std::string> first;
  for (const SourceFile* file : filesUnder({"tests/"}, {"_test.cpp"}))
    for (const std::string& line : file->lines) {
      std::smatch match;
      const bool declares = line.ends_with(';') && line.starts_with("struct");
      if (declares || !std::regex_search(line, match, named)) continue;
      const std::string name = match[1].matched ? match[1].str() : match[2].str();
      const auto [at, added] = first.emplace(folderOf(file->path) + " " + name, file->path);
      EXPECT_TRUE(added || at->second == file->path)
          << file->path << " and " << at->second << " both define " << name
          << ": if it is one thing, put it into a header, else rename one";
    }
}

// The build finds kernels by their names (dynamy_kernels); a file that loses its flags runs slower
// and says nothing.
TEST(Rooms, KernelsAreCompiledAsKernels) {
  std::ifstream stream(std::filesystem::path(DYNAMY_BINARY_DIR) / "compile_commands.json");
  if (!stream) GTEST_SKIP() << "this generator writes no compile_commands.json";
  std::set<std::string> compiled;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("\"command\"") == std::string::npos) continue;
    for (const std::string& source : compiledBy(line)) {
      if (!source.ends_with("_kernel.cpp")) continue;
      EXPECT_NE(line.find("-fno-semantic-interposition"), std::string::npos) << source;
      compiled.insert(source);
    }
  }
  std::size_t kernels = 0;
  for (const SourceFile* file : filesUnder({kFramework + "/", kElements + "/"}, {"_kernel.cpp"}))
    kernels += file->lines.empty() ? 0 : 1;
  // There were 46 when the rule was made; a move that loses the names would leave few or none.
  EXPECT_GE(kernels, 40u);
  EXPECT_GE(compiled.size(), kernels);
}

}  // namespace dynamy::architecture
