/// doc/trust.md shows what the campaigns wrote into doc/trust/*.csv, and a row for every known
/// defect that a test states.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "architecture/source_tree.hpp"

namespace dynamy::architecture {
namespace {

constexpr const char* kPage = "doc/trust.md";

// The fields of a line of CSV; a field in quotes may hold commas, and "" for a quote.
std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && inside && i + 1 < line.size() && line[i + 1] == '"')
      out.back() += line[++i];
    else if (line[i] == '"')
      inside = !inside;
    else if (line[i] == ',' && !inside)
      out.emplace_back();
    else
      out.back() += line[i];
  }
  return out;
}

std::string tableRow(const std::vector<std::string>& cells) {
  std::string out = "|";
  for (const std::string& cell : cells)
    out += " " + std::regex_replace(cell, std::regex(R"(\|)"), "\\|") + " |";
  return out;
}

// The lines between <!-- trust: NAME --> and <!-- end -->.
std::vector<std::string> tableOf(const std::string& campaign) {
  std::vector<std::string> out;
  bool inside = false;
  for (const std::string& line : sourceFile(kPage).lines) {
    if (line == "<!-- end -->") inside = false;
    if (inside) out.push_back(line);
    if (line == "<!-- trust: " + campaign + " -->") inside = true;
  }
  return out;
}

}  // namespace

TEST(Trust, PageShowsWhatTheCampaignsWrote) {
  const std::vector<std::string> columns{"part", "commit", "count", "seeds", "found", "limits"};
  const auto files = filesUnder({"doc/trust/"}, {".csv"});
  ASSERT_FALSE(files.empty());
  for (const SourceFile* file : files) {
    ASSERT_FALSE(file->lines.empty()) << file->path;
    EXPECT_EQ(fields(file->lines[0]), columns) << file->path;
    const std::size_t from = std::string("doc/trust/").size();
    std::vector<std::string> expected{tableRow(columns), "|---|---|---|---|---|---|"};
    for (std::size_t i = 1; i < file->lines.size(); ++i) {
      EXPECT_EQ(fields(file->lines[i]).size(), columns.size())
          << place(*file, static_cast<int>(i) + 1);
      expected.push_back(tableRow(fields(file->lines[i])));
    }
    EXPECT_EQ(tableOf(file->path.substr(from, file->path.size() - from - 4)), expected)
        << file->path << " and " << kPage << " differ: scripts/trust table draws the page anew";
  }
}

TEST(Trust, EveryKnownDefectHasATestAndARow) {
  std::set<std::string> tests, rows;
  const std::regex call(R"re(knownDefect\("(\w+)")re"), row(R"(^\| `(\w+)` \|)");
  std::smatch match;
  for (const SourceFile* file : filesUnder({"tests/", "plugins/"}, {".cpp", ".py"})) {
    std::string all;
    for (const std::string& line : file->lines) all += line + "\n";
    for (std::sregex_iterator it(all.begin(), all.end(), call), end; it != end; ++it)
      tests.insert((*it)[1]);
  }
  bool section = false;
  for (const std::string& line : sourceFile(kPage).lines) {
    if (line.starts_with("## ")) section = line == "## Known defects";
    if (section && std::regex_search(line, match, row)) rows.insert(match[1]);
  }
  EXPECT_FALSE(tests.empty());
  for (const std::string& name : tests)
    EXPECT_TRUE(rows.contains(name)) << kPage << " has no row for the known defect " << name;
  for (const std::string& name : rows)
    EXPECT_TRUE(tests.contains(name)) << kPage << ": no test states the known defect " << name;
}

}  // namespace dynamy::architecture
