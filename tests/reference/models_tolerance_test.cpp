// Which models run to a tolerance: the table of doc/models.md.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <reference/located/located_run.hpp>
#include <set>

namespace dynamy::reference {
namespace {

/// Names behind each word of the first column: expensive, stepped, located.
std::map<std::string, std::set<std::string>> documented() {
  std::map<std::string, std::set<std::string>> out;
  std::ifstream page(DYNAMY_SOURCE_DIR "/doc/models.md");
  bool here = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) here = line == "## With a tolerance";
    if (!here || !line.starts_with("| ")) continue;
    const std::string word = line.substr(2, line.find(' ', 2) - 2);
    for (std::size_t i = line.find('`'); i != std::string::npos;) {
      const std::size_t end = line.find('`', i + 1);
      out[word].insert(line.substr(i + 1, end - i - 1));
      i = line.find('`', end + 1);
    }
  }
  return out;
}

std::set<std::string> allModels() {
  std::set<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(DYNAMY_SOURCE_DIR "/models"))
    if (entry.path().extension() == ".xml") out.insert(entry.path().stem().string());
  return out;
}

constexpr double kUntil = 0.02;  ///< [s]

TEST(ModelsToATolerance, RunAsTheirPageSays) {
  const auto table = documented();
  ASSERT_TRUE(table.contains("expensive"));
  for (const std::string& name : allModels()) {
    if (table.at("expensive").contains(name)) continue;
    LocatedRun run(name, 1e-5, kUntil);
    const RunReport& r = run.run();
    EXPECT_EQ(r.ended, RunReport::Ended::finished) << name << ": " << r.reason;
    EXPECT_EQ(r.stepping.periods, 0) << name;
    const auto warned = [](const Warning& w) {
      return w.kind == "time stepping" || w.kind == "stepped";
    };
    EXPECT_FALSE(std::any_of(r.warnings.begin(), r.warnings.end(), warned)) << name;
  }
  for (const std::string& name : table.at("expensive"))
    EXPECT_TRUE(allModels().contains(name)) << "doc/models.md: expensive " << name;
}

}  // namespace
}  // namespace dynamy::reference
