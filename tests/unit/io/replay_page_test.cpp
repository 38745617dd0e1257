#include <gtest/gtest.h>

#include <dynamy/io/replay_page.hpp>
#include <dynamy/io/run_folder.hpp>
#include <dynamy/io/viewer_files.hpp>
#include <unit/io/scratch_folder.hpp>

namespace dynamy {
namespace {
using testing::ScratchFolder;

/// One pose that moves along x only: 0, 1, …, n − 1.
Frames moving(std::size_t n) {
  Frames frames;
  frames.scene = R"({"view":"","frames":[{"name":"a","place":""}],"shapes":[]})";
  frames.poses = 1;
  for (std::size_t f = 0; f < n; ++f) {
    frames.t.push_back(static_cast<double>(f));
    for (const float x : {static_cast<float>(f), 0.f, 0.f, 1.f, 0.f, 0.f, 0.f})
      frames.pose.push_back(x);
    frames.firstContact.push_back(0);
  }
  return frames;
}

std::string member(const std::string& json, const std::string& name) {
  const std::string begin = '"' + name + "\":";
  const std::size_t at = json.find(begin) + begin.size();
  return json.substr(at, json.find_first_of(",}", at) - at);
}

TEST(ReplayPage, RoundsCoordinatesThatMoveAndOmitsTheOthers) {
  const std::string data = replayData(moving(3), {}, {});
  // 0, 1, 2 in the range 0 … 2 are 0, 32768 (32767.5 rounded), 65535: bytes 00 00 00 80 ff ff
  EXPECT_EQ(member(data, "data"), "\"AAAAgP//\"");
  EXPECT_EQ(member(data, "count"), "3");
}

TEST(ReplayPage, KeepsEveryNthFrameAndTheLastWhenThereAreTooMany) {
  ReplayText text;
  text.frameBytes = 14 * 100;  // a pose takes 7 numbers of 2 bytes at most
  const std::string data = replayData(moving(1000), {}, text);
  EXPECT_EQ(member(data, "count"), "101");
  EXPECT_EQ(member(data, "recorded"), "1000");
}

TEST(ReplayPage, TakesTheNearerOfTwoEqualQuaternions) {
  Frames frames = moving(2);
  for (std::size_t k = 0; k < 7; ++k) frames.pose[k] = frames.pose[7 + k] = k == 3 ? 1.f : 0.f;
  frames.pose[7 + 3] = -1.f;  // the same rotation
  EXPECT_EQ(member(replayData(frames, {}, {}), "data"), "\"\"");
}

TEST(ReplayPage, CannotBeEndedEarlyByTextOfTheModel) {
  ReplayText text;
  text.title = "<b>";
  text.modelText = "<doc></script><script>alert(1)</script> {{data}} {{style}}</doc>";
  const std::string page = replayPage(moving(1), {}, text);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_NE(page.find("\\u003c/script>"), std::string::npos);
  EXPECT_NE(page.find("{{data}} {{style}}"), std::string::npos);
  EXPECT_NE(page.find("<title>&lt;b&gt;"), std::string::npos);
}

TEST(ReplayPage, LoadsNothingFromElsewhere) {
  const std::string page = replayPage(moving(1), {}, {});
  for (const char* part : {"http://", "https://", "src=", "@import", "{{"}) {
    EXPECT_EQ(page.find(part), std::string::npos) << part;
  }
}

TEST(ReplayPage, HoldsTheWholeViewer) {
  const std::string page = replayPage(moving(1), {}, {});
  for (const char* name : {"decode.js", "camera.js", "shapes.js", "draw.js", "plots.js",
                           "panels.js", "replay.js", "replay.css"}) {
    ASSERT_FALSE(viewerFile(name).empty()) << name;
    EXPECT_NE(page.find(viewerFile(name)), std::string::npos) << name;
  }
  EXPECT_TRUE(viewerFile("nothing.js").empty());
}

TEST(WriteReplay, MakesThePageFromTheFilesOfARun) {
  const ScratchFolder scratch;
  const RunFolder folder(scratch / "my_run");
  {
    Scene scene;
    scene.frames = {{"ball", "m.xml:3"}};
    FramesFile frames(folder.frames(), scene);
    frames.frame(0, std::vector<Pose>(1));
  }
  writeReplay(folder.path());
  const std::string page = readWholeFile(folder.replay());
  EXPECT_NE(page.find("\"title\":\"my_run\""), std::string::npos);
  EXPECT_NE(page.find("m.xml:3"), std::string::npos);
  EXPECT_NE(page.find("dynamy-run"), std::string::npos);
}

TEST(WriteReplay, DoesWithWhatIsThere) {
  const ScratchFolder scratch;
  EXPECT_NO_THROW(writeReplay(scratch.path()));
}

}  // namespace
}  // namespace dynamy
