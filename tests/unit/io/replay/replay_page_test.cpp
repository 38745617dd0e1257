#include <gtest/gtest.h>

#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/replay/replay_coding.hpp>
#include <dynamy/io/replay/replay_page.hpp>
#include <dynamy/io/replay/viewer_files.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <unit/io/files/scratch_folder.hpp>

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

TEST(ReplayPage, KeepsEveryNthFrameAndTheLastWhenThereAreTooMany) {
  ReplayText text;
  const Frames frames = moving(1000);
  ReplaySize size;
  EXPECT_EQ(member(replayData(frames, {}, text, &size), "count"), "1000");
  EXPECT_FALSE(size.thinned());
  text.frameBytes = size.wholeBytes * 2 / 3;
  const std::string data = replayData(frames, {}, text, &size);
  EXPECT_TRUE(size.thinned());
  EXPECT_EQ(member(data, "count"), std::to_string(size.frames));
  EXPECT_EQ(member(data, "recorded"), "1000");
  EXPECT_LE(size.poseBytes + size.contactBytes, text.frameBytes);
}

TEST(ReplayPage, HoldsTheStepOfEachKeptFrame) {
  Frames frames = moving(3);
  frames.step = {0.0F, 0.5F, 0.25F};
  std::string bytes;
  for (const float step : frames.step) appendBytes(bytes, step);
  std::string packed;
  appendBase64(packed, deflated(bytes));
  EXPECT_EQ(member(replayData(frames, {}, {}), "steps"), '"' + packed + '"');
}

TEST(ReplayPage, SaysWhetherTheOtherRunHasAPictureOfItsOwn) {
  ReplayText text;
  text.other = "{}";
  EXPECT_NE(replayPage(moving(1), {}, text).find("id=\"other\">{}"), std::string::npos);
  text.beside = true;
  EXPECT_NE(replayPage(moving(1), {}, text).find("id=\"other\" data-beside=\"1\">{}"),
            std::string::npos);
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
  for (const char* part : {" src=", "<link", "@import", "{{"}) {
    EXPECT_EQ(page.find(part), std::string::npos) << part;
  }
  // Addresses in the script are names of XML vocabularies, which nobody loads.
  for (const char* scheme : {"http://", "https://"}) {
    for (std::size_t at = page.find(scheme); at != std::string::npos;
         at = page.find(scheme, at + 1))
      EXPECT_EQ(page.compare(at, 17, "http://www.w3.org"), 0) << page.substr(at, 80);
  }
}

TEST(ReplayPage, HoldsTheWholeViewer) {
  const std::string page = replayPage(moving(1), {}, {});
  for (const char* name : {"replay.js", "replay.css"}) {
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
  EXPECT_NE(page.find("\"scene\":\""), std::string::npos);
  EXPECT_NE(page.find("dynamy-run"), std::string::npos);
}

TEST(WriteReplay, DoesWithWhatIsThere) {
  const ScratchFolder scratch;
  EXPECT_NO_THROW(writeReplay(scratch.path()));
}

}  // namespace
}  // namespace dynamy
