/// dynamy sweep: what varies, the lines of the results, going on after kill -9, other engines.
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <build_paths.hpp>

#include <cmath>
#include <dynamy/io/files/csv.hpp>
#include <map>
#include <program/program_fixture.hpp>
#include <set>
#include <thread>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

/// Free fall from h with the velocity v: z(T) = h + v T − ½ g T², which Moreau's rule steps
/// exactly.
constexpr double kG = 9.81, kT = 0.5;
const char* const kFall = R"(<dynamy version="1">
  <parameter name="h" value="1" min="0" max="10"/>
  <parameter name="v" value="0"/>
  <systems><Coordinates name="ball" q="z" units="m" q0="{h}" u0="{v}" M="1" potential="9.81*z"/></systems>
  <simulation until="0.5" step="1e-3"><MoreauMidpoint/></simulation>
  <record signals="ball.z" every="10ms"/>
</dynamy>
)";

/// The same with `steps` steps, for runs that take their time.
std::string slowFall(int steps) {
  std::string text = kFall;
  const std::string fast = "step=\"1e-3\"";
  return text.replace(text.find(fast), fast.size(), "step=\"" + std::to_string(kT / steps) + "\"");
}

class Sweep : public ProgramTest {
 protected:
  using Table = std::vector<std::vector<std::string>>;
  Table table(const std::string& folder) const {
    return readCsv(readWholeFile(path(folder + "/results.csv")));
  }
  static std::size_t column(const Table& t, const std::string& name) {
    const auto found = std::find(t.at(0).begin(), t.at(0).end(), name);
    EXPECT_NE(found, t.at(0).end()) << name;
    return static_cast<std::size_t>(found - t.at(0).begin());
  }
  std::set<std::string> done(const std::string& folder) const {
    std::set<std::string> out;
    if (!fs::exists(path(folder + "/results"))) return out;
    for (const auto& entry : fs::directory_iterator(path(folder + "/results")))
      if (entry.path().extension() == ".csv") out.insert(entry.path().filename().string());
    return out;
  }
  /// A command of a shell, with GNU parallel in its PATH, or what stands for it; the exit status.
  int run(const std::string& command) const {
    fs::create_directories(folder_ / "bin");
    if (std::system("parallel --version > /dev/null 2>&1") != 0) {
      // What GNU parallel does with these arguments, one after the other.
      write("bin/parallel",
            "#!/bin/sh\nwhile [ \"$1\" = --env ]; do shift 2; done\n[ $# -eq 1 ] || exit 9\n"
            "while read -r id; do\n"
            "  sh -c \"$(printf %s \"$1\" | sed \"s/{}/$id/g\")\" < /dev/null || exit 8\ndone\n");
      fs::permissions(path("bin/parallel"), fs::perms::owner_all);
    }
    const std::string all = "PATH=" + quoted(path("bin")) + ":\"$PATH\" " + command + " > " +
                            quoted(path("out")) + " 2>&1";
    return WEXITSTATUS(std::system(all.c_str()));
  }
  /// One word for a shell.
  static std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\"'\"'") : std::string(1, c);
    return out + "'";
  }
  /// Starts the program in a process group of its own and leaves it running.
  pid_t start(const std::string& arguments) const {
    const pid_t child = fork();
    if (child != 0) return child;
    const std::string command = "cd '" + folder_.string() + "' && exec '" +
                                std::string(DYNAMY_BINARY_DIR) + "/bin/dynamy' " + arguments +
                                " > out 2> err";
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
};

TEST_F(Sweep, CombinesTheValuesAndMeasuresEveryRun) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set h=1:2:3 --set v=0,1.5 -j2 --out s"), 0) << err();
  EXPECT_EQ(readWholeFile(path("s/manifest.csv")),
            "id,h,v\n1,1,0\n2,1,1.5\n3,1.5,0\n4,1.5,1.5\n5,2,0\n6,2,1.5\n");
  const Table t = table("s");
  ASSERT_EQ(t.size(), 7u);
  const std::size_t z = column(t, "ball.z");
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double h = std::stod(t[i][1]), v = std::stod(t[i][2]);
    // 500 steps round off 1e-16 each.
    EXPECT_NEAR(std::stod(t[i][z]), h + v * kT - 0.5 * kG * kT * kT, 1e-12);
    EXPECT_EQ(t[i][column(t, "state")], "finished");
  }
}

