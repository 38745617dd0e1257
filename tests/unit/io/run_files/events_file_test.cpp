#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/events_file.hpp>
#include <unit/io/files/scratch_folder.hpp>

namespace dynamy {
namespace {
using testing::ScratchFolder;

TEST(EventsFile, CountsWhatItHasNoRoomFor) {
  const ScratchFolder scratch;
  EventsFile file(scratch / "events.csv");
  for (long i = 0; i < EventsFile::kMostEvents; ++i) file.event({}, "a");
  EXPECT_EQ(file.leftOut(), 0);
  for (int i = 0; i < 3; ++i) file.event({}, "a");
  EXPECT_EQ(file.leftOut(), 3);
  file.flush();
  const std::string text = readWholeFile(scratch / "events.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), EventsFile::kMostEvents + 1);
}

TEST(EventsFile, GoesOnCountingWhereItWas) {
  const ScratchFolder scratch;
  FilePlace place;
  {
    EventsFile file(scratch / "events.csv");
    place = file.place();
  }
  EventsFile file(scratch / "events.csv", place, EventsFile::kMostEvents + 7);
  file.event({}, "a");
  EXPECT_EQ(file.leftOut(), 8);
  EXPECT_TRUE(file.pending().empty());
}

}  // namespace
}  // namespace dynamy
