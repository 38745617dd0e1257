/// The hash of a run: the same whatever is recorded, however many threads work, wherever and in
/// which language it runs, stopped or not; another one for another motion.
#include <dynamy/io/files/json_reader.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

/// Spheres that fall into each other over a floor; `settings` are attributes of <simulation>.
std::string spheres(int count, const std::string& settings, const std::string& record) {
  std::string text =
      "<dynamy version=\"1\">\n  <systems>\n    <Ground name=\"floor\"><HalfSpace "
      "material=\"stone\"/></Ground>\n";
  for (int i = 0; i < count; ++i)
    text += "    <RigidBody name=\"s" + std::to_string(i) + "\" position=\"" +
            std::to_string(0.013 * i) + " 0 " + std::to_string(0.2 + 0.23 * i) +
            "\"><Sphere radius=\"0.1\" mass=\"1\" material=\"stone\"/></RigidBody>\n";
  return text +
         "  </systems>\n  <forces><Gravity/></forces>\n  <elements>\n    <Contact between=\"stone "
         "stone\"><UnilateralCoulomb mu=\"0.3\" epsilonN=\"0.2\"/></Contact>\n  </elements>\n"
         "  <simulation " +
         settings + "/>\n" + record + "</dynamy>\n";
}

class Determinism : public ProgramTest {
 protected:
  std::string hashOf(const std::string& folder) const {
    return readJson(readWholeFile(path(folder + "/run.json")), "run.json")["hash"].text;
  }
  /// The hash of a run that has to end well, with its mistakes else.
  std::string run(const std::string& arguments) const {
    fs::remove_all(folder_ / "r");
    EXPECT_EQ(call("run " + arguments + " --quiet --out r"), 0) << arguments << '\n' << err();
    return hashOf("r");
  }
};

/// A fixed step, and a tolerance with located switches.
const std::vector<std::string> kSettings = {"until=\"0.8\" step=\"2e-3\"",
                                            "until=\"0.8\" tolerance=\"1e-6\""};

TEST_F(Determinism, TheHashDoesNotDependOnWhatIsRecorded) {
  for (const std::string& settings : kSettings) {
    write("m.xml", spheres(3, settings, ""));
    const std::string alone = run("m.xml");
    EXPECT_EQ(alone.size(), 16u);
    for (const char* record :
         {"<record every=\"0.7ms\"/>", "<record signals=\"s0.z\" every=\"0.3\"/>",
          "<record frames=\"1000Hz\"/>", "<record frames=\"0Hz\"/>",
          "<check signal=\"s2.z\" measure=\"max\" over=\"0 0.8\" value=\"0\" tolerance=\"9\"/>"}) {
      write("m.xml", spheres(3, settings, record));
      EXPECT_EQ(run("m.xml"), alone) << settings << record;
    }
  }
}

TEST_F(Determinism, TheHashDoesNotDependOnThreadsLanguageOrFolder) {
  for (const std::string& settings : kSettings) {
    write("m.xml", spheres(4, settings, ""));
    const std::string alone = run("m.xml");
    EXPECT_EQ(run("m.xml --threads 3"), alone);
    for (const char* language : {"C", "de_DE.UTF-8", "tr_TR.UTF-8", "nowhere"}) {
      ::setenv("LC_ALL", language, 1);
      EXPECT_EQ(run("m.xml"), alone) << language;
    }
    ::unsetenv("LC_ALL");
    const fs::path other = folder_ / "other folder" / "übung";
    fs::create_directories(other);
    fs::copy_file(folder_ / "m.xml", other / "another name.xml");
    EXPECT_EQ(run("'other folder/übung/another name.xml'"), alone);
    fs::remove_all(folder_ / "other folder");
  }
}

TEST_F(Determinism, AStoppedRunThatGoesOnHasTheHashOfTheStraightOne) {
  for (const std::string& settings : kSettings) {
    write("m.xml", spheres(3, settings, ""));
    const std::string alone = run("m.xml");
    ASSERT_NE(run("m.xml --until 0.3171"), alone);
    ASSERT_EQ(call("resume r --until 0.6 --quiet"), 0) << err();
    ASSERT_EQ(call("resume r --until 0.8 --quiet"), 0) << err();
    EXPECT_EQ(hashOf("r"), alone) << settings;
  }
}

TEST_F(Determinism, TheHashTellsMotionsApart) {
  const std::string text = spheres(3, kSettings[0], "");
  write("m.xml", text);
  const std::string alone = run("m.xml");
  EXPECT_NE(run("m.xml --step 1e-3"), alone);
  std::string moved = text;  // by one unit in the last place of its position
  const std::string place = "position=\"0.013000 0 0.430000\"";
  ASSERT_NE(moved.find(place), std::string::npos);
  moved.replace(moved.find(place), place.size(), "position=\"0.013000000000000003 0 0.43\"");
  write("m.xml", moved);
  EXPECT_NE(run("m.xml"), alone);
}

}  // namespace
}  // namespace dynamy
