/// Damaged checkpoints, films and tables: each is refused with words or read as far as it is whole;
/// no crash, and no other result without a word. LongRunFiles does 10⁵ of each; DYNAMY_COUNT sets
/// another number, DYNAMY_SEED repeats a run.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/run_files/checkpoint.hpp>
#include <dynamy/io/run_files/frames_file.hpp>
#include <dynamy/io/run_files/signals_file.hpp>
#include <fuzz/chosen_seed.hpp>
#include <fuzz/small_runs.hpp>
#include <random>
#include <unit/io/files/scratch_folder.hpp>

namespace dynamy {
namespace {
using testing::ScratchFolder;

unsigned long number(const char* variable, unsigned long otherwise) {
  const char* given = std::getenv(variable);
  return given != nullptr ? std::strtoul(given, nullptr, 10) : otherwise;
}

/// What a disk, a copy or a hand does to a file.
class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }
  std::string operator()(const std::string& whole) {
    std::string bytes = whole;
    do {
      once(bytes);
    } while (below(4) == 0);
    return bytes;
  }

 private:
  void once(std::string& bytes) {
    if (bytes.empty()) {
      bytes.assign(below(64), static_cast<char>(below(256)));
      return;
    }
    const std::size_t at = below(bytes.size()), other = below(bytes.size());
    const std::size_t block = std::min(below(512) + 1, bytes.size() - std::max(at, other));
    switch (below(8)) {
      case 0:
      case 1:  // a bit
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 2:  // cut off
        bytes.resize(at);
        break;
      case 3:  // two blocks change places
        for (std::size_t i = 0; i < block; ++i) std::swap(bytes[at + i], bytes[other + i]);
        break;
      case 4:  // a block of zeros, as after a loss of power
        bytes.replace(at, block, block, '\0');
        break;
      case 5:  // anything
        for (std::size_t i = 0; i < block; ++i) bytes[at + i] = static_cast<char>(below(256));
        break;
      case 6:  // doubled
        bytes.insert(at, bytes.substr(other, block));
        break;
      default: {  // a word that means much: counts, infinities, indices
        static constexpr std::uint64_t kWords[] = {0,
                                                   1,
                                                   ~std::uint64_t{0},
                                                   std::uint64_t{1} << 31,
                                                   std::uint64_t{1} << 63,
                                                   0x7ff0000000000000u,
                                                   0x7ff8000000000000u,
                                                   0x43e0000000000000u,
                                                   0x4059000000000000u};
        std::string word;
        appendBytes(word, kWords[below(std::size(kWords))]);
        bytes.replace(at, std::min<std::size_t>(8, bytes.size() - at), word);
      }
    }
  }
  std::mt19937 random_;
};

class RunFiles : public ::testing::Test {
 protected:
  RunFiles() : seed_(fuzz::chosenSeed()) { RecordProperty("seed", static_cast<int>(seed_)); }
  void checkpoints(unsigned long count);
  void states(unsigned long count);
  void films(unsigned long count);
  void tables(unsigned long count);
  std::string seedText() const { return "DYNAMY_SEED=" + std::to_string(seed_); }
  unsigned seed_;
  fuzz::World world_;
};

/// The file: refused, unless the damage undid itself.
void RunFiles::checkpoints(unsigned long count) {
  Damage damage(seed_);
  Checkpoint whole;
  whole.program = "0", whole.modelText = fuzz::scenes()[1];
  whole.simulation = fuzz::kept(world_, 1, 40);
  const std::string bytes = bytesOf(whole);
  for (unsigned long i = 0; i < count; ++i) {
    const std::string damaged = damage(bytes);
    try {
      readCheckpoint(damaged, "checkpoint");
      ASSERT_EQ(damaged, bytes) << seedText() << ' ' << i;
    } catch (const FileError& e) {
      ASSERT_STRNE(e.what(), "");
    }
  }
}

/// What it keeps of a run, behind a checksum that agrees: the last line of defence.
void RunFiles::states(unsigned long count) {
  Damage damage(seed_);
  std::vector<std::string> kept;
  for (std::size_t s = 0; s < fuzz::scenes().size(); ++s)
    for (const long steps : {1, 25, 60}) kept.push_back(fuzz::kept(world_, s, steps));
  unsigned long went = 0;
  for (unsigned long i = 0; i < count; ++i) {
    const std::size_t which = damage.below(kept.size());
    std::string bytes = kept[which];
    // Most often a word on its own, so that the joints stay where they are.
    if (damage.below(4) > 0) {
      const std::size_t at = 8 * damage.below(bytes.size() / 8);
      std::string word = bytes.substr(at, 8);
      word[damage.below(8)] = static_cast<char>(damage.below(256));
      bytes.replace(at, word.size(), word);
    } else {
      bytes = damage(bytes);
    }
    SCOPED_TRACE(seedText() + ' ' + std::to_string(i));
    // One that never ends would be killed with the last line that was printed.
    if (i % 1000 == 0) std::printf("%s from %lu\n", seedText().c_str(), i), std::fflush(stdout);
    ::alarm(60);
    went += fuzz::goesOn(world_, which / 3, bytes, 1) ? 1 : 0;
  }
  ::alarm(0);
  EXPECT_GT(went, 0u);
  EXPECT_LT(went, count);
}

