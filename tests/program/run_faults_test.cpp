/// Runs that are ended from outside: by signals, a full disk, a lack of memory; two runs into one
/// folder; damaged checkpoints.
#include <build_paths.hpp>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/run_files/checkpoint.hpp>
#include <dynamy/io/run_files/frames_file.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <program/started_program.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

class RunFaults : public StartedProgramTest {
 protected:
  JsonValue facts(const std::string& run) const {
    return readJson(readWholeFile(path(run + "/run.json")), "run.json");
  }
  /// The recorded files of two runs; chunks of frames.bin end where the clock says.
  /// The rows of a ledger stand at instants that depend on the end time: with `ledger` it was the
  /// same from the start.
  void expectSame(const std::string& a, const std::string& b, bool ledger = true) const {
    for (const char* file : {"signals.csv", "events.csv", "ledger.csv"}) {
      if (!ledger && std::string(file) == "ledger.csv") continue;
      EXPECT_EQ(readWholeFile(path(a + '/' + file)), readWholeFile(path(b + '/' + file))) << file;
    }
    const Frames fa = readFrames(path(a + "/frames.bin")), fb = readFrames(path(b + "/frames.bin"));
    EXPECT_TRUE(fa.complete && fb.complete);
    EXPECT_EQ(fa.t, fb.t);
    EXPECT_EQ(fa.pose, fb.pose);
    EXPECT_EQ(fa.contact, fb.contact);
    EXPECT_EQ(facts(a)["hash"].text, facts(b)["hash"].text);
  }
  /// Goes on to `until`, and is then what a straight run is.
  void expectResumes(const std::string& run, const std::string& model, const std::string& until) {
    ASSERT_EQ(call("resume " + run + " --until " + until), 0) << err();
    ASSERT_EQ(call("run " + model + " --out straight --until " + until), 0) << err();
    expectSame(run, "straight", false);
    EXPECT_EQ(call("verify " + run), 0) << out();
  }
};

class EndedBySignal : public RunFaults, public ::testing::WithParamInterface<int> {};

TEST_P(EndedBySignal, ARunKeepsAllAndSaysByWhich) {
  write("ball.xml", bouncingBallXml(4000.0, "1e-6"));
  const pid_t child = start({"run", "ball.xml", "--out", "s", "--quiet"});
  waitFor("s/signals.csv", 200);
  ::kill(child, GetParam());
  EXPECT_EQ(ended(child), 128 + GetParam());
  const JsonValue run = facts("s");
  EXPECT_EQ(run["state"].text, std::string("stopped by SIG") + ::sigabbrev_np(GetParam()));
  EXPECT_TRUE(fs::exists(path("s/replay.html")));
  EXPECT_FALSE(fs::exists(path("s/run.lock")));
  EXPECT_EQ(call("verify s"), 0) << out();
  const double t = run["t"].value;
  expectResumes("s", "ball.xml", std::to_string(t + 0.05));
}
INSTANTIATE_TEST_SUITE_P(Signals, EndedBySignal, ::testing::Values(SIGTERM, SIGHUP, SIGXCPU));

