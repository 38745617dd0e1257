// dynamy view --video: films, and that nothing of others is removed for them.
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

namespace fs = std::filesystem;

bool there(const char* program) {
  return std::system(("command -v " + std::string(program) + " >/dev/null 2>&1").c_str()) == 0;
}

class Film : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("fall.xml", R"(<dynamy version="1">
  <systems><RigidBody name="ball" position="0 0 2"><Sphere radius="0.1" mass="1"/></RigidBody></systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <simulation until="0.2" step="1e-2"><MoreauMidpoint/></simulation>
  <record signals="ball.z" frames="50Hz" view="xz"/>
</dynamy>)");
    ASSERT_EQ(call("run fall.xml --quiet --out runs/x"), 0) << err();
  }
  std::size_t files(const std::string& folder) const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(path(folder)), fs::directory_iterator()));
  }
  std::string video(const std::string& file) const {
    return "view runs/x --size 64x48 --fps 10 --slower 1 --to 0.2 --video " + file;
  }
};

TEST_F(Film, AsMp4LeavesFoldersOfTheSameNameAlone) {
  if (!there("chromium") || !there("ffmpeg")) GTEST_SKIP() << "no chromium or no ffmpeg";
  fs::create_directories(path("mine"));
  write("mine/note.txt", "keep");
  write("mine/00001.png", "keep");
  for (const char* film : {"mine.mp4", "runs/x.mp4"}) {
    const std::string folder = fs::path(film).replace_extension().string();
    const std::size_t before = files(folder);
    ASSERT_EQ(call(video(film)), 0) << err();
    EXPECT_GT(fs::file_size(path(film)), 100u);
    EXPECT_EQ(files(folder), before) << film;
  }
  EXPECT_EQ(readWholeFile(path("mine/note.txt")), "keep");
  EXPECT_EQ(readWholeFile(path("mine/00001.png")), "keep");
  EXPECT_TRUE(fs::exists(path("runs/x/frames.bin")));
}

TEST_F(Film, PicturesDoNotGoAmongOthers) {
  fs::create_directories(path("mine"));
  write("mine/00001.png", "keep");
  EXPECT_EQ(call(video("mine")), 2);
  EXPECT_NE(err().find("mine: holds pictures already"), std::string::npos) << err();
  EXPECT_EQ(readWholeFile(path("mine/00001.png")), "keep");
  fs::create_directories(path("mine.gif"));
  EXPECT_EQ(call(video("mine.gif")), 2);
  EXPECT_NE(err().find("mine.gif: is a folder"), std::string::npos) << err();
}

TEST_F(Film, LooksAreCheckedWhetherThePageKnowsThem) {
  if (!there("chromium")) GTEST_SKIP() << "no chromium";
  EXPECT_EQ(call(video("p --look 'names=ball&hide=bal'")), 64);
  EXPECT_NE(err().find("no body \"bal\" in this run — did you mean \"ball\"?"), std::string::npos)
      << err();
  EXPECT_EQ(call(video("p --look 'names=1&arrows=2&azimuth=30'")), 0) << err();
  EXPECT_EQ(files("p"), 2u);  // 0.2 s, ten pictures a second
}

TEST_F(Film, NumbersOfALookAreNumbers) {
  for (const char* look : {"arrows=0", "arrows=long", "azimuth=", "elevation=1x"}) {
    EXPECT_EQ(call(video("p --look '" + std::string(look) + "'")), 64) << look;
    EXPECT_NE(err().find("number, not \""), std::string::npos) << err();
  }
}

TEST_F(Film, NoCommandWritesOverTheFileThatItReads) {
  const std::string model = readWholeFile(path("fall.xml"));
  EXPECT_EQ(call("export fmu fall.xml -o fall.xml"), 64);
  EXPECT_NE(err().find("is the file that is read"), std::string::npos) << err();
  EXPECT_EQ(readWholeFile(path("fall.xml")), model);
  write("arm.urdf", "<robot name=\"arm\"><link name=\"base\"/></robot>");
  EXPECT_EQ(call("import arm.urdf -o ./arm.urdf"), 64);
  EXPECT_NE(err().find("is the file that is read"), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
