// dynamy export fmu: the package, and what another program computes with it.
#include <build_paths.hpp>
#include <cmath>
#include <dynamy/io/files/csv.hpp>
#include <fstream>
#include <map>
#include <program/program_fixture.hpp>
#include <regex>
#include <set>
#include <sstream>

namespace dynamy {
namespace {

class FmuExport : public ProgramTest {
 protected:
  static std::string model(const std::string& name) {
    return std::string("'") + DYNAMY_SOURCE_DIR + "/models/" + name + "'";
  }
  int shell(const std::string& command) const {
    const std::string line = "cd '" + folder_.string() + "' && " + command + " > out 2> err";
    return WEXITSTATUS(std::system(line.c_str()));
  }
  /// Exports a model and unpacks the FMU into the folder `fmu`.
  void unpack(const std::string& modelAndOptions) const {
    ASSERT_EQ(call("export fmu " + modelAndOptions + " -o a.fmu"), 0) << err();
    std::filesystem::remove_all(path("fmu"));
    std::filesystem::create_directories(path("fmu"));
    ASSERT_EQ(shell("cd fmu && '" DYNAMY_CMAKE "' -E tar xf ../a.fmu"), 0) << err();
  }
  /// What the other program prints.
  std::string master(const std::string& words) const {
    EXPECT_EQ(shell("'" + std::string(DYNAMY_BINARY_DIR) + "/bin/fmu_master' fmu " + words), 0)
        << err();
    return out();
  }
};

struct Printed {
  std::vector<std::vector<double>> rows;  ///< t and outputs
  std::vector<double> events;             ///< [s]
};

Printed printed(const std::string& text) {
  Printed out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("event ")) {
      out.events.push_back(std::stod(line.substr(6)));
      continue;
    }
    out.rows.emplace_back();
    std::istringstream words(line);
    for (double x = 0.0; words >> x;) out.rows.back().push_back(x);
  }
  return out;
}

/// Column `name` of signals.csv by the row's time; of two rows of an impact the later one.
std::map<double, double> recorded(const std::string& file, const std::string& name) {
  const auto table = readCsv(readWholeFile(file));
  std::map<double, double> out;
  const auto column = static_cast<std::size_t>(
      std::find(table.at(0).begin(), table[0].end(), name) - table[0].begin());
  for (std::size_t i = 1; i < table.size(); ++i)
    out[std::stod(table[i][0])] = std::stod(table[i].at(column));
  return out;
}

/// Largest difference of column `k` to the recorded signal; instants are equal up to rounding.
double difference(const Printed& fmu, std::size_t k, const std::map<double, double>& native) {
  double worst = 0.0;
  for (const std::vector<double>& row : fmu.rows) {
    const auto at = native.lower_bound(row[0] - 1e-12);
    if (at == native.end() || std::abs(at->first - row[0]) > 1e-12) return INFINITY;
    worst = std::max(worst, std::abs(at->second - row.at(k)));
  }
  return worst;
}

TEST_F(FmuExport, WritesWhatItSaysAndEqualModelsGiveEqualFiles) {
  ASSERT_EQ(call("export fmu " + model("woodpecker.xml")), 0) << err();
  EXPECT_EQ(out(), "woodpecker.fmu: FMI 3.0 co-simulation, 2 parameters, 0 inputs, 6 outputs\n");
  ASSERT_EQ(call("export fmu " + model("woodpecker.xml") + " --out b.fmu"), 0) << err();
  EXPECT_EQ(readWholeFile(path("woodpecker.fmu")), readWholeFile(path("b.fmu")));
}

TEST_F(FmuExport, HoldsTheModelItsFilesAndItsPlugins) {
  std::filesystem::create_directories(path("models/parts"));
  write("models/parts/spring.xml", R"(<dynamy version="1"><parameter name="k" value="8"/>
  <forces><Table name="map" of="cart.x" file="../map.csv"/>
  <ForceInput on="cart" force="-k*map.out; 0; 0"/></forces></dynamy>)");
  write("models/map.csv", "x,y\n-1,-1\n1,1\n");
  write("models/m.xml", R"(<dynamy version="1"><plugin library="woodpecker"/>
  <include file="parts/spring.xml"/>
  <systems><PointMass name="cart" position="0.5 0 0" velocity="0 0 0" mass="2"/></systems>
  <simulation until="1" tolerance="1e-8"/><record signals="cart.x"/></dynamy>)");
  unpack("models/m.xml");
  for (const char* file : {"resources/model/m.xml", "resources/model/parts/spring.xml",
                           "resources/model/map.csv", "modelDescription.xml"})
    EXPECT_TRUE(std::filesystem::exists(path("fmu") + '/' + file)) << file;
  std::set<std::string> libraries;
  for (const auto& e : std::filesystem::recursive_directory_iterator(path("fmu/binaries")))
    if (e.is_regular_file()) libraries.insert(e.path().filename().string());
  EXPECT_TRUE(libraries.contains("m.so"));
  EXPECT_TRUE(libraries.contains("libwoodpecker.so"));
  EXPECT_TRUE(libraries.contains("libdynamy_elements.so"));
  std::filesystem::rename(path("models"), path("away"));
  // x = cos(2 t)/2; 1e-8 is the accuracy of positions, over a length of 1 m.
  EXPECT_NEAR(printed(master("run until=1 h=0.25 out=cart.x")).rows.back()[1], 0.5 * std::cos(2.0),
              1e-7);
}