TEST_F(RunFaults, SignalsInHdf5GoOnAsThoseInTextDo) {
  const auto model = [](const char* format) {
    return std::string(R"(<dynamy version="1">
      <systems><PointMass name="m" position="0 0 1" mass="1"/></systems><forces><Gravity/></forces>
      <simulation until="0.2" step="1e-3"/><record signals="m.z m.vz" every="1ms" format=")") +
           format + "\"/></dynamy>";
  };
  write("packed.xml", model("hdf5")), write("text.xml", model("csv"));
  ASSERT_EQ(call("run packed.xml --out p"), 0) << err();
  EXPECT_FALSE(fs::exists(path("p/signals.csv")));
  EXPECT_NE(out().find("signals.h5"), std::string::npos) << out();
  EXPECT_EQ(call("verify p"), 0) << out();
  ASSERT_EQ(call("resume p --until 0.3"), 0) << err();
  EXPECT_EQ(call("verify p"), 0) << out();
  ASSERT_EQ(call("run text.xml --out t"), 0) << err();
  ASSERT_EQ(call("resume t --until 0.3"), 0) << err();
  const SignalTable packed = signalsOf(path("p")), text = signalsOf(path("t"));
  EXPECT_EQ(packed.t, text.t);
  EXPECT_EQ(packed.columns, text.columns);
  EXPECT_EQ(packed.t.size(), 301U);
  EXPECT_EQ(packed.signals.at(1).unit, "m/s");
  // The option replaces what the model says, and a continued run keeps the format.
  ASSERT_EQ(call("run packed.xml --out c --signals csv"), 0) << err();
  EXPECT_TRUE(fs::exists(path("c/signals.csv")));
  ASSERT_EQ(call("run text.xml --out h --signals hdf5"), 0) << err();
  ASSERT_EQ(call("resume h --until 0.3"), 0) << err();
  EXPECT_FALSE(fs::exists(path("h/signals.csv")));
  EXPECT_EQ(signalsOf(path("h")).columns, text.columns);
  ASSERT_EQ(call("resume h --until 0.4 --signals csv"), 0) << err();
  EXPECT_FALSE(fs::exists(path("h/signals.h5")));
  EXPECT_EQ(call("verify h"), 0) << out();
  // What cannot be packed stays as text, and the run says so.
  ASSERT_EQ(call("run packed.xml --out p"), 0) << err();
  fs::create_directories(path("p/signals.h5.part/x"));
  EXPECT_EQ(call("run packed.xml --out p"), 74) << out();
  EXPECT_NE(err().find("signals.h5.part: cannot be created"), std::string::npos) << err();
  EXPECT_EQ(signalsOf(path("p")).t.size(), 201U);
}

TEST_F(RunFaults, ARunIsResumedWhileBodiesSleep) {
  // One ball rests, the other one falls on it after 0.20 s.
  const std::string ball = "><Sphere radius=\"0.05\" mass=\"0.2\" material=\"m\"/></RigidBody>";
  write(
      "s.xml",
      "<dynamy version=\"1\"><systems><RigidBody name=\"a\" position=\"0 0 0.05\"" + ball +
          "<RigidBody name=\"b\" position=\"0.01 0 0.35\"" + ball +
          "<Ground name=\"floor\"><HalfSpace material=\"m\"/></Ground></systems><forces><Gravity/>"
          "</forces><elements><Contact between=\"m m\"><UnilateralCoulomb mu=\"0.5\"/></Contact>"
          "</elements><record every=\"2ms\"/><simulation until=\"0.4\" step=\"1ms\" "
          "sleep=\"1e-6\"/></dynamy>");
  ASSERT_EQ(call("check s.xml"), 0) << err();
  EXPECT_NE(out().find(" 2 of 2 systems may sleep, slower than 1e-06 m/s"), std::string::npos)
      << out();
  ASSERT_EQ(call("run s.xml --out s --until 0.1"), 0) << err();
  EXPECT_NE(out().find(" asleep  1 system at the end, at most 1; 1 fell asleep, 0 woke; "),
            std::string::npos)
      << out();
  EXPECT_EQ(facts("s")["sleep"]["asleep"].value, 1.0);
  EXPECT_NE(readWholeFile(path("s/events.csv")).find("0.016,sleep,a,,,,"), std::string::npos);
  expectResumes("s", "s.xml", "0.4");
  EXPECT_NE(readWholeFile(path("s/events.csv")).find(",wake,a,,,,"), std::string::npos);
}

