#include <gtest/gtest.h>

#include <dynamy/core/error.hpp>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/checkpoint.hpp>
#include <unit/io/files/scratch_folder.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;
using testing::messageOf;
using testing::ScratchFolder;

Checkpoint example() {
  Checkpoint c;
  c.program = "0.1.0, gcc", c.t = 0.25;
  c.choice.model = "/models/ball.xml", c.choice.set = {{"e", "0.5"}, {"mu", "{1/3}"}};
  c.choice.until = 2.0, c.choice.every = 1e-3, c.choice.solver = "Automatic";
  c.choice.sources = {{"ball.xml", "0123456789abcdef"}};
  c.modelText = "<dynamy/>";
  c.simulation = std::string("\0state\xff", 7);
  return c;
}

std::string exampleBytes() {
  Checkpoint c = example();
  return bytesOf(c);
}

TEST(Checkpoint, IsReadBackAsItWasWritten) {
  const Checkpoint c = readCheckpoint(exampleBytes(), "checkpoint");
  EXPECT_EQ(c.program, "0.1.0, gcc");
  EXPECT_EQ(c.t, 0.25);
  EXPECT_EQ(c.choice.set, example().choice.set);
  EXPECT_EQ(c.choice.sources, example().choice.sources);
  EXPECT_EQ(c.choice.until, 2.0);
  EXPECT_EQ(c.simulation, example().simulation);
}

TEST(Checkpoint, HasTheHeadOfTheDocument) {
  const std::string bytes = exampleBytes();
  EXPECT_EQ(bytes.substr(0, 8), "DYNCHECK");
  EXPECT_EQ(readBytes<std::uint32_t>(&bytes[8]), 1u);
  EXPECT_EQ(bytes.substr(12, 4), "\x04\x03\x02\x01");
  EXPECT_EQ(readBytes<std::uint64_t>(&bytes[16]), bytes.size() - 40);
  // The CRC-32 of the 32 bytes before it and of the payload.
  const std::string covered = bytes.substr(0, 32) + bytes.substr(40);
  EXPECT_EQ(readBytes<std::uint32_t>(&bytes[32]), crc32(covered));
}

TEST(Checkpoint, WithAnyBitFlippedIsRefused) {
  const std::string bytes = exampleBytes();
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_THROW(readCheckpoint(damaged, "checkpoint"), FileError) << bit;
  }
}

TEST(Checkpoint, CutOffOrContinuedIsRefusedWithItsLengths) {
  const std::string bytes = exampleBytes();
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_THROW(readCheckpoint(bytes.substr(0, n), "checkpoint"), FileError) << n;
  EXPECT_THROW(readCheckpoint(bytes + '\0', "checkpoint"), FileError);
  const std::string payload = std::to_string(bytes.size() - 40);
  EXPECT_EQ(messageOf<FileError>([&] { readCheckpoint(bytes.substr(0, 100), "k/checkpoint"); }),
            "k/checkpoint: is cut off: 60 of " + payload + " bytes are left");
}

TEST(Checkpoint, OfAnotherLayoutSaysBothNumbers) {
  std::string bytes = exampleBytes();
  bytes[8] = 7;
  const std::uint32_t crc = crc32(bytes.substr(0, 32) + bytes.substr(40));
  std::string text;
  appendBytes(text, crc);
  bytes.replace(32, 4, text);
  const std::string message = messageOf<FileError>([&] { readCheckpoint(bytes, "checkpoint"); });
  EXPECT_NE(message.find("has layout 7, this program reads layout 1"), std::string::npos)
      << message;
}

TEST(Checkpoint, NamesNoLibraryByItsPath) {
  Checkpoint c = example();
  c.choice.libraries = {"/elsewhere/evil/libmine.so", "../other.so", "showcase"};
  const Checkpoint read = readCheckpoint(bytesOf(c), "checkpoint");
  EXPECT_EQ(read.choice.libraries, (std::vector<std::string>{"mine", "other", "showcase"}));
  EXPECT_EQ(bytesOf(c).find("evil"), std::string::npos);
}