void RunFiles::films(unsigned long count) {
  Damage damage(seed_);
  const ScratchFolder scratch;
  const auto path = scratch / "frames.bin";
  {
    Scene scene;
    scene.frames.resize(3);
    FramesFile file(path, scene);
    const std::vector<Pose> poses(3);
    for (int i = 0; i < 60; ++i) {
      const std::vector<ContactMark> marks(static_cast<std::size_t>(i % 3));
      file.frame(0.01 * i, poses, marks);
      if (i % 7 == 0) file.flush();
    }
  }
  const std::string bytes = readWholeFile(path);
  const Frames whole = framesIn(bytes, "frames.bin");
  ASSERT_TRUE(whole.complete);
  for (unsigned long i = 0; i < count; ++i) {
    const std::string damaged = damage(bytes);
    try {
      const Frames f = framesIn(damaged, "frames.bin");
      // What is read are frames of the run, chunk for chunk; a cut between chunks cannot be seen
      // here.
      ASSERT_LE(f.pose.size(), f.t.size() * 3 * Frames::kPoseNumbers);
      for (const double t : f.t)
        ASSERT_TRUE(std::binary_search(whole.t.begin(), whole.t.end(), t))
            << seedText() << ' ' << i;
      const FilePlace place{bytes.size(), crc32(bytes)};
      const bool known = damaged.size() == place.bytes && crc32(damaged) == place.crc;
      ASSERT_EQ(known, damaged == bytes) << seedText() << ' ' << i;  // dynamy verify
    } catch (const FileError& e) {
      ASSERT_STRNE(e.what(), "");
    }
  }
}

void RunFiles::tables(unsigned long count) {
  Damage damage(seed_);
  std::string text = "t,a.x,\"a, b\"\n";
  for (int i = 0; i < 200; ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(i * i) + ",-1.25e-7\n";
  const std::uint32_t crc = crc32(text);
  for (unsigned long i = 0; i < count; ++i) {
    const std::string damaged = damage(text);
    try {
      const SignalTable table = signalsIn(damaged, "signals.csv");
      for (const auto& column : table.columns) ASSERT_EQ(column.size(), table.t.size());
    } catch (const FileError& e) {
      ASSERT_STRNE(e.what(), "");
    }
    // A digit that became another is seen by the CRC-32 in run.json, and by a checkpoint's.
    const bool known = damaged.size() == text.size() && crc32(damaged) == crc;
    ASSERT_EQ(known, damaged == text) << seedText() << ' ' << i;
  }
}

TEST_F(RunFiles, DamagedCheckpointsAreRefused) { checkpoints(2000); }
TEST_F(RunFiles, DamagedStatesOfRunsNeverCrash) { states(300); }
TEST_F(RunFiles, DamagedFilmsAreReadAsFarAsTheyAreWhole) { films(2000); }
TEST_F(RunFiles, DamagedTablesAreReadOrRefused) { tables(2000); }

TEST_F(RunFiles, BodiesOfAnySpeedAreFollowedOrRefused) {
  // What a damaged checkpoint may say, a model may say as well; 1e20 m/s was followed without end.
  for (const char* speed : {"1e10", "1e20", "1e100", "1e300"}) {
    std::string text = fuzz::scenes()[0];
    text.replace(
        text.find("velocity=\"1 0 0\""), 16,
        std::string("velocity=\"") + speed + " 0 0\" angularVelocity=\"0 0 " + speed + '"');
    Model model = loadModelText(text, "fuzz.xml", world_.registry, world_.plugins);
    Simulation simulation(model);
    fuzz::StopAfter few(3);
    simulation.observe(few);
    simulation.stopWhen(few.stop);
    ::alarm(60);
    EXPECT_NE(simulation.run().steps, -1) << speed;
    ::alarm(0);
  }
}

/// Also where nothing is left to do. Joints drift up to the last state; the watch looks at one
/// step of fourteen, and the last of the 3333 is none of them.
TEST_F(RunFiles, ARunResumedAtItsEndReportsWhatTheStraightOneDoes) {
  for (const char* settings : {R"(step="0.3ms"/>)", R"(tolerance="1e-6"/>)",
                               R"(step="0.3ms"><MoreauMidpoint/></simulation>)"}) {
    SCOPED_TRACE(settings);
    const std::string text = fuzz::scene(std::string(R"(<simulation until="0.9999" )") + settings);
    Model model = loadModelText(text, "fuzz.xml", world_.registry, world_.plugins);
    Model again = loadModelText(text, "fuzz.xml", world_.registry, world_.plugins);
    Simulation straight(model), resumed(again);
    std::string last;  // after the last step, before the run is known to be over
    straight.onCheckpoint(1e-12, 1e12, [&last](const std::string& bytes) { last = bytes; });
    const RunReport& a = straight.run();
    resumed.resume(last);
    const RunReport& b = resumed.run();
    EXPECT_EQ(b.gaps.jointError.value, a.gaps.jointError.value);
    EXPECT_EQ(b.gaps.jointError.t, a.gaps.jointError.t);
    EXPECT_EQ(b.gaps.jointError.name, a.gaps.jointError.name);
    EXPECT_EQ(b.gaps.penetration.value, a.gaps.penetration.value);
    EXPECT_EQ(b.gaps.penetration.t, a.gaps.penetration.t);
    EXPECT_EQ(b.trust.energyError, a.trust.energyError);
    EXPECT_EQ(b.steps, a.steps);
    EXPECT_EQ(b.hash, a.hash);
    EXPECT_EQ(b.warnings.size(), a.warnings.size());
  }
}

class LongRunFiles : public RunFiles {
 protected:
  unsigned long count_ = number("DYNAMY_COUNT", 100'000);
};
TEST_F(LongRunFiles, Checkpoints) { checkpoints(count_); }
TEST_F(LongRunFiles, States) { states(count_); }
TEST_F(LongRunFiles, Films) { films(count_); }
TEST_F(LongRunFiles, Tables) { tables(count_); }

}  // namespace
}  // namespace dynamy
