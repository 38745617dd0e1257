/// dynamy run --watch, and what a run tells while it goes on.
#include <signal.h>
#include <build_paths.hpp>

#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <program/program_fixture.hpp>
#include <thread>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

std::string model(const std::string& part) {
  return "<dynamy version=\"1\">\n<include file=\"" + part +
         "\"/>\n<simulation until=\"0.01\" step=\"1e-3\"/><record signals=\"ball.z\"/></dynamy>\n";
}
std::string part(const std::string& z) {
  return "<dynamy version=\"1\"><systems><Coordinates name=\"ball\" q=\"z\" units=\"m\" q0=\"" + z +
         "\" M=\"1\"/></systems></dynamy>\n";
}

class Watch : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("ball.xml", model("part.xml"));
    write("part.xml", part("1"));
  }
  void TearDown() override {
    if (child_ > 0) kill(child_, SIGKILL), waitpid(child_, nullptr, 0);
    ProgramTest::TearDown();
  }
  void start() {
    child_ = fork();
    if (child_ != 0) return;
    const std::string command = "cd '" + folder_.string() +
                                "' && exec '" DYNAMY_BINARY_DIR
                                "/bin/dynamy' run ball.xml --watch --out o > out 2> err";
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  /// Until the watch has said `text` `times` times; at most 20 s.
  void expectSaid(const std::string& text, int times) const {
    for (int i = 0; i < 2000; ++i) {
      int found = 0;
      const std::string said = fs::exists(path("err")) ? err() : "";
      for (std::size_t at = said.find(text); at != std::string::npos; at = said.find(text, at + 1))
        ++found;
      if (found >= times) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    FAIL() << "not said " << times << " times: " << text << '\n' << err();
  }
  double z() const { return readSignals(path("o/signals.csv")).columns.at(0).at(0); }
  pid_t child_ = -1;
};

TEST_F(Watch, RunsAgainWhenAnIncludedFileChangesAndThroughErrors) {
  start();
  expectSaid("waiting for a change", 1);
  EXPECT_EQ(z(), 1.0);
  write("part.xml", part("2"));
  expectSaid("part.xml has changed", 1);
  expectSaid("waiting for a change", 2);
  EXPECT_EQ(z(), 2.0);
  write("part.xml", part("{two}"));
  expectSaid("unknown symbol \"two\"", 1);
  expectSaid("waiting for a change", 3);
  fs::remove(path("part.xml"));  // as between two steps of an editor
  expectSaid("waiting for a change", 4);
  write("part.xml", part("33"));
  expectSaid("waiting for a change", 5);
  EXPECT_EQ(z(), 33.0);
  kill(child_, SIGINT);
  int status = -1;
  waitpid(child_, &status, 0);
  child_ = -1;
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

TEST_F(Watch, StopsALongRunWhenItsFileChanges) {
  std::string slow = model("part.xml");
  slow.replace(slow.find("0.01"), 4, "1e9");
  write("ball.xml", slow);
  start();
  for (int i = 0; i < 2000 && !fs::exists(path("o/run.json")); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(600));  // it has looked at the files
  write("ball.xml", model("part.xml"));
  expectSaid("waiting for a change", 1);
  EXPECT_EQ(readJson(readWholeFile(path("o/run.json")), "run.json")["state"].text, "finished");
}

}  // namespace
}  // namespace dynamy
