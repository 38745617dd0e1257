#include <gtest/gtest.h>

#include <dynamy/io/file_error.hpp>
#include <dynamy/io/output_file.hpp>
#include <dynamy/io/run_folder.hpp>
#include <unit/io/scratch_folder.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;
using testing::messageOf;
using testing::ScratchFolder;

TEST(RunFolder, IsNamedAfterTheModelByDefault) {
  EXPECT_EQ(RunFolder::defaultPath("models/ball.v2.xml"), fs::path("runs/ball.v2"));
}

TEST(RunFolder, IsCreatedWithItsParentsAndSaysThatTheRunGoesOn) {
  const ScratchFolder scratch;
  const RunFolder folder(scratch / "a/b/c");
  EXPECT_TRUE(holdsRun(scratch / "a/b/c"));
  EXPECT_NE(readWholeFile(folder.facts()).find("\"state\": \"running\""), std::string::npos);
}

TEST(RunFolder, TakesAnEmptyFolder) {
  const ScratchFolder scratch;
  EXPECT_NO_THROW(RunFolder(scratch.path()));
}

TEST(RunFolder, ReplacesTheFilesOfAnOlderRunAndKeepsAllOthers) {
  const ScratchFolder scratch;
  const RunFolder first(scratch.path());
  writeWholeFile(first.signals(), "t\n");
  writeWholeFile(first.replay(), "old");
  writeWholeFile(scratch / "notes.txt", "mine");
  const RunFolder second(scratch.path());
  EXPECT_FALSE(fs::exists(second.signals()));
  EXPECT_FALSE(fs::exists(second.replay()));
  EXPECT_EQ(readWholeFile(scratch / "notes.txt"), "mine");
}

TEST(RunFolder, RefusesAFolderThatHoldsSomethingElse) {
  const ScratchFolder scratch;
  writeWholeFile(scratch / "thesis.tex", "text");
  const std::string message = messageOf<FileError>([&] { RunFolder folder(scratch.path()); });
  EXPECT_NE(message.find(scratch.path().string() + ": the folder is not empty and holds no run"),
            std::string::npos)
      << message;
  EXPECT_EQ(readWholeFile(scratch / "thesis.tex"), "text");
  EXPECT_FALSE(fs::exists(scratch / "run.json"));
}

TEST(RunFolder, RefusesARunJsonOfSomebodyElse) {
  const ScratchFolder scratch;
  writeWholeFile(scratch / "run.json", R"({"format": "other-run", "text": "dynamy-run"})");
  EXPECT_THROW(RunFolder(scratch.path()), FileError);
}

TEST(RunFolder, KnowsItsRunAfterAnotherProgramHasFormattedRunJson) {
  const ScratchFolder scratch;
  writeWholeFile(scratch / "run.json", "{\"version\":1,\n\t\"format\"  :\n \"dynamy-run\"}");
  EXPECT_TRUE(holdsRun(scratch.path()));
}

TEST(RunFolder, RefusesAFile) {
  const ScratchFolder scratch;
  writeWholeFile(scratch / "file", "x");
  const std::string message = messageOf<FileError>([&] { RunFolder folder(scratch / "file"); });
  EXPECT_NE(message.find("is a file"), std::string::npos) << message;
}

TEST(RunFolder, WritesFactsBehindTheMarkerAndLeavesNoPartFile) {
  const ScratchFolder scratch;
  const RunFolder folder(scratch.path());
  folder.writeFacts([](JsonWriter& json) { json.member("steps", 3); });
  EXPECT_EQ(readWholeFile(folder.facts()),
            "{\n  \"format\": \"dynamy-run\",\n  \"version\": 1,\n  \"steps\": 3\n}\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace dynamy
