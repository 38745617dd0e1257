#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <limits>
#include <random>
#include <unit/io/files/scratch_folder.hpp>

namespace dynamy {
namespace {
using testing::messageOf;
using testing::ScratchFolder;

const std::array<SignalName, 2> kTwo{{{"ball.z", "m"}, {"ball.vz", "m/s"}}};

TEST(SignalsFile, HasTimeFirstAndOneLineARow) {
  const ScratchFolder scratch;
  SignalsFile file(scratch / "signals.csv", kTwo);
  file.row(0.0, std::array{1.1, 0.0});
  file.row(0.001, std::array{1.0999, -0.00981});
  file.flush();
  EXPECT_EQ(readWholeFile(scratch / "signals.csv"),
            "t,ball.z,ball.vz\n0,1.1,0\n0.001,1.0999,-0.00981\n");
}

TEST(SignalsFile, ReadsBackEveryBit) {
  const ScratchFolder scratch;
  const std::uint64_t seed = 20;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::vector<double> expected{0.0,
                               -0.0,
                               5e-324,
                               std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};
  while (expected.size() < 6000) {
    const double x = std::bit_cast<double>(random());  // all exponents alike
    if (x == x) expected.push_back(x);
  }
  {
    SignalsFile file(scratch / "signals.csv", kTwo);
    for (std::size_t i = 0; i < expected.size(); i += 2) {
      file.row(static_cast<double>(i), std::array{expected[i], expected[i + 1]});
    }
  }
  const SignalTable table = readSignals(scratch / "signals.csv");
  ASSERT_EQ(table.t.size(), expected.size() / 2);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(table.columns[i % 2][i / 2]),
              std::bit_cast<std::uint64_t>(expected[i]));
  }
}

TEST(SignalsFile, KeepsNotANumber) {
  const ScratchFolder scratch;
  {
    SignalsFile file(scratch / "s.csv", kTwo);
    file.row(0, std::array{-std::numeric_limits<double>::quiet_NaN(), 1.0});
  }
  EXPECT_EQ(readWholeFile(scratch / "s.csv"), "t,ball.z,ball.vz\n0,nan,1\n");
  EXPECT_NE(readSignals(scratch / "s.csv").columns[0][0],
            readSignals(scratch / "s.csv").columns[0][0]);
}

TEST(SignalsFile, QuotesNamesThatNeedIt) {
  const ScratchFolder scratch;
  const std::array<SignalName, 2> names{{{"a,b", ""}, {"say \"x\"\nplease", ""}}};
  { SignalsFile file(scratch / "s.csv", names); }
  const SignalTable table = readSignals(scratch / "s.csv");
  ASSERT_EQ(table.signals.size(), 2u);
  EXPECT_EQ(table.signals[0].name, names[0].name);
  EXPECT_EQ(table.signals[1].name, names[1].name);
}

TEST(SignalsFile, HoldsWholeRowsOnlyWhileItIsWritten) {
  const ScratchFolder scratch;
  SignalsFile file(scratch / "s.csv", kTwo);
  for (int i = 0; i < 5000; ++i) file.row(i / 3.0, std::array{i / 7.0, i / 11.0});
  const std::string text = readWholeFile(scratch / "s.csv");  // nothing was flushed by hand
  EXPECT_GT(text.size(), 1000u);
  EXPECT_EQ(text.back(), '\n');
}

TEST(ReadSignals, LeavesOutAnUnfinishedLastRow) {
  const ScratchFolder scratch;
  writeWholeFile(scratch / "s.csv", "t,a\n0,1\n0.5,2\n1,3.");
  EXPECT_EQ(readSignals(scratch / "s.csv").t, (std::vector{0.0, 0.5}));
}

TEST(ReadSignals, NamesTheLineOfABrokenRow) {
  const ScratchFolder scratch;
  writeWholeFile(scratch / "s.csv", "t,a\n0,1\n0.5\n");
  const std::string message = messageOf<FileError>([&] { readSignals(scratch / "s.csv"); });
  EXPECT_NE(message.find("s.csv:3: expected 2 numbers"), std::string::npos) << message;
}

TEST(ReadSignals, RefusesATableWithoutTime) {
  const ScratchFolder scratch;
  writeWholeFile(scratch / "s.csv", "x,y\n1,2\n");
  EXPECT_THROW(readSignals(scratch / "s.csv"), FileError);
}

TEST(SignalsFile, SaysWhyItCannotWrite) {
  const std::string message =
      messageOf<FileError>([] { SignalsFile file("no/such/folder/s.csv", kTwo); });
  EXPECT_EQ(message, "no/such/folder/s.csv: cannot write: No such file or directory");
}

}  // namespace
}  // namespace dynamy