TEST_F(RunFaults, ASignalThatIsIgnoredFromTheStartStaysSo) {  // nohup
  write("ball.xml", bouncingBallXml(4000.0, "1e-6"));
  struct sigaction ignore {
  }, before{};
  ignore.sa_handler = SIG_IGN;
  ::sigaction(SIGHUP, &ignore, &before);
  const pid_t child = start({"run", "ball.xml", "--out", "s", "--quiet"});
  ::sigaction(SIGHUP, &before, nullptr);
  waitFor("s/signals.csv", 200);
  ::kill(child, SIGHUP);
  waitFor("s/signals.csv", fs::file_size(path("s/signals.csv")) + 200);
  ::kill(child, SIGTERM);
  EXPECT_EQ(ended(child), 143);
}

#ifndef __SANITIZE_THREAD__  // which hands signals on late and one by one
TEST_F(RunFaults, ASecondSignalEndsAtOnce) {
  write("ball.xml", bouncingBallXml(4000.0, "1e-6"));
  const pid_t child = start({"run", "ball.xml", "--out", "s", "--quiet"});
  waitFor("s/signals.csv", 200);
  ::kill(child, SIGSTOP);  // both are there when it goes on
  ::kill(child, SIGHUP), ::kill(child, SIGTERM);
  ::kill(child, SIGCONT);
  EXPECT_EQ(ended(child), -SIGTERM);
  EXPECT_EQ(facts("s")["state"].text, "running");
  EXPECT_EQ(call("verify s"), 0) << out();
}
#endif

TEST_F(RunFaults, ASecondRunIntoAFolderIsRefused) {
  write("ball.xml", bouncingBallXml(4000.0, "1e-6"));
  write("other.xml", bouncingBallXml(0.1, "1e-3"));
  const pid_t child = start({"run", "ball.xml", "--out", "s", "--quiet"});
  waitFor("s/signals.csv", 200);
  for (const char* second : {"run other.xml --out s", "resume s"}) {
    EXPECT_EQ(call(second), 2);
    EXPECT_NE(err().find("another run writes into this folder (process " + std::to_string(child)),
              std::string::npos)
        << err();
  }
  EXPECT_EQ(call("verify s"), 0) << out();
  EXPECT_NE(out().find("running, process " + std::to_string(child)), std::string::npos) << out();
  ::kill(child, SIGTERM);
  EXPECT_EQ(ended(child), 143);
  EXPECT_EQ(call("verify s"), 0) << out();  // untouched by the others
}