TEST_F(Sweep, MeasuresWhatIsAskedFor) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set v=1,2,4 --set h=1m --measure 'max ball.z' "
                 "--measure ball.z@0.2s --measure 'mean ball.z@0..0.2' --out s"),
            0)
      << err();
  const Table t = table("s");
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double v = std::stod(t[i][1]);
    // The highest end of a step lies at most g dt²/8 below the vertex.
    EXPECT_NEAR(std::stod(t[i][column(t, "max ball.z")]), 1 + v * v / (2 * kG), kG * 1e-6 / 8);
    // Linear between the ends of steps, and 0.2 s is one.
    EXPECT_NEAR(std::stod(t[i][column(t, "ball.z@0.2s")]), 1 + v * 0.2 - kG * 0.02, 1e-12);
    // Trapezoids err by g dt²/12.
    EXPECT_NEAR(std::stod(t[i][column(t, "mean ball.z@0..0.2")]), 1 + v * 0.1 - kG * 0.04 / 6,
                kG * 1e-6 / 12 * 1.01);
  }
}

TEST_F(Sweep, VariesStepsAndSchemesLikeParameters) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --step 1e-3:1e-1:3:log --integrator MoreauMidpoint,"
                 "HalfExplicitEuler --out s"),
            3)  // HalfExplicitEuler gains energy at long steps: two runs are qualified
      << err();
  const Table t = table("s");
  ASSERT_EQ(t.size(), 7u);
  EXPECT_EQ(t[0][1], "--step");
  EXPECT_EQ(t[3][1], "0.01");
  EXPECT_EQ(t[3][column(t, "steps")], "50");
}

TEST_F(Sweep, DrawsTheSameValuesAgain) {
  write("fall.xml", kFall);
  const std::string draws = "sweep fall.xml --set 'h=uniform(1,2)' --set 'v=normal(3,0.5)' ";
  ASSERT_EQ(call(draws + "--samples 100 --step 0.1 --out a"), 0) << err();
  ASSERT_EQ(call(draws + "--samples 100 --step 0.1 --out b -j1"), 0) << err();
  EXPECT_EQ(readWholeFile(path("a/results.csv")), readWholeFile(path("b/results.csv")));
  double h = 0.0, v = 0.0, vv = 0.0;
  const Table t = table("a");
  for (std::size_t i = 1; i < t.size(); ++i) {
    EXPECT_TRUE(std::stod(t[i][1]) > 1.0 && std::stod(t[i][1]) < 2.0);
    h += std::stod(t[i][1]) / 100, v += std::stod(t[i][2]) / 100;
    vv += std::pow(std::stod(t[i][2]) - 3.0, 2) / 100;
  }
  // Five standard deviations of the means: 1/√12/10, 0.5/10; of the variance: 0.25 √(2/100).
  EXPECT_NEAR(h, 1.5, 5 / std::sqrt(12.0) / 10);
  EXPECT_NEAR(v, 3.0, 5 * 0.5 / 10);
  EXPECT_NEAR(vv, 0.25, 5 * 0.25 * std::sqrt(2.0 / 100));
  ASSERT_EQ(call(draws + "--samples 3 --step 0.1 --seed 2 --out c"), 0) << err();
  EXPECT_NE(table("c")[1][1], t[1][1]);
}

TEST_F(Sweep, TakesATableOfItsUser) {
  write("fall.xml", kFall);
  write("mine.csv", "id,v,h\n7,1,2\n9,0,3\n");
  ASSERT_EQ(call("sweep fall.xml --table mine.csv --out s"), 0) << err();
  EXPECT_EQ(readWholeFile(path("s/manifest.csv")), "id,v,h\n1,1,2\n2,0,3\n");
}

TEST_F(Sweep, HasTheSameBytesForAnyNumberOfProcesses) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set v=0:1:12 -j1 --out a"), 0) << err();
  ASSERT_EQ(call("sweep fall.xml --set v=0:1:12 -j5 --out b"), 0) << err();
  EXPECT_EQ(readWholeFile(path("a/results.csv")), readWholeFile(path("b/results.csv")));
  EXPECT_EQ(readWholeFile(path("a/sweep.html")), readWholeFile(path("b/sweep.html")));
}

