/// scripts/trust: what it appends to doc/trust/*.csv and draws into doc/trust.md.
#include <gtest/gtest.h>
#include <unistd.h>
#include <build_paths.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace dynamy::architecture {
namespace {

namespace fs = std::filesystem;

// A tree of its own with the script and a page of one campaign.
class TrustScript : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("dynamy_trust_" + std::to_string(getpid()));
    fs::create_directories(root_ / "scripts");
    fs::create_directories(root_ / "doc");
    fs::copy(DYNAMY_SOURCE_DIR "/scripts/trust", root_ / "scripts" / "trust");
    std::ofstream(root_ / "doc" / "trust.md")
        << "# Page\n\n<!-- trust: killed -->\nold\n<!-- end -->\nend\n";
  }
  void TearDown() override { fs::remove_all(root_); }
  int call(const std::string& arguments) const {
    const std::string command = "python3 '" + (root_ / "scripts" / "trust").string() + "' " +
                                arguments + " 2> '" + (root_ / "err").string() + "'";
    return std::system(command.c_str());
  }
  std::string text(const char* file) const {
    std::ostringstream out;
    out << std::ifstream(root_ / file).rdbuf();
    return out.str();
  }
  fs::path root_;
};

constexpr const char* kAll = "add killed --commit abc --found nothing --limits '1 s, 1 GB' --part ";

TEST_F(TrustScript, KeepsACampaignInPartsAsOneRow) {
  if (std::system("python3 -c pass 2>/dev/null") != 0) GTEST_SKIP() << "no python3";
  const std::string add = std::string(kAll) + "'kill -9' --count 10 --seeds ";
  ASSERT_EQ(call(add + "1-10"), 0) << text("err");
  ASSERT_EQ(call(add + "11-20"), 0) << text("err");  // goes on
  ASSERT_EQ(call(add + "31-40"), 0) << text("err");  // does not
  EXPECT_EQ(text("doc/trust/killed.csv"),
            "part,commit,count,seeds,found,limits\n"
            "kill -9,abc,20,1-20,nothing,\"1 s, 1 GB\"\n"
            "kill -9,abc,10,31-40,nothing,\"1 s, 1 GB\"\n");
  EXPECT_EQ(text("doc/trust.md"),
            "# Page\n\n<!-- trust: killed -->\n"
            "| part | commit | count | seeds | found | limits |\n|---|---|---|---|---|---|\n"
            "| kill -9 | abc | 20 | 1-20 | nothing | 1 s, 1 GB |\n"
            "| kill -9 | abc | 10 | 31-40 | nothing | 1 s, 1 GB |\n<!-- end -->\nend\n");
}

TEST_F(TrustScript, RefusesACampaignThatThePageDoesNotName) {
  if (std::system("python3 -c pass 2>/dev/null") != 0) GTEST_SKIP() << "no python3";
  EXPECT_NE(call("add other --part x --count 1 --found nothing"), 0);
  EXPECT_NE(text("err").find("doc/trust.md has no line <!-- trust: other -->"), std::string::npos);
  EXPECT_FALSE(fs::exists(root_ / "doc" / "trust"));
}

}  // namespace
}  // namespace dynamy::architecture
