/// Problems of a run that are not solved, or that are written for `dynamy solve`.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/io/hdf5/hdf5_file.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

using ProblemsTest = ProgramTest;

/// A slider between two walls that come closer: no motion fulfils both laws.
std::string squeezed(const std::string& policy) {
  return R"(<dynamy version="1">
  <systems><Coordinates name="slider" q="x" units="m" M="1"/></systems>
  <elements>
    <CoordinateContact name="left" on="slider" gap="x - 0.1*t"><Unilateral/></CoordinateContact>
    <CoordinateContact name="right" on="slider" gap="-x - 0.1*t"><Unilateral/></CoordinateContact>
  </elements>
  <simulation until="10ms" step="1ms")" +
         policy + "/>\n</dynamy>\n";
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(ProblemsTest, AnUnsolvedStepSaysWhereWhatWasTriedAndWhatToDo) {
  write("squeezed.xml", squeezed(" onNonConvergence=\"warn\""));
  call("run squeezed.xml --out r");
  for (const char* part :
       {"NOT CONVERGED", "NOT SOLVED  step 1 (t = 0.001 s) is the worst", "(squeezed.xml:4:",
        "tried: sweeps (", "then proximal Newton", "Gauss-Seidel (", "Jammed and squeezed: left",
        "Make room for the body between them", "Try a smaller --step", "--dump-problems 0"})
    EXPECT_TRUE(says(out(), part)) << part << "\n" << out();
  // Huge forces hide the contradiction in the rounding of their difference.
  EXPECT_FALSE(says(out(), "the problem has a solution")) << out();
  const std::string facts = readWholeFile(path("r/run.json"));
  for (const char* part : {"\"unsolved\": {", "\"status\": \"stalled\"", "\"tried\": \"sweeps ("})
    EXPECT_TRUE(says(facts, part)) << part;
}

TEST_F(ProblemsTest, ARunThatStopsThereNamesTheContactAndWritesTheProblem) {
  write("squeezed.xml", squeezed(" onNonConvergence=\"stop\""));
  EXPECT_EQ(call("run squeezed.xml --out r --dump-problems 0"), 1);
  EXPECT_TRUE(says(err(), "the inclusion was not solved")) << err();
  EXPECT_TRUE(says(err(), "(squeezed.xml:4:")) << err();
  EXPECT_TRUE(fs::exists(path("r/problems/step_0000001.hdf5"))) << out();
  EXPECT_EQ(call("solve r/problems/step_0000001.hdf5"), 1);
  EXPECT_TRUE(says(out(), "NOT solved")) << out();
  EXPECT_TRUE(says(out(), "squeezed")) << out();
  EXPECT_EQ(call("solve r/problems/step_0000001.hdf5 --json"), 1);
  EXPECT_TRUE(says(out(), "\"name\": \"contradiction\"")) << out();
}

TEST_F(ProblemsTest, ProblemsOfTheModelsAreSolvedAgainWithTheSameResult) {
  int compared = 0;
  for (const char* model : {"block_on_slope", "falling_box", "rocking_block", "slide_to_roll",
                            "sliding_puck", "woodpecker_expressions"}) {
    call("run '" + std::string(DYNAMY_SOURCE_DIR) + "/models/" + model +
         ".xml' --until 0.2 --step 1ms --out r --dump-problems 3");
    ASSERT_TRUE(fs::exists(path("r/problems"))) << model << err() << out();
    for (const auto& entry : fs::directory_iterator(path("r/problems"))) {
      const std::string file = entry.path().string();
      EXPECT_EQ(call("solve '" + file + "' --tolerance 1e-12 --reactions again.hdf5"), 0)
          << model << out();
      const FclibProblem problem = readFclib(file);
      const Hdf5File before(file, Hdf5File::Mode::read),
          after(path("again.hdf5"), Hdf5File::Mode::read);
      // Both are solved to 1e-10 and better of what is asked; W⁻¹ may add three digits to forces.
      const double u = problem.q.lpNorm<Eigen::Infinity>();
      EXPECT_LT(
          (before.numbers("/solution/u") - after.numbers("/solution/u")).lpNorm<Eigen::Infinity>(),
          1e-8 * u)
          << model << ' ' << file;
      const Eigen::VectorXd r = before.numbers("/solution/r");
      const bool unique = !says(out(), "Forces not unique") && !says(out(), "Jam");
      if (unique) {
        EXPECT_LT((r - after.numbers("/solution/r")).lpNorm<Eigen::Infinity>(),
                  1e-6 * (r.lpNorm<Eigen::Infinity>() + 1e-300))
            << model << ' ' << file;
      }
      ++compared;
    }
  }
  EXPECT_GE(compared, 12);
}

TEST_F(ProblemsTest, LawsWithoutPlaceInTheLayoutAreLeftOutWithTheReason) {
  call("run '" + std::string(DYNAMY_SOURCE_DIR) +
       "/models/belt_oscillator.xml' --until 0.1 --out r --dump-problems 2");
  EXPECT_TRUE(says(out(), "left out")) << out();
  EXPECT_TRUE(says(out(), "FCLIB's layout has no law <GivenFriction>")) << out();
}

TEST_F(ProblemsTest, ANewRunRemovesTheProblemsOfTheOldOne) {
  const std::string run =
      "run '" + std::string(DYNAMY_SOURCE_DIR) + "/models/rocking_block.xml' --until 0.05 --out r";
  call(run + " --dump-problems 2");
  EXPECT_FALSE(fs::is_empty(path("r/problems")));
  call(run);
  EXPECT_TRUE(fs::is_empty(path("r/problems")));
}

}  // namespace
}  // namespace dynamy