TEST_F(Sweep, KilledHalfWayItLosesAndDoublesNoRun) {
  write("fall.xml", slowFall(20'000));
  const std::string sweep = "sweep fall.xml --set v=0:1:40 -j2 --out ";
  ASSERT_EQ(call(sweep + "whole"), 0) << err();
  const pid_t child = start(sweep + "s");
  for (int i = 0; i < 4000 && done("s").size() < 10; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  // Its runs die with it: nothing is added from now on, and nobody holds a lock.
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const std::set<std::string> before = done("s");
  ASSERT_GE(before.size(), 10u);
  ASSERT_LT(before.size(), 40u);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(done("s"), before);
  std::map<std::string, fs::file_time_type> written;
  for (const std::string& name : before)
    written[name] = fs::last_write_time(path("s/results/" + name));
  ASSERT_EQ(call(sweep + "s"), 0) << err();
  for (const auto& [name, time] : written)
    EXPECT_EQ(fs::last_write_time(path("s/results/" + name)), time) << name << " was done again";
  EXPECT_EQ(readWholeFile(path("s/results.csv")), readWholeFile(path("whole/results.csv")));
}

TEST_F(Sweep, KilledBeforeItsFirstRunItBeginsAnew) {
  write("fall.xml", kFall);
  const std::string sweep = "sweep fall.xml --set h=1,2 --quiet --out s";
  fs::create_directories(path("s"));
  write("s/sweep.json.part", "{\"form");
  ASSERT_EQ(call(sweep), 0) << err();
  const std::string facts = readWholeFile(path("s/sweep.json"));
  fs::remove_all(path("s"));
  fs::create_directories(path("s"));
  write("s/sweep.json", facts);
  EXPECT_EQ(call(sweep), 0) << err();
  EXPECT_EQ(done("s").size(), 2u);
}

TEST_F(Sweep, LeavesARunToTheProcessThatComputesIt) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set v=0:1:4 --out s --emit slurm"), 0) << err();
  const int claim = open(path("s/results/3.part").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  ASSERT_EQ(flock(claim, LOCK_EX), 0);
  EXPECT_EQ(call("sweep s"), 1);
  EXPECT_NE(out().find("1 missing"), std::string::npos) << out();
  EXPECT_EQ(done("s"), (std::set<std::string>{"1.csv", "2.csv", "4.csv"}));
  close(claim);
  EXPECT_EQ(call("sweep s"), 0) << err();
  EXPECT_EQ(table("s").size(), 5u);
}

TEST_F(Sweep, OtherEnginesComputeTheSame) {
  write("fall.xml", kFall);
  const std::string sweep = "sweep fall.xml --set v=0:1:5 --out ";
  ASSERT_EQ(call(sweep + "a"), 0) << err();
  ASSERT_EQ(call(sweep + "b --emit slurm"), 0) << err();
  const std::string script = readWholeFile(path("b/slurm.sh"));
  EXPECT_NE(script.find("#SBATCH --array=1-5\n"), std::string::npos) << script;
  for (int task = 5; task >= 1; --task)
    ASSERT_EQ(
        std::system(
            ("SLURM_ARRAY_TASK_ID=" + std::to_string(task) + " sh " + path("b/slurm.sh")).c_str()),
        0);
  ASSERT_EQ(call("sweep b --collect"), 0) << err();
  EXPECT_EQ(readWholeFile(path("a/results.csv")), readWholeFile(path("b/results.csv")));

  ASSERT_EQ(call(sweep + "c --emit parallel"), 0) << err();
  ASSERT_EQ(run("sh " + path("c/parallel.sh")), 0) << out();
  EXPECT_EQ(readWholeFile(path("a/results.csv")), readWholeFile(path("c/results.csv")));
}

TEST_F(Sweep, ScriptsMeanAnyNameLiterally) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set v=0:1:2 --out plain --quiet"), 0) << err();
  const std::string expected = readWholeFile(path("plain/results.csv"));
  const std::vector<std::string> names = {
      "with blanks",  "it's \"quoted\"",           "$HOME `touch ran` $(touch ran)",
      "line\nend",    "x.txt\ntouch ran\n#",       "{} {.} {{runs}} {{options}}",
      "a;touch ran&", "back\\slash %A_%a *?[a-z]", "-j 3 # < >"};
  for (const std::string& name : names) {
    for (const char* engine : {"slurm", "parallel"}) {
      const fs::path folder = folder_ / engine / name;
      fs::create_directories(folder.parent_path());
      write("folder", folder.string() + "x");  // $(…) drops line ends at the end
      ASSERT_EQ(call("sweep fall.xml --set v=0:1:2 --emit " + std::string(engine) +
                     " --out \"$(f=$(cat folder); printf %s \"${f%x}\")\""),
                0)
          << err();
      // The command that is shown, by bash; a job of an array has no folder of its own.
      const std::string shown = out();
      if (std::string(engine) == "parallel") {
        const std::size_t at = shown.find(" run it: ");
        ASSERT_NE(at, std::string::npos) << shown;
        write("command", "cd /\n" + shown.substr(at + 9));
      } else {
        write("command",
              "cd /\nfor SLURM_ARRAY_TASK_ID in 1 2; do export SLURM_ARRAY_TASK_ID\n"
              "SLURM_ARRAY_JOB_ID=77 " +
                  std::string("bash ") + quoted((folder / "slurm.sh").string()) +
                  " || exit 1\ndone\n\"" DYNAMY_BINARY_DIR "/bin/dynamy\" sweep " +
                  quoted(folder.string()) + " --collect\n");
      }
      EXPECT_EQ(run("bash " + path("command")), 0) << name << '\n' << out();
      EXPECT_EQ(readWholeFile(folder / "results.csv"), expected) << name;
      if (std::string(engine) == "slurm") {
        EXPECT_TRUE(fs::exists(folder / "slurm-77_2.txt")) << name;
        for (const std::string line = "\n" + readWholeFile(folder / "slurm.sh");
             const char* word : {"with", "quoted", "touch"})  // none in what Slurm itself reads
          EXPECT_EQ(line.substr(0, line.find("program=")).find(word), std::string::npos) << line;
      }
    }
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder_))
    EXPECT_NE(entry.path().filename(), "ran") << entry.path();
  EXPECT_FALSE(fs::exists("/ran"));
}

TEST_F(Sweep, ARunWithoutAModelHasALineToo) {
  write("fall.xml", kFall);
  EXPECT_EQ(call("sweep fall.xml --set h=-1,0,1 --out s"), 1);
  EXPECT_NE(out().find("1 FAILED"), std::string::npos) << out();
  const Table t = table("s");
  ASSERT_EQ(t.size(), 4u);
  EXPECT_EQ(t[1][column(t, "state")], "error");
  EXPECT_NE(t[1].back().find("--set h=-1: must be between 0 and 10"), std::string::npos)
      << t[1].back();
  EXPECT_EQ(t[2][column(t, "state")], "finished");
}

TEST_F(Sweep, KeepsRunFoldersIfAsked) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set h=1,2 --keep --out s --quiet"), 0) << err();
  EXPECT_EQ(out() + err(), "");
  EXPECT_TRUE(fs::exists(path("s/runs/2/replay.html")));
  EXPECT_NE(readWholeFile(path("s/sweep.html")).find("runs/2/replay.html"), std::string::npos);
}

