/// scripts/animate: the film of a run as an animated SVG.
#include <build_paths.hpp>
#include <program/program_fixture.hpp>
#include <regex>
#include <vector>

namespace dynamy {
namespace {

class Animate : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (std::system("python3 -c pass 2>/dev/null") != 0) GTEST_SKIP() << "no python3";
    write("fall.xml", R"(<dynamy version="1">
  <systems><RigidBody name="ball" position="0 0 2"><Sphere radius="0.1" mass="1"/></RigidBody></systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <simulation until="0.4" step="1e-3"><MoreauMidpoint/></simulation>
  <record signals="ball.z" frames="100Hz" view="xz"/>
</dynamy>)");
    ASSERT_EQ(call("run fall.xml --quiet --out o"), 0) << err();
  }
  int animate(const std::string& arguments) const {
    return WEXITSTATUS(
        std::system(("cd '" + folder_.string() + "' && python3 '" +
                     DYNAMY_SOURCE_DIR "/scripts/animate' " + arguments + " > out 2> err")
                        .c_str()));
  }
};

// Pictures 0.04 s apart of a ball that falls from rest: heights go with k². Pixels are rounded to
// 0.1 and the way is more than 150 of them long: each ratio errs by less than 2e-3.
TEST_F(Animate, APictureForEachFrameOfAFallingBall) {
  ASSERT_EQ(animate("film.svg o,from=0,to=0.4,frames=10"), 0) << err();
  const std::string film = readWholeFile(path("film.svg"));
  std::vector<double> y;
  const std::regex centre("<g class=\"f10\"[^>]*><circle [^>]*cy=\"([-0-9.]+)\"");
  for (std::sregex_iterator it(film.begin(), film.end(), centre), end; it != end; ++it)
    y.push_back(std::stod((*it)[1]));
  ASSERT_EQ(y.size(), 10u) << film;
  ASSERT_GT(y[9] - y[0], 150);
  for (std::size_t k = 1; k < 10; ++k)
    EXPECT_NEAR((y[k] - y[0]) / (y[9] - y[0]), static_cast<double>(k * k) / 81, 2e-3) << k;
}

TEST_F(Animate, SaysWhatIsWrong) {
  EXPECT_NE(animate("film.svg"), 0);
  EXPECT_NE(err().find("scripts/animate OUT.svg RUN"), std::string::npos) << err();
  EXPECT_NE(animate("film.svg o,framse=3"), 0);
  EXPECT_NE(err().find("framse"), std::string::npos) << err();
  EXPECT_NE(animate("film.svg nowhere"), 0);
  EXPECT_NE(err().find("nowhere"), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
