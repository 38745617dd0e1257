/// Everything that the documents tell a reader to type or to save works as printed, from the top of
/// a page to its end. The folder looks like a clone after its first build.
#include <algorithm>
#include <build_paths.hpp>
#include <fstream>
#include <program/program_fixture.hpp>

#include "document.hpp"

namespace dynamy {
namespace {
namespace fs = std::filesystem;

class DocumentTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    const fs::path source = DYNAMY_SOURCE_DIR, binary = DYNAMY_BINARY_DIR;
    fs::create_directories(folder_ / "build");
    fs::create_directories(folder_ / "scripts");
    fs::create_directories(folder_ / "path");
    fs::create_directory_symlink(binary, folder_ / "build" / "release");
    fs::create_symlink(binary / "bin" / "dynamy", folder_ / "path" / "dynamy");
    fs::copy(source / "models", folder_ / "models", fs::copy_options::recursive);
    // Packages and builds are not the matter here.
    script("run", "exec \"$(dirname \"$0\")/../build/release/bin/dynamy\" run \"$@\"\n");
    script("test", "exit 0\n");
    script("build-release", "exit 0\n");
  }
  void script(const std::string& name, const std::string& text) const {
    write("scripts/" + name, "#!/bin/sh\n" + text);
    fs::permissions(folder_ / "scripts" / name, fs::perms::owner_all);
  }
  /// Runs all marked blocks of the page; what they print must contain the blocks marked `output`.
  void follow(const std::string& file) const {
    const std::vector<MarkedBlock> blocks = markedBlocks(file);
    ASSERT_FALSE(blocks.empty()) << file << " has no marked block";
    write("page.sh", scriptOf(blocks, file));
    const std::string command =
        "cd '" + folder_.string() +
        "' && HOME=\"$PWD\" PATH=\"$PWD/path:$PATH\" PYTHONDONTWRITEBYTECODE=1 "
        "PYTHONPATH=\"" DYNAMY_BINARY_DIR "/lib/python3/dist-packages:" DYNAMY_SOURCE_DIR
        "/app/python\" " +
        "CXX=" DYNAMY_CXX " bash page.sh > out 2>&1";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << out();
    const std::string printed = out();
    for (const MarkedBlock& block : blocks)
      if (block.mark == "output") expectPrinted(block, printed, file);
  }
  /// Each line of the block is part of what was printed; … stands for what differs from run to run.
  static void expectPrinted(const MarkedBlock& block, const std::string& printed,
                            const std::string& file) {
    std::istringstream lines(block.text);
    for (std::string line; std::getline(lines, line);) {
      std::size_t at = 0;
      for (std::size_t from = 0; from != std::string::npos && at != std::string::npos;) {
        const std::size_t to = line.find("…", from);
        const std::string piece = line.substr(from, to == std::string::npos ? to : to - from);
        at = printed.find(piece, at);
        from = to == std::string::npos ? to : to + std::string("…").size();
      }
      EXPECT_NE(at, std::string::npos)
          << file << ":" << block.line << ": not printed: " << line << "\n"
          << printed;
    }
  }
};

TEST_F(DocumentTest, Readme) { follow("README.md"); }
TEST_F(DocumentTest, FirstRun) { follow("doc/tutorial/01_first_run.md"); }
TEST_F(DocumentTest, FirstModel) { follow("doc/tutorial/02_first_model.md"); }
TEST_F(DocumentTest, RunFolder) { follow("doc/run_folder.md"); }
TEST_F(DocumentTest, Python) { follow("doc/python.md"); }
TEST_F(DocumentTest, FileFormat) { follow("doc/file_format.md"); }
TEST_F(DocumentTest, Sweep) { follow("doc/sweep.md"); }
TEST_F(DocumentTest, Import) { follow("doc/import.md"); }
TEST_F(DocumentTest, Eigen) { follow("doc/eigen.md"); }
TEST_F(DocumentTest, Laws) { follow("doc/laws.md"); }
TEST_F(DocumentTest, ShapePairs) { follow("doc/shape_pairs.md"); }
TEST_F(DocumentTest, Control) { follow("doc/control.md"); }
TEST_F(DocumentTest, Equilibrium) { follow("doc/equilibrium.md"); }
TEST_F(DocumentTest, Gradient) { follow("doc/gradient.md"); }
TEST_F(DocumentTest, Fmu) { follow("doc/fmu.md"); }
TEST_F(DocumentTest, Orbit) { follow("doc/orbit.md"); }
TEST_F(DocumentTest, Fit) { follow("doc/fit.md"); }
TEST_F(DocumentTest, Machine) { follow("doc/tutorial/04_machine.md"); }
TEST_F(DocumentTest, FrictionFromAFilm) { follow("doc/tutorial/05_fit.md"); }
TEST_F(DocumentTest, RhythmOfTheWoodpecker) { follow("doc/tutorial/06_orbit.md"); }
TEST_F(DocumentTest, Report) { follow("doc/report.md"); }
TEST_F(DocumentTest, Security) { follow("doc/security.md"); }
#ifndef DYNAMY_SANITIZED
TEST_F(DocumentTest, Install) { follow("doc/install.md"); }
TEST_F(DocumentTest, FirstPluginAgainstTheInstalledPackage) {
  follow("doc/tutorial/03_first_plugin.md");
}
TEST_F(DocumentTest, ModelsInCpp) { follow("doc/cpp_models.md"); }
using LongDocumentTest = DocumentTest;
TEST_F(LongDocumentTest, NewPlugin) { follow("doc/new_plugin.md"); }
#endif

}  // namespace
}  // namespace dynamy