TEST(Checkpoint, HoldsNoStepThatIsNone) {
  Checkpoint c = example();
  for (const double step :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    c.choice.step = step;
    EXPECT_THROW(readCheckpoint(bytesOf(c), "checkpoint"), FileError) << step;
  }
}

class CheckpointFolder : public ::testing::Test {
 protected:
  CheckpointFolder() : folder_(scratch_.path()) { writeWholeFile(folder_.signals(), "t,x\n0,1\n"); }
  void save(double t) {
    Checkpoint c = example();
    c.t = t;
    const std::string text = readWholeFile(folder_.signals());
    c.files = {{"signals.csv", {text.size(), crc32(text)}}};
    writeCheckpoint(folder_, c, false);
  }
  void damage(const fs::path& file) const {
    std::string bytes = readWholeFile(file);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    writeWholeFile(file, bytes);
  }
  ScratchFolder scratch_;
  RunFolder folder_;
};

TEST_F(CheckpointFolder, KeepsTheLastTwo) {
  for (const double t : {1.0, 2.0, 3.0}) save(t);
  EXPECT_EQ(findCheckpoint(folder_).checkpoint.t, 3.0);
  EXPECT_EQ(findCheckpoint(folder_).note, "");
  EXPECT_EQ(readCheckpoint(readWholeFile(folder_.olderCheckpoint()), "").t, 2.0);
}

TEST_F(CheckpointFolder, FallsBackToTheOlderOneAndSaysWhy) {
  save(1.0), save(2.0);
  damage(folder_.checkpoint());
  const FoundCheckpoint found = findCheckpoint(folder_);
  EXPECT_EQ(found.checkpoint.t, 1.0);
  EXPECT_EQ(found.note, "checkpoint is damaged: its checksum is wrong");
  keepOnly(folder_, found);
  save(3.0);  // the damaged one has not become the older one
  damage(folder_.checkpoint());
  EXPECT_EQ(findCheckpoint(folder_).checkpoint.t, 1.0);
}

TEST_F(CheckpointFolder, FallsBackIfTheRecordedFilesDoNotReachTheLastOne) {
  save(1.0);
  writeWholeFile(folder_.signals(), "t,x\n0,1\n1,2\n");
  save(2.0);
  writeWholeFile(folder_.signals(), "t,x\n0,1\n1,");
  const FoundCheckpoint found = findCheckpoint(folder_);
  EXPECT_EQ(found.checkpoint.t, 1.0);
  EXPECT_EQ(found.note, "signals.csv is cut off: 10 of 12 bytes are left");
  writeWholeFile(folder_.signals(), "t,x\n0,7\n1,2\n");
  const std::string message = messageOf<FileError>([&] { findCheckpoint(folder_); });
  EXPECT_NE(message.find("signals.csv was changed: its first 8 bytes are not those that the run "
                         "wrote"),
            std::string::npos)
      << message;
}

TEST_F(CheckpointFolder, UsesTheRoomThatWasKeptWhereThereIsNoOther) {
  save(1.0), save(2.0);
  reserveRoom(folder_, 1 << 16);
  if (!fs::exists(folder_.spareRoom())) GTEST_SKIP() << "this file system reserves nothing";
  fs::create_directory(scratch_ / "checkpoint.next.part");  // nothing can be written there
  save(3.0);
  EXPECT_FALSE(fs::exists(folder_.spareRoom()));
  EXPECT_EQ(findCheckpoint(folder_).checkpoint.t, 3.0);
  EXPECT_EQ(readCheckpoint(readWholeFile(folder_.olderCheckpoint()), "").t, 2.0);
}

TEST_F(CheckpointFolder, WithoutAnySaysSo) {
  const std::string message = messageOf<FileError>([&] { findCheckpoint(folder_); });
  EXPECT_NE(message.find("holds no checkpoint"), std::string::npos) << message;
}

TEST_F(CheckpointFolder, NamesNoFileOutsideOfIt) {
  Checkpoint c = example();
  c.files = {{"../signals.csv", {0, 0}}};
  writeCheckpoint(folder_, c, false);
  EXPECT_THROW(findCheckpoint(folder_), FileError);
}

}  // namespace
}  // namespace dynamy
