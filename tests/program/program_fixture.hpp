/// A folder of its own in which a test calls the program as a user does.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <build_paths.hpp>

#include <algorithm>
#include <cstdlib>
#include <dynamy/io/files/output_file.hpp>
#include <filesystem>
#include <string>

namespace dynamy {

class ProgramTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    folder_ =
        std::filesystem::temp_directory_path() / ("dynamy_" + name + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    writeWholeFile(path(name), text);
  }
  /// Exit code; what it printed lies in the files out and err.
  int call(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.string() + "' && '" +
                                std::string(DYNAMY_BINARY_DIR) + "/bin/dynamy' " + arguments +
                                " > out 2> err";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  std::string out() const { return readWholeFile(path("out")); }
  std::string err() const { return readWholeFile(path("err")); }

  std::filesystem::path folder_;
};

}  // namespace dynamy
