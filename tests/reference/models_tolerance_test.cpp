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

/// Until then; those that are stepped in time come to it later [s].
constexpr double kUntil = 0.02, kUntilStepped = 0.9;

TEST(ModelsToATolerance, RunAsTheirPageSays) {
  const auto table = documented();
  ASSERT_TRUE(table.contains("stepped"));
  const std::set<std::string>& stepped = table.at("stepped");
  for (const std::string& name : allModels()) {
    if (table.at("expensive").contains(name)) continue;
    const bool late = stepped.contains(name);
    LocatedRun run(name, 1e-5, late ? kUntilStepped : kUntil);
    const RunReport& r = run.run();
    EXPECT_EQ(r.ended, RunReport::Ended::finished) << name << ": " << r.reason;
    EXPECT_EQ(r.stepping.periods > 0, late) << name;
    const auto warned = [](const Warning& w) {
      return w.kind == "time stepping" || w.kind == "stepped";
    };
    EXPECT_EQ(std::any_of(r.warnings.begin(), r.warnings.end(), warned), late) << name;
  }
  for (const char* word : {"expensive", "stepped"})
    for (const std::string& name : table.at(word))
      EXPECT_TRUE(allModels().contains(name)) << "doc/models.md: " << word << " " << name;
}

}  // namespace
}  // namespace dynamy::reference