TEST_F(RunFaults, AFullDiskEndsARunWithItsCheckpointAndItGoesOnFromThere) {
  write("ball.xml", bouncingBallXml(40.0, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out whole"), 0) << err();
  const auto size = fs::file_size(path("whole/signals.csv"));
  // No file may have more bytes: to the writer the same as a full disk.
  for (const double share : {0.3, 0.6, 0.9}) {
    const auto limit = static_cast<rlim_t>(share * static_cast<double>(size));
    EXPECT_EQ(
        ended(start({"run", "ball.xml", "--out", "s", "--quiet"}, std::pair{RLIMIT_FSIZE, limit})),
        74);
    EXPECT_NE(err().find("signals.csv: cannot write: File too large"), std::string::npos) << err();
    EXPECT_EQ(facts("s")["state"].text, "failed");
    EXPECT_NE(facts("s")["reason"].text.find("cannot write"), std::string::npos);
    EXPECT_EQ(fs::file_size(path("s/signals.csv")), limit);  // all that had room
    ASSERT_EQ(call("resume s"), 0) << err();
    expectSame("s", "whole");
  }
}

#ifndef __SANITIZE_THREAD__  // which hands signals on late and one by one
TEST_F(RunFaults, WhereNothingCanBeWrittenTheStatusSaysSo) {
  write("ball.xml", bouncingBallXml(0.1, "1e-3"));
  EXPECT_EQ(ended(start({"run", "ball.xml", "--out", "s"}, std::pair{RLIMIT_FSIZE, rlim_t{0}})),
            74);
}
#endif

TEST_F(RunFaults, WordsThatFindNoRoomAreAnErrorOfTheCommand) {
  const std::string command = std::string("'") + DYNAMY_BINARY_DIR +
                              "/bin/dynamy' list > /dev/full 2> '" + path("err") + "'";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 74);
  EXPECT_NE(err().find("No space left on device"), std::string::npos) << err();
}

#ifndef DYNAMY_SANITIZED  // sanitizers need more addresses than any limit leaves
TEST_F(RunFaults, ALackOfMemoryIsSaidAndNeverACrash) {
  // Room for a million grains' worth of text is not there: where it ends depends on the limit.
  std::string bodies;
  for (int i = 0; i < 4000; ++i)
    bodies += "<PointMass name=\"p" + std::to_string(i) + "\" mass=\"1\" position=\"0 0 1\"/>\n";
  write("m.xml", "<dynamy version=\"1\"><systems>" + bodies +
                     "</systems><forces><Gravity/></forces><simulation until=\"1\" step=\"0.1\"/>"
                     "<record signals=\"p1.*\"/></dynamy>");
  int told = 0, done = 0;
  for (rlim_t megabytes = 40; megabytes <= 240 && done < 2; megabytes += 8) {
    for (const char* threads : {"1", "8"}) {
      const int status =
          ended(start({"run", "m.xml", "--out", "s", "--quiet", "--threads", threads},
                      std::pair{RLIMIT_AS, megabytes << 20}));
      const std::string words = err();
      EXPECT_EQ(words.find("terminate called"), std::string::npos) << words;
      if (words.find("error while loading shared libraries") != std::string::npos) continue;
      // A plug-in that finds no room for itself is an error of the plug-in.
      EXPECT_TRUE(status == 71 || status == 0 || status == 2)
          << megabytes << ": " << status << words;
      told += status == 71, done += status == 0;
    }
  }
  EXPECT_GT(told, 0);
  EXPECT_GT(done, 0);
}
#endif

TEST_F(RunFaults, ADamagedCheckpointFallsBackToTheOneBefore) {
  write("ball.xml", bouncingBallXml(4000.0, "1e-6"));
  const pid_t child = start({"run", "ball.xml", "--out", "k", "--checkpoint", "100ms", "--quiet"});
  waitFor("k/checkpoint.1", 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // a few are written
  ::kill(child, SIGKILL);
  EXPECT_EQ(ended(child), -SIGKILL);
  EXPECT_EQ(facts("k")["state"].text, "running");
  EXPECT_EQ(call("verify k"), 0) << out();
  EXPECT_NE(out().find("was killed while it ran"), std::string::npos) << out();
  std::string bytes = readWholeFile(path("k/checkpoint"));
  bytes[bytes.size() / 3] = static_cast<char>(bytes[bytes.size() / 3] ^ 4);
  write("k/checkpoint", bytes);
  EXPECT_EQ(call("verify k"), 2) << out();
  EXPECT_NE(out().find("FAULT"), std::string::npos) << out();
  const Checkpoint older = readCheckpoint(readWholeFile(path("k/checkpoint.1")), "");
  const std::string until = std::to_string(older.t + 0.02);
  ASSERT_EQ(call("resume k --until " + until), 0) << err();
  EXPECT_NE(err().find("checkpoint is damaged: its checksum is wrong; the run goes on from the "
                       "checkpoint before it, of t = "),
            std::string::npos)
      << err();
  ASSERT_EQ(call("run ball.xml --out straight --until " + until), 0) << err();
  expectSame("k", "straight", false);
}

TEST_F(RunFaults, ACheckpointThatIsNoneEndsWith2) {
  write("ball.xml", bouncingBallXml(0.1, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out a --no-checkpoint"), 0) << err();
  EXPECT_FALSE(fs::exists(path("a/checkpoint")));
  EXPECT_EQ(call("resume a"), 2);
  EXPECT_NE(err().find("holds no checkpoint"), std::string::npos) << err();
  write("a/checkpoint", "something else");
  EXPECT_EQ(call("resume a"), 2);
  EXPECT_NE(err().find("is no checkpoint of dynamY"), std::string::npos) << err();
}

TEST_F(RunFaults, AnIncludedFileThatChangedIsNamed) {
  write("floor.xml",
        "<dynamy version=\"1\"><elements><CoordinateContact name=\"floor\" on=\"ball\" gap=\"z\">"
        "<Unilateral epsilonN=\"0.5\"/></CoordinateContact></elements></dynamy>");
  write("m.xml",
        "<dynamy version=\"1\"><systems><Coordinates name=\"ball\" q=\"z\" q0=\"1\" M=\"1\" "
        "potential=\"9.81*z\"/></systems><include file=\"floor.xml\"/>"
        "<simulation until=\"1\" step=\"1e-3\"/></dynamy>");
  ASSERT_EQ(call("run m.xml --out a"), 0) << err();
  std::string text = readWholeFile(path("floor.xml"));
  text.replace(text.find("0.5"), 3, "0.6");
  write("floor.xml", text);
  EXPECT_EQ(call("resume a --until 2"), 2);
  EXPECT_NE(err().find("floor.xml: is not what the run was made with — bring it back"),
            std::string::npos)
      << err();
}

TEST_F(RunFaults, ALibraryIsKnownByItsNameAndItsBytes) {
  write("ball.xml", bouncingBallXml(0.5, "1e-3"));
  fs::create_directory(path("mine"));
  const fs::path plugin = path("mine/libshowcase.so");
  fs::copy_file(fs::path(DYNAMY_BINARY_DIR) / "lib" / "dynamy" / "libshowcase.so", plugin);
  ASSERT_EQ(call("run ball.xml --out a --plugin mine/libshowcase.so"), 0) << err();
  EXPECT_EQ(readWholeFile(path("a/checkpoint")).find("mine/lib"), std::string::npos);
  ASSERT_EQ(call("resume a --until 0.6 --plugin mine/libshowcase.so"), 0) << err();
  ASSERT_EQ(call("resume a --until 0.7"), 0) << err();  // the same, found by its name
  std::string bytes = readWholeFile(plugin);
  writeWholeFile(plugin, bytes + "another build");
  EXPECT_EQ(call("resume a --until 0.8 --plugin mine/libshowcase.so"), 2);
  EXPECT_NE(err().find("libshowcase.so is not the one that was used (fingerprint "),
            std::string::npos)
      << err();
}

TEST_F(RunFaults, CheckpointsChangeNoNumber) {
  write("ball.xml", bouncingBallXml(2.0, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out a --no-checkpoint"), 0) << err();
  ASSERT_EQ(call("run ball.xml --out b --checkpoint 1us"), 0) << err();
  expectSame("a", "b");
}

TEST_F(RunFaults, VerifyNamesTheFileThatWasChanged) {
  write("ball.xml", bouncingBallXml(0.5, "1e-3"));
  ASSERT_EQ(call("run ball.xml --out a"), 0) << err();
  ASSERT_EQ(call("verify a"), 0) << out();
  for (const char* file : {"signals.csv", "events.csv", "ledger.csv", "frames.bin", "checkpoint"}) {
    const std::string name = std::string("a/") + file, whole = readWholeFile(path(name));
    std::string bytes = whole;
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write(name, bytes);
    EXPECT_EQ(call("verify a"), 2) << file;
    const std::string text = out();
    const std::size_t line = text.find(std::string(" ") + file + ' ');
    ASSERT_NE(line, std::string::npos) << text;
    EXPECT_EQ(text.substr(line + 15, 5), "FAULT") << text;
    write(name, whole);
  }
  EXPECT_EQ(call("verify a"), 0) << out();
  EXPECT_EQ(call("verify nowhere"), 2);
}

}  // namespace
}  // namespace dynamy
