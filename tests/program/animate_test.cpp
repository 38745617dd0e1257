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

TEST_F(Animate, KnowsAllColoursOfCss) {
  // Named, short, in full, and as plug-ins may write it in a scene: one colour each.
  for (const auto& [colour, seen] : {std::pair("steelblue", "#4682b4"),
                                     {"#36c", "#3366cc"},
                                     {"#C8553D", "#c8553d"},
                                     {"RebeccaPurple", "#663399"}}) {
    std::string text = readWholeFile(path("fall.xml"));
    const std::string sphere = "<Sphere radius";
    text.insert(text.find(sphere) + 7, " colour=\"" + std::string(colour) + '"');
    write("coloured.xml", text);
    ASSERT_EQ(call("run coloured.xml --quiet --out c"), 0) << err();
    ASSERT_EQ(animate("film.svg c,frames=2"), 0) << err();
    EXPECT_NE(readWholeFile(path("film.svg")).find("fill=\"" + std::string(seen) + '"'),
              std::string::npos)
        << colour;
  }
}

/// Four balls that fall out of the scene and are taken away below z = 0.5.
constexpr const char* kTaken = R"(<dynamy version="1">
  <systems><Grains name="g" count="4" within="0 0 1 2 2 1.4" pitch="0.5" takeWithin="-9 -9 -9 9 9 0.5">
    <Sphere radius="0.1" density="1000"/></Grains></systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <simulation until="0.6" step="1e-3"><MoreauMidpoint/></simulation>
  <record signals="g.meanZ" frames="50Hz" view="xz"/>
</dynamy>)";

TEST_F(Animate, GrainsThatWereTakenAwayAreNotDrawn) {
  write("taken.xml", kTaken);
  ASSERT_EQ(call("run taken.xml --quiet --out g"), 0) << err();
  ASSERT_EQ(animate("film.svg g,frames=6"), 0) << err();
  const std::string film = readWholeFile(path("film.svg"));
  std::vector<int> balls;
  for (std::size_t at = film.find("<g class=\"f6\""); at != std::string::npos;) {
    const std::size_t next = film.find("<g class=\"f6\"", at + 1);
    const std::string picture = film.substr(at, next - at);
    int n = 0;
    for (std::size_t c = picture.find("<circle"); c != std::string::npos;
         c = picture.find("<circle", c + 1))
      ++n;
    balls.push_back(n), at = next;
  }
  // They fall from 1 m … 1.4 m to 0.5 m within √(2 · 0.9/9.81) = 0.43 s; pictures are 0.1 s apart.
  ASSERT_EQ(balls.size(), 6u);
  EXPECT_EQ(balls.front(), 4);
  EXPECT_EQ(balls.back(), 0);
}

TEST_F(Animate, WritesOverNothingButAFilm) {
  const std::string model = readWholeFile(path("fall.xml"));
  EXPECT_NE(animate("fall.xml o"), 0);
  EXPECT_NE(err().find("OUT.svg"), std::string::npos) << err();
  EXPECT_EQ(readWholeFile(path("fall.xml")), model);
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
