// A user's scheme, solver and observer, from a shared library, run together.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

namespace fs = std::filesystem;

TEST(Showcase, SchemeSolverAndObserverOfAPluginRunTogether) {
  LoadedModel loaded("plugins/showcase/showcase.xml");
  Model& model = loaded.model();
  EXPECT_EQ(model.scheme().type(), "VelocityFirst");
  EXPECT_EQ(model.solver().type(), "FixedPoint");
  ASSERT_EQ(model.observers().size(), 1u);

  // The observer writes into the current folder: one of its own.
  const fs::path before = fs::current_path();
  std::string folder = (fs::temp_directory_path() / "dynamy_showcase_XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  fs::current_path(folder);
  Simulation simulation(model);
  const RunReport& report = simulation.run();
  double impulse = 0.0;
  std::ifstream(fs::path(folder) / "impulse.txt") >> impulse;
  fs::current_path(before);
  fs::remove_all(folder);

  EXPECT_EQ(report.ended, RunReport::Ended::finished) << report.reason;
  EXPECT_EQ(report.solver.unconverged, 0);
  // Momentum: Σ Λ_N = m g T + m (u(T) − u(0)) for every scheme that steps velocities like this, but
  // for rounding of 20 000 sums.
  EXPECT_NEAR(impulse, 2.0 * 9.81 * 2.0 + 2.0 * simulation.state().u[0], 1e-9);
  expectChecksHold(simulation);
}

}  // namespace
}  // namespace dynamy
