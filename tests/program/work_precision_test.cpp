/// dynamy bench work-precision: the table it writes, how an error is told, and what a peer says.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "program_fixture.hpp"

namespace dynamy {
namespace {

struct Row {
  std::string scene, engine, method, setting, note;
  double error = 0.0, cpu = 0.0;
  long evaluations = 0;
};

class WorkPrecisionTest : public ProgramTest {
 protected:
  std::vector<Row> rows() const {
    std::istringstream in(readWholeFile(path("m/work_precision.csv")));
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "scene,engine,method,setting,error,cpu_s,evaluations,note");
    std::vector<Row> out;
    while (std::getline(in, line)) {
      std::vector<std::string> f(1);
      bool inside = false;
      for (const char c : line) {
        if (c == '"')
          inside = !inside;
        else if (c == ',' && !inside)
          f.emplace_back();
        else
          f.back() += c;
      }
      if (f.size() != 8) {
        ADD_FAILURE() << line;
        continue;
      }
      out.push_back(
          {f[0], f[1], f[2], f[3], f[7], std::stod(f[4]), std::stod(f[5]), std::stol(f[6])});
    }
    return out;
  }
  /// A folder of one scene: a mass in free fall, which is expected at z = 0.75 ± 0.25 after 1 s.
  void writeFall() const {
    std::filesystem::create_directories(path("own"));
    write("own/scenes.txt", "fall 0.1* 0.05  # a comment\n");
    write("own/methods.txt", "midpoint | step | MoreauMidpoint | all |\n");
    write("own/fall.xml",
          R"(<!-- Truth. --><dynamy version="1" title="Fall">
  <systems><Coordinates name="m" q="z" q0="1" units="m" M="1" potential="2*z"/></systems>
  <simulation until="1" step="0.1"/>
  <check signal="m.z" value="0.75" tolerance="0.25"/></dynamy>)");
  }
};

TEST_F(WorkPrecisionTest, QuickPartHasAPointOfEveryMethod) {
  ASSERT_EQ(
      call("bench work-precision --quick --peers none --scene bouncing_ball,free_top --out m"), 0)
      << err();
  const std::vector<Row> all = rows();
  EXPECT_GE(all.size(), 8u);
  for (const Row& r : all) {
    EXPECT_EQ(r.engine, "dynamY");
    EXPECT_TRUE(std::isfinite(r.error)) << r.scene << ' ' << r.method << ": " << r.note;
    EXPECT_GT(r.cpu, 0.0) << r.scene << ' ' << r.method << ' ' << r.setting;
    EXPECT_GT(r.evaluations, 0);
  }
  const std::string page = readWholeFile(path("m/work_precision.html"));
  EXPECT_NE(page.find("id=\"free_top\""), std::string::npos);
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_NE(readWholeFile(path("m/work_precision_bouncing_ball.svg")).find("</svg>"),
            std::string::npos);
}

TEST_F(WorkPrecisionTest, ErrorIsTheDistanceFromTheTruthInTheUnitOfTheCheck) {
  writeFall();
  ASSERT_EQ(call("bench work-precision --peers none --repeats 1 --scenes own --out m"), 0) << err();
  const std::vector<Row> all = rows();
  ASSERT_EQ(all.size(), 2u);
  // Constant force: the rule is exact, z(1) = 1 − 2/2 = 0, off by 0.75 = 3 · 0.25; rounding in 20
  // steps stays below 1e-13.
  for (const Row& r : all) EXPECT_NEAR(r.error, 3.0, 1e-13);
}

TEST_F(WorkPrecisionTest, PeersAreJudgedByTheSameChecks) {
  writeFall();
  std::filesystem::create_directories(path("peers"));
  write("peers/peer_fake", R"(#!/bin/sh
if [ $# -eq 0 ]; then
  printf 'engine Fake 1.0\nnote soft contact\n'
  printf 'point fall\tgood\t1e-2*\npoint fall\tsilent\t1e-2\npoint fall\tcrash\t1e-2\npoint other\tgood\t1\n'
  exit
fi
case $2 in
  good) printf 'values 0.5\ncpu 0.25\nevaluations 7\nnote soft\n' ;;
  crash) kill -SEGV $$ ;;
esac
)");
  std::filesystem::permissions(path("peers/peer_fake"), std::filesystem::perms::owner_all);
  ASSERT_EQ(call("bench work-precision --repeats 1 --scenes own --peers-in peers --out m"), 0)
      << err();
  std::vector<Row> fake;
  for (const Row& r : rows())
    if (r.engine == "Fake") fake.push_back(r);
  ASSERT_EQ(fake.size(), 3u);            // the scene `other` is not there
  EXPECT_DOUBLE_EQ(fake[0].error, 1.0);  // |0.5 − 0.75| / 0.25
  EXPECT_DOUBLE_EQ(fake[0].cpu, 0.25);
  EXPECT_EQ(fake[0].evaluations, 7);
  EXPECT_EQ(fake[0].note, "soft");
  EXPECT_TRUE(std::isnan(fake[1].error));
  EXPECT_TRUE(std::isnan(fake[2].error));
  EXPECT_NE(fake[2].note.find("signal"), std::string::npos) << fake[2].note;
  const std::string page = readWholeFile(path("m/work_precision.html"));
  EXPECT_NE(page.find("soft contact"), std::string::npos);
  EXPECT_NE(page.find("No point:"), std::string::npos);
}

TEST_F(WorkPrecisionTest, UnknownNamesAreAnswered) {
  EXPECT_EQ(call("bench work-precision --scene bouncing_bal --out m"), 64);
  EXPECT_NE(err().find("did you mean \"bouncing_ball\""), std::string::npos) << err();
  EXPECT_EQ(call("bench work-precision --peers nobody --peers-in . --out m"), 64);
  EXPECT_NE(err().find("bench/peers/install"), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
