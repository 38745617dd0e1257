#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <unit/io/files/scratch_folder.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;
using testing::messageOf;
using testing::ScratchFolder;

TEST(RunFolder, IsNamedAfterTheModelByDefault) {
  EXPECT_EQ(defaultRunFolder("models/ball.v2.xml"), fs::path("runs/ball.v2"));
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
  {
    const RunFolder first(scratch.path());
    writeWholeFile(first.signals(), "t\n");
    writeWholeFile(first.replay(), "old");
  }
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
  fs::remove(scratch / "run.lock");  // the other file of a folder that is written
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 1);
}

TEST(RunFolder, BelongsToOneRunAtATime) {
  const ScratchFolder scratch;
  {
    const RunFolder first(scratch.path());
    writeWholeFile(first.signals(), "t\n1\n");
    const std::string message = messageOf<FileError>([&] { RunFolder second(scratch.path()); });
    EXPECT_NE(message.find("another run writes into this folder (process " +
                           std::to_string(::getpid()) + " on "),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("choose another --out"), std::string::npos) << message;
    EXPECT_EQ(readWholeFile(first.signals()), "t\n1\n");
    EXPECT_THROW(RunFolder::resumed(scratch.path()), FileError);
    EXPECT_NO_THROW(RunFolder::existing(scratch.path()));  // to read it
    EXPECT_NE(FolderLock::holder(scratch.path()), "");
  }
  EXPECT_EQ(FolderLock::holder(scratch.path()), "");
  EXPECT_NO_THROW(RunFolder::resumed(scratch.path()));
  EXPECT_FALSE(fs::exists(scratch / "run.lock"));
}

TEST(RunFolder, OfAProcessThatDiedIsFree) {
  const ScratchFolder scratch;
  const fs::path ready = scratch / "ready";
  const pid_t child = ::fork();
  if (child == 0) {
    const RunFolder folder(scratch / "run");
    writeWholeFile(ready, "");
    ::pause();
    ::_exit(0);
  }
  for (int i = 0; i < 1000 && !fs::exists(ready); ++i) ::usleep(10000);
  EXPECT_THROW(RunFolder::resumed(scratch / "run"), FileError);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(scratch / "run/run.lock"));  // the file stays, the lock has gone
  EXPECT_NO_THROW(RunFolder::resumed(scratch / "run"));
}

TEST(RunFolder, SaysInPlaceHowARunEndedWhereNothingElseCanBeWritten) {
  const ScratchFolder scratch;
  const RunFolder folder(scratch.path());
  folder.writeFacts([](JsonWriter& j) { j.member("state", "running").member("t", 0.25); });
  fs::create_directory(scratch / "run.json.part");  // stands where the new file would be written
  folder.writeLastFacts([](JsonWriter& j) { j.member("state", "failed").member("t", 0.5); },
                        [](JsonWriter& j) { j.member("state", "failed"); });
  const std::string text = readWholeFile(folder.facts());
  EXPECT_NE(text.find("\"state\": \"failed\""), std::string::npos) << text;
  EXPECT_EQ(text.find("0.25"), std::string::npos) << text;
  EXPECT_TRUE(holdsRun(scratch.path()));
}

}  // namespace
}  // namespace dynamy