TEST_F(Sweep, DoesNotMixTwoSweeps) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set h=1,2 --out s"), 0) << err();
  EXPECT_EQ(call("sweep fall.xml --set h=1,3 --out s"), 2);
  EXPECT_NE(err().find("holds another sweep: other values are asked for"), std::string::npos)
      << err();
  EXPECT_EQ(call("sweep fall.xml --set h=1,2 --measure 'max ball.z' --out s"), 2);
  EXPECT_NE(err().find("\"measures\" was [ball.z ], is [max ball.z ]"), std::string::npos) << err();
  write("fall.xml", slowFall(100));
  EXPECT_EQ(call("sweep fall.xml --set h=1,2 --out s"), 2);
  EXPECT_NE(err().find("the model has changed since it began"), std::string::npos) << err();
  EXPECT_EQ(call("sweep s"), 2);
  EXPECT_NE(err().find("has changed since the sweep began"), std::string::npos) << err();
  fs::create_directories(path("s/runs/mine"));
  write("s/runs/mine/note.txt", "keep");
  EXPECT_EQ(call("sweep fall.xml --set h=1,2 --out s --restart"), 0) << err();
  EXPECT_EQ(readWholeFile(path("s/runs/mine/note.txt")), "keep");  // of nobody's run
}

TEST_F(Sweep, TheValuesOfARangeAreTold) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set h=1:2:5 --set v=0:0.9:10 --out s"), 0) << err();
  EXPECT_NE(out().find("\n h = 1, 1.25, 1.5, 1.75, 2\n"), std::string::npos) << out();
  EXPECT_NE(out().find("\n v = 0, 0.1, 0.2, … 0.9   10 values\n"), std::string::npos) << out();
  EXPECT_EQ(err(), "");
}