TEST_F(FmuExport, DescribesVariablesUnitsAndAbilities) {
  unpack(model("woodpecker.xml") + " --set mu=0.31 --signals toy.y toy.phiM 'sleeve2.*'");
  const std::string text = readWholeFile(path("fmu/modelDescription.xml"));
  for (const char* part :
       {"fmiVersion=\"3.0\"", "modelIdentifier=\"woodpecker\"", "hasEventMode=\"true\"",
        "canGetAndSetFMUState=\"true\"", "canSerializeFMUState=\"true\"",
        "<Unit name=\"N\"><BaseUnit kg=\"1\" m=\"1\" s=\"-2\"/></Unit>",
        "<DefaultExperiment startTime=\"0\" stopTime=\"3\" tolerance=\"1e-06\" "
        "stepSize=\"0.001\"/>",
        "<Float64 name=\"mu\" valueReference=\"2\" description=\"parameter of the model\" "
        "causality=\"parameter\" variability=\"fixed\" initial=\"exact\" start=\"0.31\"/>",
        "<Enumeration name=\"sleeve2.status\"", "declaredType=\"ContactStatus\""})
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  // Every output is unknown at the start, and no reference occurs twice.
  const auto count = [&](const char* pattern) {
    const std::regex one(pattern);
    return std::distance(std::sregex_iterator(text.begin(), text.end(), one), {});
  };
  EXPECT_GT(count("causality=\"output\""), 3);
  EXPECT_EQ(count("<Output valueReference"), count("causality=\"output\""));
  EXPECT_EQ(count("<InitialUnknown valueReference"), count("causality=\"output\""));
  EXPECT_EQ(count(" name=\"[^\"]*\" valueReference="), count(" causality="));
}

TEST_F(FmuExport, RefusesWhatCannotRun) {
  write("m.xml",
        "<dynamy version=\"1\"><systems><PointMass name=\"p\" mass=\"1\"/></systems></dynamy>");
  EXPECT_EQ(call("export fmu m.xml"), 2);
  EXPECT_NE(err().find("no <simulation> says how long"), std::string::npos) << err();
  EXPECT_FALSE(std::filesystem::exists(path("m.fmu")));
  EXPECT_EQ(call("export fmu " + model("woodpecker.xml") + " --signals toy.z"), 2);
  EXPECT_NE(err().find("no signal named \"toy.z\""), std::string::npos) << err();
}

TEST_F(FmuExport, TheWoodpeckerRunsAsInItsOwnRunWithEventsAtTheSameInstants) {
  unpack(model("woodpecker.xml"));
  ASSERT_EQ(call("run " + model("woodpecker.xml") + " --tolerance 1e-10 --quiet --out native"), 0)
      << err();
  std::set<double> native;
  const auto events = readCsv(readWholeFile(path("native/events.csv")));
  for (std::size_t i = 1; i < events.size(); ++i) native.insert(std::stod(events[i][0]));
  for (const char* mode : {"", " event"}) {
    const Printed fmu = printed(master(
        std::string("run until=3 h=1e-3 tolerance=1e-10 out=toy.y,toy.phiM,toy.phiS") + mode));
    ASSERT_EQ(fmu.rows.size(), 3001u);
    std::size_t k = 0;
    // The steps are those of the run; the instants between them differ by rounding, some 1e-16 s,
    // at up to 40 rad/s.
    for (const char* signal : {"toy.y", "toy.phiM", "toy.phiS"})
      EXPECT_LE(difference(fmu, ++k, recorded(path("native/signals.csv"), signal)), 1e-12)
          << signal << mode;
    if (*mode == '\0') continue;
    std::set<double> here(fmu.events.begin(), fmu.events.end());
    here.erase(here.begin());  // the statuses at the start, which the first step finds
    EXPECT_EQ(here, native);
    EXPECT_EQ(native.size(), 184u);
  }
}

const char* const kSame =
    "with a state taken: same\nvalues of the state: same\nset back: same\nin another instance: "
    "same\nfrom the start: same\n";

TEST_F(FmuExport, StatesAreSetBackBitForBit) {
  unpack(model("woodpecker.xml"));
  const std::string outputs = " out=toy.y,toy.phiM,toy.phiS,beak.Lambda_N,sleeve2.status";
  EXPECT_EQ(master("state until=1 h=0.00217" + outputs), kSame);
  EXPECT_EQ(master("state until=1 h=0.00217 event" + outputs), kSame);
}

