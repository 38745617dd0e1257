#include <gtest/gtest.h>

#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/frames_file.hpp>
#include <unit/io/files/scratch_folder.hpp>

namespace dynamy {
namespace {
using testing::messageOf;
using testing::ScratchFolder;

Scene twoFrames() {
  Scene scene;
  scene.view = "xz";
  scene.frames = {{"ball", "ball.xml:5"}, {"box", ""}};
  return scene;
}

/// Poses that single precision holds exactly.
std::vector<Pose> posesAt(int i) {
  Pose ball, box;
  ball.r_OS_I = {0.5 * i, -1.0 * i, 0.25};
  box.p_IK = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
  return {ball, box};
}

/// Ten frames, frame i with i contacts, in two chunks.
void writeTen(const std::filesystem::path& path) {
  FramesFile file(path, twoFrames());
  for (int i = 0; i < 10; ++i) {
    std::vector<ContactMark> contacts(static_cast<std::size_t>(i));
    for (ContactMark& contact : contacts) contact.F_I = {0, 0, 9.5};
    for (ContactMark& contact : contacts) contact.state = ContactState::slip, contact.limit = 2.5;
    file.frame(i / 3.0, posesAt(i), contacts, 0.0625 * i);
    if (i == 5) file.flush();
  }
}

TEST(FramesFile, IsReadBackAsItWasWritten) {
  const ScratchFolder scratch;
  writeTen(scratch / "frames.bin");
  const Frames frames = readFrames(scratch / "frames.bin");
  EXPECT_TRUE(frames.complete);
  EXPECT_EQ(frames.poses, 2u);
  ASSERT_EQ(frames.t.size(), 10u);
  ASSERT_EQ(frames.pose.size(), 10u * 2u * 7u);
  for (std::size_t i = 0; i < 10; ++i) {
    const auto x = static_cast<float>(i);
    EXPECT_EQ(frames.t[i], static_cast<double>(i) / 3.0);
    EXPECT_EQ(frames.step[i], 0.0625F * x);
    const std::vector<float> got(&frames.pose[14 * i], &frames.pose[14 * i] + 14);
    EXPECT_EQ(got, (std::vector<float>{0.5f * x, -x, 0.25f, 1, 0, 0, 0,  //
                                       0, 0, 0, 0.5f, -0.5f, 0.5f, -0.5f}));
    EXPECT_EQ(frames.firstContact[i + 1] - frames.firstContact[i], i);
  }
  ASSERT_EQ(frames.contact.size(), 495u);
  const std::vector<float> contact(frames.contact.end() - 11, frames.contact.end());
  EXPECT_EQ(contact, (std::vector<float>{0, 0, 0, 0, 0, 1, 0, 0, 9.5f, 2, 2.5f}));
}

TEST(FramesFile, CarriesTheSceneAsJson) {
  const ScratchFolder scratch;
  writeTen(scratch / "frames.bin");
  EXPECT_EQ(readFrames(scratch / "frames.bin").scene,
            R"({"view":"xz","frames":[{"name":"ball","place":"ball.xml:5"},)"
            R"({"name":"box","place":""}],"shapes":[]})");
}

TEST(FramesFile, HasTheBytesOfTheDocument) {
  const ScratchFolder scratch;
  {
    FramesFile file(scratch / "f", Scene{});
    file.frame(2.0, {}, {}, 0.5);
  }
  const std::string text = readWholeFile(scratch / "f");
  const std::string json = R"({"view":"","frames":[],"shapes":[]})";
  std::string expected = "DYNFRAME";
  for (const std::uint32_t x : {3u, 0x01020304u, 0u, 35u}) appendBytes(expected, x);
  expected += json;
  appendBytes(expected, crc32(expected));
  const std::size_t chunk = expected.size();
  expected += "CHNK";
  appendBytes(expected, std::uint32_t{1});
  appendBytes(expected, std::uint64_t{16});
  appendBytes(expected, 2.0);
  appendBytes(expected, 2.0);
  std::string payload;
  appendBytes(payload, 2.0);
  appendBytes(payload, std::uint32_t{0});
  appendBytes(payload, 0.5F);
  appendBytes(expected, crc32(expected.substr(chunk) + payload));
  appendBytes(expected, std::uint32_t{0});
  EXPECT_EQ(text, expected + payload);
}

TEST(ReadFrames, KeepsWholeChunksHoweverTheFileIsCutOff) {
  const ScratchFolder scratch;
  writeTen(scratch / "frames.bin");
  const std::string whole = readWholeFile(scratch / "frames.bin");
  const std::size_t firstChunk = whole.find("CHNK"), secondChunk = whole.rfind("CHNK");
  ASSERT_NE(firstChunk, secondChunk);
  for (std::size_t size = firstChunk; size < whole.size(); size += 7) {
    writeWholeFile(scratch / "cut", whole.substr(0, size));
    const Frames frames = readFrames(scratch / "cut");
    EXPECT_EQ(frames.t.size(), size < secondChunk ? 0u : 6u) << size;
    EXPECT_EQ(frames.pose.size(), frames.t.size() * 14);
    EXPECT_EQ(frames.firstContact.size(), frames.t.size() + 1);
  }
}

TEST(ReadFrames, StopsAtAChunkWithAWrongByteAnywhere) {
  const ScratchFolder scratch;
  writeTen(scratch / "frames.bin");
  const std::string whole = readWholeFile(scratch / "frames.bin");
  const std::size_t secondChunk = whole.rfind("CHNK");
  for (std::size_t at = secondChunk; at < whole.size(); at += 5) {
    if (at >= secondChunk + 36 && at < secondChunk + 40) continue;  // the reserved zero
    std::string wrong = whole;
    wrong[at] = static_cast<char>(wrong[at] ^ 0x10);
    writeWholeFile(scratch / "wrong", wrong);
    const Frames frames = readFrames(scratch / "wrong");
    EXPECT_FALSE(frames.complete) << at;
    EXPECT_EQ(frames.t.size(), 6u) << at;
  }
}

TEST(ReadFrames, RefusesOtherFilesAndOtherVersions) {
  const ScratchFolder scratch;
  writeWholeFile(scratch / "png", "\x89PNG and more than twenty-four bytes");
  EXPECT_THROW(readFrames(scratch / "png"), FileError);
  writeTen(scratch / "frames.bin");
  std::string text = readWholeFile(scratch / "frames.bin");
  text[8] = 9;
  writeWholeFile(scratch / "new", text);
  const std::string message = messageOf<FileError>([&] { readFrames(scratch / "new"); });
  EXPECT_NE(message.find("has version 9 of the format"), std::string::npos) << message;
}

TEST(ReadFrames, ReadsFilesWithoutAStep) {
  const ScratchFolder scratch;
  {
    FramesFile file(scratch / "f", Scene{});
    file.frame(2.0, {});  // a zero, where version 2 had one
  }
  std::string text = readWholeFile(scratch / "f");
  const std::size_t head = text.find("CHNK") - 4;
  text[8] = 2;
  std::string crc;
  appendBytes(crc, crc32(text.substr(0, head)));
  writeWholeFile(scratch / "old", text.replace(head, 4, crc));
  const Frames frames = readFrames(scratch / "old");
  EXPECT_TRUE(frames.complete);
  ASSERT_EQ(frames.step.size(), 1U);
  EXPECT_EQ(frames.step[0], 0.0F);
}

TEST(FramesFile, WantsOnePoseAFrame) {
  const ScratchFolder scratch;
  FramesFile file(scratch / "f", twoFrames());
  EXPECT_THROW(file.frame(0, std::vector<Pose>(1)), std::logic_error);
}

}  // namespace
}  // namespace dynamy