TEST_F(Sweep, ARangeThatMayBeMeantAsFromStepToIsTold) {
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set v=0:0.1:5 --out s"), 0) << err();
  EXPECT_NE(
      err().find("--set v=0:0.1:5 is FROM:TO:COUNT, 5 values from 0 to 0.1; steps of 0.1 up to "
                 "5 are v=0:5:51"),
      std::string::npos)
      << err();
}

TEST_F(Sweep, MistakesAreNamed) {
  write("fall.xml", kFall);
  fs::create_directories(path("mine"));
  write("mine/note.txt", "keep");
  struct {
    const char *arguments, *said;
    int code;
  } const kMistakes[] = {
      {"--set hh=1,2", "no parameter \"hh\" — did you mean \"h\"?", 2},
      {"--set h=1", "nothing varies", 64},
      {"--set h=1,2 --set h=3", "\"h\" has a value already by --set h=1,2", 64},
      {"--set h=1:2", "a range is FROM:TO:COUNT, or FROM:TO:COUNT:log", 64},
      {"--set h=1:2:2.5", "how many values there are: a whole number from 2 on", 64},
      {"--set h=0:2:3:log", "needs positive bounds", 64},
      {"--set h=a:2:3", "\"h=a\": ", 64},
      {"--set h=1,,2", "a value is missing", 64},
      {"--set 'h=uniform(1,2)'", "how many values are to be drawn?", 64},
      {"--set 'h=uniform(2,1)' --samples 3", "the lower bound comes first", 64},
      {"--set h=1,2 --samples 3", "no value is drawn", 64},
      {"--set h=1:2:1000001", "whole number", 64},
      {"--set h=1:2:1001 --set v=1:2:1000", "more than 1000000 runs", 64},
      {"--set h=1,2 --measure 'mx ball.z'", "no measure \"mx\" — did you mean \"max\"?", 64},
      {"--set h=1,2 --measure ball.zz", "no signal \"ball.zz\" — did you mean \"ball.z\"?", 2},
      {"--set h=1,2 --measure 'max ball.z@3'", "an interval FROM..TO", 64},
      {"--set h=1,2 --step 1kg", "--step", 64},
      {"--set h=1,2 --integrator MoreauMidpiont", "did you mean \"MoreauMidpoint\"?", 2},
      {"--set h=1,2 --emit slrum", "slrum", 64},
      {"--set h=1,2 --out mine", "is not empty and holds no sweep", 2},
      {"--table none.csv", "none.csv", 2},
  };
  for (const auto& m : kMistakes) {
    EXPECT_EQ(call(std::string("sweep fall.xml ") + m.arguments), m.code) << m.arguments;
    EXPECT_NE(err().find(m.said), std::string::npos) << m.arguments << "\n" << err();
  }
  EXPECT_EQ(readWholeFile(path("mine/note.txt")), "keep");
  EXPECT_EQ(call("sweep mine"), 2);
  EXPECT_NE(err().find("holds no sweep"), std::string::npos) << err();
}

TEST_F(Sweep, ItsPageShowsTableAndMapInABrowser) {
  if (std::system("chromium --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no chromium";
  write("fall.xml", kFall);
  ASSERT_EQ(call("sweep fall.xml --set h=1:2:3 --set v=0:1:4 --measure ball.z --out s"), 0)
      << err();
  ASSERT_EQ(std::system(("chromium --headless=new --no-sandbox --user-data-dir=" + path("profile") +
                         " --virtual-time-budget=2000 --dump-dom file://" + path("s/sweep.html") +
                         " > " + path("dom") + " 2> " + path("err"))
                            .c_str()),
            0)
      << err();
  const std::string dom = readWholeFile(path("dom"));
  const auto count = [&dom](const std::string& what) {
    int n = 0;
    for (std::size_t at = dom.find(what); at != std::string::npos; at = dom.find(what, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("<tr id=\"run"), 12);
  EXPECT_EQ(count("<rect "), 12 + 64);  // cells of the map, steps of the colour bar
}

}  // namespace
}  // namespace dynamy
