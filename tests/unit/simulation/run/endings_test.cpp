/// Runs that end because there is no memory, or because what is recorded finds no room.
#include <gtest/gtest.h>

#include <dynamy/core/error.hpp>
#include <new>
#include <support/table.hpp>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;

/// Takes memory that is not there, once, in a given step.
class Greedy final : public Observer {
 public:
  explicit Greedy(long at) : at_(at) {}
  void step(const StepView&) override {
    if (++steps_ == at_) throw std::bad_alloc();
  }

 private:
  long at_, steps_ = 0;
};

/// The same within a step, where the force is evaluated.
class GreedyForce final : public ExternalForce {
 public:
  explicit GreedyForce(double* at) : at_(at) {}
  void connect(Topology&) override {}
  void addTo(const Kinematics& k, ForceSink&) const override {
    if (k.t() > *at_) throw std::bad_alloc();
  }

 private:
  double* at_;
};

/// A disk that takes so many rows.
class SmallDisk final : public RecordSink {
 public:
  explicit SmallDisk(std::size_t room) : room_(room) {}
  void row(double t, std::span<const double> values) override {
    table.row(t, values);
    if (table.t.size() > room_) fault_ = "the disk is full";
  }
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  std::string_view fault() const override { return fault_; }
  void archive(Archive& a) override { table.archive(a); }
  Table table;

 private:
  std::size_t room_;
  std::string fault_;
};

Model recordedBouncing() {
  Model m = ballOnFloor(1.0, 0.5, 0.5, 0.3, 1.0, 1e-3);
  m.record.every = 1e-2;
  return m;
}

TEST(Endings, ALackOfMemoryWithinAStepLeavesTheCheckpointBeforeIt) {
  Table straight;
  Model whole = recordedBouncing();
  double never = 1e9;
  whole.add(std::make_unique<GreedyForce>(&never));
  whole.build();
  Simulation s(whole);
  s.record(straight);
  s.run();

  Table table;
  Model m = recordedBouncing();
  double at = 0.4;
  m.add(std::make_unique<GreedyForce>(&at));
  m.build();
  std::string checkpoint;
  {
    Simulation first(m);
    Table early;
    first.record(early);
    const RunReport& r = first.run();
    EXPECT_EQ(r.ended, RunReport::Ended::failed);
    EXPECT_EQ(r.cause, RunReport::Cause::memory);
    EXPECT_NE(r.reason.find("out of memory"), std::string::npos) << r.reason;
    EXPECT_NEAR(r.t, 0.4, 2e-3);  // the step that evaluates the force after 0.4 s
    checkpoint = first.checkpoint();
  }
  at = 1e9;
  Simulation second(m);
  second.record(table);
  second.resume(checkpoint);
  EXPECT_EQ(second.run().ended, RunReport::Ended::finished);
  EXPECT_EQ(table.t, straight.t);
  EXPECT_EQ(table.rows, straight.rows);
  EXPECT_EQ(second.report().hash, s.report().hash);
}

TEST(Endings, ALackOfMemoryAfterAStepGoesBackToAnEarlierCheckpoint) {
  Model m = recordedBouncing();
  m.build();
  Greedy greedy(300);
  Simulation s(m);
  Table table;
  s.record(table);
  s.observe(greedy);
  int saved = 0;
  s.onCheckpoint(1e9, 1.0, [&](const std::string&) { ++saved; });
  const RunReport& r = s.run();
  EXPECT_EQ(r.cause, RunReport::Cause::memory);
  EXPECT_EQ(saved, 1);  // before the first step
  Model again = recordedBouncing();
  again.build();
  Simulation second(again);
  Table all;
  Greedy content(0);
  second.record(all);
  second.observe(content);
  second.resume(s.checkpoint());
  EXPECT_EQ(second.state().t, 0.0);
  EXPECT_EQ(second.run().ended, RunReport::Ended::finished);
}

TEST(Endings, AFullDiskEndsARunAtTheEndOfItsStepAndNothingIsLost) {
  Table straight;
  Model whole = recordedBouncing();
  whole.build();
  Simulation s(whole);
  s.record(straight);
  s.run();

  Model m = recordedBouncing();
  m.build();
  SmallDisk disk(30);
  Simulation first(m);
  first.record(disk);
  const RunReport& r = first.run();
  EXPECT_EQ(r.ended, RunReport::Ended::failed);
  EXPECT_EQ(r.cause, RunReport::Cause::files);
  EXPECT_EQ(r.reason, "the disk is full");
  EXPECT_LT(r.t, 0.32);
  SmallDisk larger(1000);
  Simulation second(m);
  second.record(larger);
  second.resume(first.checkpoint());
  second.run();
  EXPECT_EQ(larger.table.t, straight.t);
  EXPECT_EQ(larger.table.rows, straight.rows);
}

TEST(Endings, CheckpointsWaitUntilTheyTakeNoMoreThanTheirShareOfTheTime) {
  // Making one takes some time: with no share there is the first one only, with any after each
  // step.
  for (const auto& [share, expected] : {std::pair{0.0, 1}, std::pair{1e300, 1001}}) {
    Model m = recordedBouncing();
    m.build();
    Simulation s(m);
    int saved = 0;
    s.onCheckpoint(1e-12, share, [&](const std::string&) { ++saved; });
    s.run();
    EXPECT_GE(saved, expected);
    if (share == 0.0) {
      EXPECT_EQ(saved, 1);
    }
  }
}

/// The bytes with the word at `at` replaced.
std::string with(std::string bytes, std::size_t at, std::uint64_t word) {
  for (std::size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<char>(word >> (8 * i));
  return bytes;
}

TEST(Endings, ACheckpointWithAnyWordReplacedNeverHangsOrCrashes) {
  Model m = recordedBouncing();
  m.simulation.until = 0.2;
  m.build();
  Simulation s(m);
  s.run();
  const std::string bytes = s.checkpoint();
  m.simulation.until = 0.21;
  int refused = 0;
  for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8)
    for (const std::uint64_t word :
         {~std::uint64_t{0}, std::uint64_t{1} << 63, std::uint64_t{1} << 40, std::uint64_t{0}}) {
      Simulation again(m);
      try {
        again.resume(with(bytes, at, word));
        again.run();
      } catch (const ModelError& e) {
        ++refused;
        EXPECT_NE(std::string(e.what()).find("checkpoint"), std::string::npos) << e.what();
      }
    }
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace dynamy
