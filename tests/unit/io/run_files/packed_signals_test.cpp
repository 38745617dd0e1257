#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <chrono>
#include <cstdint>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <limits>
#include <random>
#include <thread>
#include <unit/io/files/scratch_folder.hpp>

namespace dynamy {
namespace {
using testing::messageOf;
using testing::ScratchFolder;

/// A name with a path, one with characters of CSV and one beyond ASCII.
const std::array<SignalName, 3> kSignals{
    {{"left/arm.phi", "rad"}, {"a, \"b\".x", "m"}, {"φ.z", ""}}};

/// Writes signals.csv with random bits of all exponents, numbers that are not finite among them.
void writeRows(const RunFolder& folder, int rows) {
  writeWholeFile(folder.model(), "<dynamy/>");
  std::mt19937_64 random(7);
  SignalsFile file(folder.signals(), kSignals);
  for (int i = 0; i < rows; ++i) {
    std::array<double, 3> values{};
    for (double& x : values) x = std::bit_cast<double>(random());
    for (double& x : values)
      if (x != x) x = std::numeric_limits<double>::quiet_NaN();  // text knows one of them
    file.row(0.001 * i, values);
  }
}

TEST(PackedSignals, GiveBackEveryByteOfTheTable) {
  for (const int rows : {0, 1, 8192, 20'000}) {  // none, less than a chunk, one, and a part of one
    const ScratchFolder scratch;
    const RunFolder folder(scratch / "run");
    writeRows(folder, rows);
    const std::string before = readWholeFile(folder.signals());
    const RecordedFile packed = packSignals(folder, kSignals, "a run");
    EXPECT_FALSE(std::filesystem::exists(folder.signals()));
    EXPECT_EQ(packed.name, "signals.h5");
    EXPECT_EQ(packed.place.crc, crc32(readWholeFile(packedSignals(folder))));
    EXPECT_EQ(packed.place.bytes, std::filesystem::file_size(packedSignals(folder)));
    unpackSignals(folder);
    EXPECT_EQ(readWholeFile(folder.signals()), before) << rows;
  }
}

TEST(PackedSignals, AreReadWithTheirUnits) {
  const ScratchFolder scratch;
  const RunFolder folder(scratch / "run");
  writeRows(folder, 10);
  const SignalTable before = signalsOf(folder.path());
  packSignals(folder, kSignals, "a run");
  const SignalTable after = signalsOf(folder.path());
  EXPECT_EQ(after.t, before.t);
  ASSERT_EQ(after.signals.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(after.signals[k].name, kSignals[k].name);
    EXPECT_EQ(after.signals[k].unit, kSignals[k].unit);
  }
}

TEST(PackedSignals, OfTheSameRunHaveTheSameBytes) {
  const ScratchFolder scratch;
  const RunFolder a(scratch / "a"), b(scratch / "b");
  writeRows(a, 100), writeRows(b, 100);
  packSignals(a, kSignals, "a run");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // in another second
  packSignals(b, kSignals, "a run");
  EXPECT_EQ(readWholeFile(packedSignals(a)), readWholeFile(packedSignals(b)));
}

TEST(PackedSignals, AreRefusedWhereAByteIsWrong) {
  const ScratchFolder scratch;
  const RunFolder folder(scratch / "run");
  writeRows(folder, 3000);
  packSignals(folder, kSignals, "a run");
  std::string bytes = readWholeFile(packedSignals(folder));
  // Random numbers do not shrink: a chunk of 3000 numbers of 8 bytes lies around the middle.
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x10);
  writeWholeFile(packedSignals(folder), bytes);
  const std::string message = messageOf<FileError>([&] { signalsOf(folder.path()); });
  EXPECT_NE(message.find("signals.h5: /"), std::string::npos) << message;
  EXPECT_NE(message.find("cannot be read as numbers"), std::string::npos) << message;
  writeWholeFile(packedSignals(folder), "no HDF5");
  EXPECT_NE(messageOf<FileError>([&] { signalsOf(folder.path()); }).find("not an HDF5 file"),
            std::string::npos);
}

TEST(PackedSignals, LeaveTheTableWhereTheyCannotBeWritten) {
  const ScratchFolder scratch;
  const RunFolder folder(scratch / "run");
  writeRows(folder, 10);
  std::filesystem::create_directories(scratch / "run/signals.h5.part/x");
  EXPECT_THROW(packSignals(folder, kSignals, "a run"), WriteError);
  EXPECT_TRUE(std::filesystem::exists(folder.signals()));
}

}  // namespace
}  // namespace dynamy
