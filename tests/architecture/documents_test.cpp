/// The documents hold together: links lead somewhere, cited literature is listed, equations that
/// code cites exist, and every marked block is one that a test can take out.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "architecture/source_tree.hpp"

namespace dynamy::architecture {
namespace {

std::string folderWithSlash(const std::string& path) {
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
  if (path.ends_with(".png") || path.ends_with(".gif"))
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

std::vector<std::string> matches(const std::string& line, const char* pattern) {
  std::vector<std::string> all;
  const std::regex regex(pattern);
  for (std::sregex_iterator it(line.begin(), line.end(), regex), end; it != end; ++it)
    all.push_back((*it)[1]);
  return all;
}

// What a link may name behind its #: explicit ids, and headings as web pages of Markdown name them.
std::set<std::string> parts(const SourceFile& file) {
  std::set<std::string> all;
  for (const auto& [id, line] : found(file, R"re(<a id="([^"]+)">)re")) all.insert(id);
  for (const auto& [heading, line] : found(file, R"(^#+ (.*)$)")) {
    std::string slug;
    for (const char c : heading) {
      if (c == ' ')
        slug += '-';
      else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c < 0)
        slug += static_cast<char>(c < 0 ? c : std::tolower(c));
    }
    all.insert(slug);
  }
  return all;
}

}  // namespace

TEST(Documents, LinksLeadToFilesAndTheirParts) {
  for (const SourceFile* file :
       filesUnder({"doc/", "framework/", "README.md", "CONTRIBUTING.md"}, {".md"}))
    for (const auto& [link, line] : found(*file, R"(\]\(([^):]+)\))")) {
      const std::size_t hash = link.find('#');
      const std::string target =
          hash == 0 ? file->path : withoutDots(folderWithSlash(file->path) + link.substr(0, hash));
      EXPECT_TRUE(exists(target)) << place(*file, line) << ": " << link;
      if (hash == std::string::npos || !exists(target)) continue;
      EXPECT_TRUE(parts(sourceFile(target)).contains(link.substr(hash + 1)))
          << place(*file, line) << ": " << link;
    }
}

TEST(Documents, EveryPageIsLinkedFromTheIndexInTwoClicks) {
  std::set<std::string> reached;
  const auto linked = [&](const SourceFile& from) {
    for (const auto& [link, line] : found(from, R"(\]\(([^):#]+)(?:#[^)]*)?\))"))
      reached.insert(withoutDots(folderWithSlash(from.path) + link));
  };
  linked(sourceFile("doc/index.md"));
  for (const std::string& page : std::set<std::string>(reached))
    if (page.ends_with(".md")) linked(sourceFile(page));
  for (const SourceFile* file : filesUnder({"doc/"}, {".md", ".svg"}))
    EXPECT_TRUE(file->path == "doc/index.md" || reached.contains(file->path)) << file->path;
}

TEST(Documents, CitedSectionsAndEquationsExist) {
  std::set<std::string> sections, equations;
  for (const SourceFile* file : filesUnder({"doc/theory/"}, {".md"})) {
    for (const auto& [number, line] : found(*file, R"(^#+ (?:Note )?(\d+(?:\.\d+)?) )"))
      sections.insert(number);
    for (const auto& [number, line] : found(*file, R"(^ {4}\((\d+\.\d+)\) )"))
      equations.insert(number);
  }
  ASSERT_GT(equations.size(), 50u);
  for (const SourceFile* file :
       filesUnder({"framework/", "elements/", "plugins/", "app/", "tests/", "doc/"},
                  {".hpp", ".cpp", ".md"}))
    for (std::size_t i = 0; i < file->lines.size(); ++i) {
      const std::string& line = file->lines[i];
      const std::string where = place(*file, static_cast<int>(i) + 1) + ": " + line;
      for (const std::string& number : matches(line, R"(\btheory (\d+(?:\.\d+)?))"))
        EXPECT_TRUE(sections.contains(number)) << where;
      // Equations stand in parentheses; those of a book behind its key.
      const bool comment = line.find("///") != std::string::npos || file->path.ends_with(".md");
      if (!comment || std::regex_search(line, std::regex(R"(\[[a-z_]+\d{4})"))) continue;
      for (const std::string& number : matches(line, R"(\((\d{1,2}\.[1-9]\d?)\))")) {
        const bool ours = sections.contains(number.substr(0, number.find('.')));
        EXPECT_TRUE(!ours || equations.contains(number)) << where;
      }
    }
}

TEST(Documents, EveryModelIsShown) {
  const std::vector<std::string>& page = sourceFile("doc/models.md").lines;
  for (const SourceFile* model : filesUnder({"models/"}, {".xml"})) {
    const std::size_t from = std::string("models/").size();
    const std::string row = "| `" + model->path.substr(from, model->path.size() - from - 4) + "` |";
    EXPECT_TRUE(std::any_of(page.begin(), page.end(),
                            [&](const std::string& line) { return line.starts_with(row); }))
        << "doc/models.md has no row " << row;
  }
}

TEST(Documents, EveryLawIsComparedWithANumberFromOutside) {
  const SourceFile& page = sourceFile("doc/laws.md");
  std::set<std::string> tests;
  for (const SourceFile* file : filesUnder({"tests/", "plugins/"}, {".cpp"})) {
    std::string all;
    for (const std::string& line : file->lines) all += line;
    for (const std::string& name : matches(all, R"(\bTEST(?:_F|_P)?\((\w+, *\w+)\))"))
      tests.insert(std::regex_replace(name, std::regex(", *"), "."));
  }
  // The tests and models that rows name exist; the first table, a row for each law, names one.
  std::set<std::string> compared;
  bool first = true;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const std::string& line = page.lines[i];
    first = first && !line.starts_with("## ");
    if (!line.starts_with("| `")) continue;
    const std::vector<std::string> named = matches(line, R"(`(\w+\.\w+)`)"),
                                   models = matches(line, R"(model `(\w+)`)");
    const std::string where = place(page, static_cast<int>(i) + 1) + ": ";
    for (const std::string& test : named) EXPECT_TRUE(tests.contains(test)) << where << test;
    for (const std::string& model : models)
      EXPECT_TRUE(exists("models/" + model + ".xml")) << where << model;
    if (first && named.size() + models.size() > 0) compared.insert(matches(line, "^. `(\\w+)`")[0]);
  }
  for (const auto& [law, line] : found(sourceFile("doc/reference/law.md"), "^## (\\w+)"))
    EXPECT_TRUE(compared.contains(law)) << "doc/laws.md has no row for " << law;
  EXPECT_GE(compared.size(), 14u);
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

TEST(Documents, EverySnippetIsTakenOutByATest) {
  // Of the architecture the next test speaks, of the reference the tests of the program.
  const std::set<std::string> languages{"```xml", "```cpp", "```python", "```cmake"};
  for (const SourceFile* file : filesUnder({"doc/", "README.md"}, {".md"})) {
    const std::string& path = file->path;
    if (path.starts_with("doc/reference/") || path == "doc/architecture.md") continue;
    for (std::size_t i = 1; i < file->lines.size(); ++i)
      if (languages.contains(file->lines[i])) {
        EXPECT_TRUE(file->lines[i - 1].starts_with("<!-- test: "))
            << place(*file, static_cast<int>(i) + 1);
      }
  }
}

TEST(Documents, EveryPageWithMarkedBlocksIsFollowed) {
  std::string tests;
  for (const std::string& line : sourceFile("tests/program/documents_run_test.cpp").lines)
    tests += line;
  for (const SourceFile* file : filesUnder({"doc/", "README.md"}, {".md"}))
    if (std::any_of(file->lines.begin(), file->lines.end(),
                    [](const std::string& line) { return line.starts_with("<!-- test: "); })) {
      EXPECT_NE(tests.find("follow(\"" + file->path + "\")"), std::string::npos) << file->path;
    }
}

TEST(Documents, EveryElementIsLinkedFromTheIndexInTwoClicks) {
  // doc/index.md → doc/reference/index.md → the element
  std::set<std::string> linked;
  for (const auto& [link, line] : found(sourceFile("doc/reference/index.md"), R"(\]\(([^):]+)\))"))
    linked.insert("doc/reference/" + link);
  for (const SourceFile* file : filesUnder({"doc/reference/"}, {".md"}))
    for (const auto& [element, line] : found(*file, R"re(<a id="([A-Z][^"]+)">)re"))
      EXPECT_TRUE(linked.contains(file->path + "#" + element)) << place(*file, line);
}

TEST(Documents, TheArchitectureShowsTheStepThatIsCompiled) {
  const auto bare = [](std::string line) {
    line = withoutComment(line);
    std::erase_if(line, [](unsigned char c) { return std::isspace(c) != 0; });
    return line;
  };
  std::string compiled;
  for (const std::string& line : sourceFile("framework/dynamy/schemes/moreau_midpoint.cpp").lines)
    compiled += bare(line);
  bool inside = false;
  int shown = 0;
  for (const std::string& line : sourceFile("doc/architecture.md").lines) {
    if (line == "```") inside = false;
    if (inside) {
      EXPECT_NE(compiled.find(bare(line)), std::string::npos) << line;
    }
    shown += inside ? 1 : 0;
    inside = inside || line == "```cpp";
  }
  EXPECT_GE(shown, 6);
}

TEST(Documents, MarkedBlocksCanBeTakenOut) {
  const std::regex known(
      R"(<!-- test: (run \S+\.xml|check \S+\.xml|file \S+|build \S+|shell( fails \d+)?|inside [a-z]+|python|module|output) -->)");
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
