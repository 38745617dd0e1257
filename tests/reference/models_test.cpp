/// Every file of models/ is run as the program runs it, and all of its <check>s must hold.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <support/load_model.hpp>

namespace dynamy::reference {
namespace {

std::vector<std::string> modelFiles() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(DYNAMY_SOURCE_DIR "/models"))
    if (entry.path().extension() == ".xml") out.push_back(entry.path().stem().string());
  std::sort(out.begin(), out.end());
  return out;
}

/// Velocities that doc/models.md tells of a model: "| … | 6, 3 | steps, time |".
int documentedVelocities(const std::string& name) {
  std::ifstream page(DYNAMY_SOURCE_DIR "/doc/models.md");
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `" + name + "` |")) continue;
    const std::size_t cost = line.rfind(" | "), size = line.rfind("| ", cost - 1);
    return std::stoi(line.substr(size + 2));
  }
  return -1;
}

class Models : public testing::TestWithParam<std::string> {};

TEST_P(Models, PassTheirChecks) {
  LoadedModel loaded("models/" + GetParam() + ".xml", {}, true);
  Simulation simulation(loaded.model());
  const RunReport& report = simulation.run();
  EXPECT_EQ(report.ended, RunReport::Ended::finished) << report.reason;
  EXPECT_EQ(report.solver.unconverged, 0);
  expectChecksHold(simulation);
  EXPECT_EQ(loaded.model().topology().nu(), documentedVelocities(GetParam()));
  RecordProperty("cpu_ms", static_cast<int>(1000.0 * report.cost.cpu));
}

TEST(LongHopper, OfAThousandBallsRunsOutAndRests) {
  // The model's own checks; the mass by a second program of the generator, as in the model.
  // Twice the usual outlet: with 40 mm one of 2946 steps stalls at 5.04e-3 (theory 38.6).
  LoadedModel loaded("models/hopper.xml",
                     {{"n", "1000"}, {"mass", "1.3486389419475449"}, {"b", "40mm"}});
  loaded.model().simulation.until = 3.0;
  Simulation simulation(loaded.model());
  const RunReport& report = simulation.run();
  EXPECT_EQ(report.ended, RunReport::Ended::finished) << report.reason;
  EXPECT_EQ(report.solver.unconverged, 0);
  expectChecksHold(simulation);
}

std::string modelName(const testing::TestParamInfo<std::string>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Files, Models, testing::ValuesIn(modelFiles()), modelName);

}  // namespace
}  // namespace dynamy::reference