/// models/cart_pid.xml with an input in place of its controller.
void writeCart(const std::string& file, const std::string& simulation) {
  std::string text = readWholeFile(std::string(DYNAMY_SOURCE_DIR) + "/models/cart_pid.xml");
  text = std::regex_replace(text, std::regex("<Pid [^>]*/>"), "<Input name=\"motor\"/>");
  text = std::regex_replace(text, std::regex("pid\\.out; 0; 0"), "motor.out; 0; 0");
  text = std::regex_replace(text, std::regex("<check [^>]*/>"), "");
  text = std::regex_replace(text, std::regex("<record [^>]*/>"), "");
  text = std::regex_replace(text, std::regex("<simulation [^>]*/>"), simulation);
  writeWholeFile(file, text);
}

TEST_F(FmuExport, AControllerOutsideDrivesTheCartAsItsBlocksDo) {
  for (const char* how : {"tolerance=\"1e-9\"", "step=\"4ms\""}) {
    const std::string simulation =
        std::string("<simulation until=\"6\" coordinates=\"minimal\" ") + how + "/>";
    writeCart(path("cart.xml"), simulation);
    unpack("cart.xml --signals cart.x cart.vx rod.phi motor.out");
    const std::string option =
        std::string(how).find("step") == 0 ? "--step 4ms" : "--tolerance 1e-9";
    // With fixed steps the checks of the model, of 1e-7, fail.
    call("run " + model("cart_pid.xml") + " --quiet --out native " + option);
    const Printed fmu = printed(master("pid until=6 h=0.01 out=cart.x,rod.phi"));
    ASSERT_EQ(fmu.rows.size(), 601u);
    // Steps end at the samples in both; what differs is the rounding of their lengths.
    EXPECT_LE(difference(fmu, 1, recorded(path("native/signals.csv"), "cart.x")), 1e-9) << how;
    EXPECT_LE(difference(fmu, 2, recorded(path("native/signals.csv"), "rod.phi")), 1e-9) << how;
    EXPECT_EQ(master("state until=1 h=0.013 in:motor=1.5 out=cart.x,rod.phi,motor.out"), kSame);
  }
}

TEST_F(FmuExport, ParametersAreSetBeforeTheRun) {
  write("ball.xml",
        R"(<dynamy version="1"><parameter name="h" value="1"/><parameter name="v" value="{2*h}"/>
  <systems><PointMass name="ball" position="0 0 {h}" velocity="{v} 0 0" mass="1"/></systems>
  <forces><Gravity acceleration="0 0 -10"/></forces>
  <simulation until="1" step="0.01"/><record signals="ball.x ball.z"/></dynamy>)");
  unpack("ball.xml");
  const auto end = [&](const std::string& words) {
    return printed(master("run until=0.4 h=0.1 out=ball.x,ball.z " + words)).rows.back();
  };
  // The midpoint rule is exact for a parabola; 40 steps round.
  EXPECT_NEAR(end("")[1], 0.8, 1e-14);
  EXPECT_NEAR(end("set:h=2")[2], 2.0 - 0.8, 1e-14);
  EXPECT_NEAR(end("set:h=2")[1], 4.0 * 0.4, 1e-14);          // v follows from h
  EXPECT_NEAR(end("set:h=2 set:v=2")[1], 4.0 * 0.4, 1e-14);  // so it does with its start value
  EXPECT_NEAR(end("set:h=2 set:v=1")[1], 0.4, 1e-14);
}

TEST_F(FmuExport, FixedStepsEndAtInstantsThatAreNoMultiples) {
  write("ball.xml", R"(<dynamy version="1">
  <systems><PointMass name="ball" position="0 0 1" mass="1"/></systems>
  <forces><Gravity acceleration="0 0 -10"/></forces>
  <simulation until="1" step="0.01"/><record signals="ball.z"/></dynamy>)");
  unpack("ball.xml");
  const Printed fmu = printed(master("run until=0.4 h=0.0033 out=ball.z"));
  for (const auto& row : fmu.rows)
    EXPECT_NEAR(row[1], 1.0 - 5.0 * row[0] * row[0], 1e-14) << row[0];
}

TEST_F(FmuExport, ImpactsInEventModeShowBothSides) {
  write("ball.xml", R"(<dynamy version="1">
  <systems><Coordinates name="ball" q="z" units="m" q0="1.25" M="1" potential="10*z"/></systems>
  <elements><CoordinateContact name="floor" on="ball" gap="z"><Unilateral epsilonN="0.5"/></CoordinateContact></elements>
  <simulation until="1" tolerance="1e-8"/><record signals="ball.z ball.z_dot"/></dynamy>)");
  unpack("ball.xml");
  const Printed fmu = printed(master("run until=1 h=0.3 event out=ball.z_dot"));
  ASSERT_EQ(fmu.events.size(), 1u);
  EXPECT_NEAR(fmu.events[0], 0.5, 1e-8);  // of 1.25 m with 10 m/s²
  // Without early return the event is told at the end of the step.
  const Printed late = printed(master("run until=1 h=0.3 event late out=ball.z_dot"));
  ASSERT_EQ(late.events.size(), 1u);
  EXPECT_NEAR(late.events[0], 0.6, 1e-14);
  EXPECT_NEAR(late.rows.at(2)[1], 2.5 - 1.0, 1e-7);
}

}  // namespace
}  // namespace dynamy
