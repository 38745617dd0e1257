/// The program as users call it: exit codes, messages, the run folder, resume, Ctrl-C and kill -9.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <build_paths.hpp>

#include <chrono>
#include <cstdlib>
#include <dynamy/io/run_files/frames_file.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <filesystem>
#include <program/program_fixture.hpp>
#include <thread>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

/// A ball in the x–z plane with e = 0.8 and friction, as formulas.
std::string ballXml(double until, const std::string& step, const std::string& check = {}) {
  return R"(<dynamy version="1">
  <parameter name="e" value="0.8" min="0" max="0.999"/>
  <systems><Coordinates name="ball" q="x z" units="m m" q0="0 1" u0="1 0" M="1; 0; 0; 1"
    potential="9.81*z"/></systems>
  <elements><CoordinateContact name="floor" on="ball" gap="z" slip="1; 0">
    <UnilateralCoulomb epsilonN="{e}" mu="0.1"/></CoordinateContact></elements>
  <simulation until=")" +
         std::to_string(until) + "\" step=\"" + step + R"("/>
  <record signals="ball.* floor.*" every="10ms"/>
  )" + check +
         "\n</dynamy>\n";
}

class ProgramRunTest : public ProgramTest {
 protected:
  /// Starts the program and leaves it running.
  pid_t start(const std::vector<std::string>& arguments) const {
    const pid_t child = fork();
    if (child != 0) return child;
    std::vector<std::string> words = {std::string(DYNAMY_BINARY_DIR) + "/bin/dynamy"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& w : words) argv.push_back(w.data());
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
  }
  /// Waits until the file has more than `bytes`, at most 20 s.
  void waitFor(const std::string& file, std::uintmax_t bytes) const {
    std::error_code none;
    for (int i = 0; i < 2000; ++i) {
      const auto size = fs::file_size(path(file), none);
      if (!none && size > bytes) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    FAIL() << file << " stays small";
  }
};

TEST_F(ProgramTest, RunWritesACompleteFolderAndEndsWith0) {
  write("ball.xml", ballXml(1.0, "1e-3"));
  ASSERT_EQ(call("run ball.xml"), 0) << err();
  for (const char* file : {"run.json", "model.xml", "signals.csv", "signals.svg", "events.csv",
                           "ledger.csv", "frames.bin", "replay.html", "checkpoint"})
    EXPECT_TRUE(fs::exists(folder_ / "runs" / "ball" / file)) << file;
  EXPECT_NE(out().find("finished at t = 1 s"), std::string::npos) << out();
  const SignalTable table = readSignals(folder_ / "runs" / "ball" / "signals.csv");
  EXPECT_EQ(table.t.size(), 101u);
  EXPECT_EQ(table.t.back(), 1.0);
}

TEST_F(ProgramTest, ViewWritesTheReplayAnew) {
  write("ball.xml", ballXml(0.1, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out a"), 0) << err();
  fs::remove(path("a/replay.html"));
  ASSERT_EQ(call("view a --no-browser"), 0) << err();
  EXPECT_NE(out().find("replay.html"), std::string::npos) << out();
  EXPECT_GT(fs::file_size(path("a/replay.html")), 100'000u);
  EXPECT_EQ(call("view nowhere --no-browser"), 2);
  EXPECT_NE(err().find("nowhere: there is no such folder"), std::string::npos) << err();
}

TEST_F(ProgramTest, ContactForcesInTheFilmObeyCoulombsLaw) {
  ASSERT_EQ(call("run \"" DYNAMY_SOURCE_DIR "/models/block_on_slope_slide.xml\" --out b"), 0)
      << err();
  const Frames frames = readFrames(path("b/frames.bin"));
  int slipping = 0;
  for (std::size_t at = 0; at < frames.contact.size(); at += Frames::kContactNumbers) {
    const float* const x = &frames.contact[at];
    const Eigen::Map<const Eigen::Vector3f> n(x + 3), F(x + 6);
    const float N = n.dot(F), T = (F - N * n).norm(), limit = x[10];
    EXPECT_LE(T, limit * 1.0001f + 1e-6f);  // single precision
    if (x[9] != 2.f) continue;
    ++slipping;
    EXPECT_NEAR(T, limit, 1e-4f * limit);
  }
  EXPECT_GT(slipping, 10);
}

TEST_F(ProgramTest, AFailedCheckEndsWith1) {
  write("ball.xml", ballXml(0.1, "1e-3", R"(<check signal="ball.z" value="5" tolerance="1e-3"/>)"));
  EXPECT_EQ(call("run ball.xml"), 1);
  EXPECT_NE(out().find("FAIL"), std::string::npos) << out();
}

TEST_F(ProgramTest, AModelErrorEndsWith2AndLeavesAnOlderRunAlone) {
  write("ball.xml", ballXml(0.1, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out o"), 0) << err();
  const std::string before = readWholeFile(path("o/run.json"));
  EXPECT_EQ(call("run ball.xml --out o --integrator MoreauMidpiont"), 2);
  EXPECT_NE(err().find("did you mean \"MoreauMidpoint\"?"), std::string::npos) << err();
  EXPECT_EQ(call("run nowhere.xml --out o"), 2);
  EXPECT_EQ(readWholeFile(path("o/run.json")), before);
}

TEST_F(ProgramTest, WrongUsageEndsWith64AndASuggestion) {
  EXPECT_EQ(call("rnu ball.xml"), 64);
  EXPECT_NE(err().find("did you mean \"run\"?"), std::string::npos) << err();
  EXPECT_EQ(call("run ball.xml --untl 3"), 64);
  EXPECT_NE(err().find("did you mean \"--until\"?"), std::string::npos) << err();
  EXPECT_EQ(call(""), 64);
  EXPECT_EQ(call("run ball.xml --step 3kg"), 64);
}

TEST_F(ProgramTest, AStepTakesTheTolerancesPlaceAndItTheSteps) {
  std::string text = ballXml(0.1, "1e-3");
  write("step.xml", text);
  const std::string step = "step=\"1e-3\"/>";
  text.replace(text.find(step), step.size(), "tolerance=\"1e-6\"/>");
  write("tolerance.xml", text);
  text.replace(text.find("1e-6\"/>"), 7, "1e-6\"><LocatedDormandPrince/></simulation>");
  write("named.xml", text);
  text = ballXml(0.1, "1e-3");
  text.replace(text.find(step), step.size(), "step=\"1e-3\"><AugmentedMoreau/></simulation>");
  write("augmented.xml", text);
  struct {
    std::string call, scheme;
  } const expected[] = {
      {"step.xml", " EnergyMomentum   Automatic   step 0.001 s "},
      {"tolerance.xml", " LocatedDormandPrince   Automatic   tolerance 1e-06 "},
      {"tolerance.xml --step 1e-3", " EnergyMomentum   Automatic   step 0.001 s "},
      {"step.xml --tolerance 1e-5", " LocatedDormandPrince   Automatic   tolerance 1e-05 "},
      {"named.xml --step 1ms", "tolerance 1e-06   steps up to 0.001 s "},
      {"step.xml --integrator LocatedDormandPrince", "tolerance 1e-06   steps up to 0.001 s "},
      {"augmented.xml", " AugmentedMoreau   Automatic   steps up to 0.001 s "},
      {"augmented.xml --tolerance 1e-5", " LocatedDormandPrince   Automatic   tolerance 1e-05 "},
  };
  for (const auto& [arguments, scheme] : expected) {
    ASSERT_EQ(call("run " + arguments + " --out o"), 0) << arguments << '\n' << err();
    EXPECT_NE(out().find(scheme), std::string::npos) << arguments << '\n' << out();
  }
}

TEST_F(ProgramTest, JsonIsTheContentOfRunJsonAndNothingElse) {
  write("ball.xml", ballXml(0.1, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out o --json"), 0) << err();
  EXPECT_EQ(out(), readWholeFile(path("o/run.json")));
  EXPECT_EQ(err(), "");
}

TEST_F(ProgramTest, AGapThatIsNoNumberEndsTheRunInsteadOfPassingForOpen) {
  write("m.xml",
        "<dynamy version=\"1\">\n<systems><Coordinates name=\"p\" q=\"x\" units=\"m\" u0=\"1\" "
        "M=\"1\"/></systems>\n<elements><CoordinateContact name=\"stop\" on=\"p\" "
        "gap=\"sqrt(0.255 - x)\"><Unilateral/></CoordinateContact></elements>\n"
        "<simulation until=\"1\" step=\"0.01\"/></dynamy>\n");
  EXPECT_EQ(call("run m.xml --out o"), 1);
  EXPECT_NE((out() + err()).find("the gap of stop (m.xml:3:11) is not a number"), std::string::npos)
      << out() << err();
}

TEST_F(ProgramTest, QuietPrintsNothingButFailedChecks) {
  write("ball.xml", ballXml(0.1, "1e-3"));
  EXPECT_EQ(call("run ball.xml --quiet"), 0);
  EXPECT_EQ(out() + err(), "");
  write("ball.xml", ballXml(0.1, "1e-3", R"(<check signal="ball.x" value="5" tolerance="1"/>)"));
  EXPECT_EQ(call("run ball.xml --quiet"), 1);
  EXPECT_EQ(out(), "");
  EXPECT_EQ(err(),
            " check  ball.x at the end  0.1            expected 5 ± 1   FAIL ball.xml:9:3\n");
}

TEST_F(ProgramTest, SetTakesNumbersWithUnitsAndExpressionsInBraces) {
  write("m.xml",
        "<dynamy version=\"1\">\n<parameter name=\"h\" value=\"1\" min=\"0\"/>\n"
        "<systems><PointMass name=\"p\" mass=\"1\" position=\"0 0 {h}\"/></systems>\n"
        "<simulation until=\"1\" step=\"0.1\"/><record signals=\"p.z p.z p.*\"/></dynamy>\n");
  const auto z = [&] { return readSignals(path("o/signals.csv")).columns.at(0).at(0); };
  ASSERT_EQ(call("run m.xml --out o --quiet --set h=1200mm"), 0) << err();
  EXPECT_EQ(z(), 1.2);
  ASSERT_EQ(call("run m.xml --out o --quiet --set 'h={3/2}'"), 0) << err();
  EXPECT_EQ(z(), 1.5);
  // A signal that is named twice is recorded once.
  EXPECT_EQ(readWholeFile(path("o/signals.csv")).substr(0, 10), "t,p.z,p.x,");
  EXPECT_EQ(call("check m.xml --set h=3/2"), 2);
  EXPECT_EQ(
      err(),
      "error: --set h=3/2: cannot be read: expected the end after the number, found \"/\" — an "
      "expression stands in braces: '{3/2}'\n1 error\n");
  EXPECT_EQ(call("check m.xml --set h=-1"), 2);
  EXPECT_EQ(err(), "error: --set h=-1: must be >= 0, is -1\n1 error\n");
}

TEST_F(ProgramTest, AForeignFolderIsNotTouched) {
  write("ball.xml", ballXml(0.1, "1e-3"));
  fs::create_directories(folder_ / "mine");
  write("mine/notes.txt", "mine");
  EXPECT_EQ(call("run ball.xml --out mine"), 2);
  EXPECT_NE(err().find("nothing in it was touched"), std::string::npos) << err();
  EXPECT_EQ(readWholeFile(path("mine/notes.txt")), "mine");
  EXPECT_FALSE(fs::exists(path("mine/run.json")));
}

TEST_F(ProgramTest, CheckNamesTheSystemsThatGravityDoesNotActOn) {
  write("m.xml",
        "<dynamy version=\"1\"><systems><PointMass name=\"p\" mass=\"1\"/>\n"
        "<Coordinates name=\"cart\" q=\"x\" M=\"1\"/></systems>\n"
        "<forces><Gravity/><Integrator name=\"way\" rate=\"p.x\"/></forces>\n"
        "<simulation until=\"1\" step=\"0.1\"/></dynamy>\n");
  ASSERT_EQ(call("check m.xml"), 0) << err();
  // Of the state of a block nobody expects a weight.
  EXPECT_NE(out().find("note: <Gravity> does not act on cart; their own formulas say their weight"),
            std::string::npos)
      << out();
}

TEST_F(ProgramTest, CheckTellsTheSizeOfTheScene) {
  write("ball.xml", ballXml(0.1, "1e-3"));
  ASSERT_EQ(call("check ball.xml"), 0) << err();
  EXPECT_NE(out().find("q 2   u 2   mass blocks 1, of them constant 1"), std::string::npos)
      << out();
  EXPECT_FALSE(fs::exists(folder_ / "runs"));
}

TEST_F(ProgramTest, ListDescribeAndSchemaKnowTheStandardElements) {
  ASSERT_EQ(call("list"), 0) << err();
  EXPECT_NE(out().find("RigidBody"), std::string::npos);
  ASSERT_EQ(call("describe UnilateralCoulomb"), 0) << err();
  EXPECT_NE(out().find("epsilonN"), std::string::npos);
  ASSERT_EQ(call("schema"), 0) << err();
  EXPECT_NE(out().find("<xs:schema"), std::string::npos);
  EXPECT_EQ(call("--version"), 0);
}

TEST_F(ProgramTest, CompareNamesItsReferenceAndWritesATable) {
  write("ball.xml", ballXml(0.4, "1e-2"));
  ASSERT_EQ(call("compare ball.xml --steps 1e-2,5e-3 --csv c.csv"), 0) << err();
  EXPECT_NE(out().find("reference: EnergyMomentum, step 0.000625 s (own, tightest)"),
            std::string::npos)
      << out();
  const std::string csv = readWholeFile(path("c.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

TEST_F(ProgramTest, AResumedRunWritesTheBytesOfTheStraightRun) {
  write("ball.xml", ballXml(5.0, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out a --until 2.71828"), 0) << err();
  ASSERT_EQ(call("resume a --until 5"), 0) << err();
  ASSERT_EQ(call("run ball.xml --out b"), 0) << err();
  EXPECT_EQ(readWholeFile(path("a/signals.csv")), readWholeFile(path("b/signals.csv")));
}

TEST_F(ProgramTest, AModelThatChangedIsNotResumed) {
  write("ball.xml", ballXml(0.1, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out a"), 0) << err();
  write("ball.xml", ballXml(0.1, "2e-3"));
  EXPECT_EQ(call("resume a --until 1"), 2);
  EXPECT_NE(err().find("has changed since the run"), std::string::npos) << err();
}

TEST_F(ProgramRunTest, AKilledRunKeepsWhatItRecordedAndIsResumedFromItsCheckpoint) {
  write("ball.xml", ballXml(4000.0, "1e-6"));  // an hour, if nobody ends it
  const pid_t child =
      start({"run", path("ball.xml"), "--out", path("k"), "--checkpoint", "200ms", "--quiet"});
  waitFor("k/checkpoint", 0);
  waitFor("k/signals.csv", fs::file_size(path("k/signals.csv")));
  ::kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const SignalTable table = readSignals(path("k/signals.csv"));
  EXPECT_GT(table.t.size(), 1u);
  EXPECT_TRUE(readFrames(path("k/frames.bin")).complete);
  // Ends a little after the last row: rows behind the checkpoint are computed again.
  const double until = table.t.back() + 0.02;
  ASSERT_EQ(call("resume k --until " + std::to_string(until)), 0) << err();
  const SignalTable again = readSignals(path("k/signals.csv"));
  ASSERT_GE(again.t.size(), table.t.size());
  for (std::size_t i = 0; i < table.t.size(); ++i) {
    EXPECT_EQ(again.t[i], table.t[i]);
    for (std::size_t k = 0; k < table.columns.size(); ++k)
      EXPECT_EQ(again.columns[k][i], table.columns[k][i]);
  }
}

TEST_F(ProgramRunTest, ControlCEndsARunCleanly) {
  write("ball.xml", ballXml(4000.0, "1e-6"));
  const pid_t child = start({"run", path("ball.xml"), "--out", path("c"), "--quiet"});
  waitFor("c/signals.csv", 200);
  ::kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_NE(readWholeFile(path("c/run.json")).find("\"stopped by the user\""), std::string::npos);
  EXPECT_TRUE(fs::exists(path("c/replay.html")));
  EXPECT_TRUE(fs::exists(path("c/checkpoint")));
}

}  // namespace
}  // namespace dynamy
