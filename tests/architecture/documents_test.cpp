/// The documents hold together: links lead somewhere, cited literature is listed, equations that
/// code cites exist, and every marked block is one that a test can take out.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "architecture/source_tree.hpp"

namespace dynamy::architecture {
namespace {

std::string folderOf(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

// "doc/tutorial/../index.md" → "doc/index.md"
std::string withoutDots(std::string path) {
  const std::regex up(R"([^/]+/\.\./)");
  while (std::regex_search(path, up))
    path = std::regex_replace(path, up, "", std::regex_constants::format_first_only);
  return path;
}

bool exists(const std::string& path) {
  // pictures are files, but no text
  if (path.ends_with(".png"))
    return std::filesystem::is_regular_file(std::filesystem::path(DYNAMY_SOURCE_DIR) / path);
  const auto& tree = sourceTree();
  return std::any_of(tree.begin(), tree.end(), [&](const SourceFile& f) {
    return f.path == path || f.path.starts_with(path + "/");
  });
}

// All matches of the first group outside of ``` blocks, with their lines.
std::vector<std::pair<std::string, int>> found(const SourceFile& file, const char* pattern) {
  std::vector<std::pair<std::string, int>> all;
  const std::regex regex(pattern);
  bool code = false;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string& line = file.lines[i];
    if (line.starts_with("```")) code = !code;
    if (code) continue;
    for (std::sregex_iterator it(line.begin(), line.end(), regex), end; it != end; ++it)
      all.emplace_back((*it)[1], static_cast<int>(i) + 1);
  }
  return all;
}

}  // namespace

TEST(Documents, LinksLeadToFiles) {
  for (const SourceFile* file : filesUnder({"doc/"}, {".md"}))
    for (const auto& [target, line] : found(*file, R"(\]\(([^)#:]+)\))"))
      EXPECT_TRUE(exists(withoutDots(folderOf(file->path) + target)))
          << place(*file, line) << ": " << target;
}

TEST(Documents, CitedLiteratureIsListed) {
  std::set<std::string> keys;
  std::smatch match;
  for (const std::string& line : sourceFile("doc/references.bib").lines)
    if (std::regex_search(line, match, std::regex(R"(^@\w+\{([^,]+),)"))) {
      EXPECT_TRUE(keys.insert(match[1]).second) << match[1] << " is listed twice";
    }
  // A key is a name and a year, [moreau1988]; indices such as [a, b] are not meant.
  for (const SourceFile* file : filesUnder({"doc/"}, {".md"}))
    for (const auto& [key, line] : found(*file, R"(\[([a-z_]+(?:18|19|20)[0-9]{2})\](?!\())"))
      EXPECT_TRUE(keys.contains(key)) << place(*file, line) << ": [" << key << "]";
}

TEST(Documents, EquationNumbersOfOnePageAreUnique) {
  for (const SourceFile* file : filesUnder({"doc/theory/"}, {".md"})) {
    std::set<std::string> seen;
    for (const auto& [number, line] : found(*file, R"(^ {4}\((\d+\.\d+)\) )"))
      EXPECT_TRUE(seen.insert(number).second) << place(*file, line) << ": (" << number << ")";
  }
}

TEST(Documents, MarkedBlocksCanBeTakenOut) {
  const std::regex known(
      R"(<!-- test: (run \S+\.xml|check \S+\.xml|file \S+|build \S+|shell( fails \d+)?|inside [a-z]+|output) -->)");
  for (const SourceFile* file : filesUnder({"doc/", "README.md"}, {".md"}))
    for (std::size_t i = 0; i + 1 < file->lines.size(); ++i) {
      if (!file->lines[i].starts_with("<!-- test:")) continue;
      EXPECT_TRUE(std::regex_match(file->lines[i], known))
          << place(*file, static_cast<int>(i) + 1) << ": " << file->lines[i];
      EXPECT_TRUE(file->lines[i + 1].starts_with("```"))
          << place(*file, static_cast<int>(i) + 2) << ": a block must follow";
    }
}

}  // namespace dynamy::architecture
