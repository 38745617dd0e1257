// The element Fmu: controllers of other programs in a model.
#include <cmath>
#include <cstdlib>
#include <dynamy/io/files/csv.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

class FmuImport : public ProgramTest {
 protected:
  int shell(const std::string& command) const {
    const std::string line = "cd '" + folder_.string() + "' && " + command + " > out 2> err";
    return WEXITSTATUS(std::system(line.c_str()));
  }
  /// Column `name` of the signals of a run.
  std::vector<double> column(const std::string& run, const std::string& name) const {
    const auto table = readCsv(readWholeFile(path(run + "/signals.csv")));
    const auto at = static_cast<std::size_t>(std::find(table.at(0).begin(), table[0].end(), name) -
                                             table[0].begin());
    std::vector<double> out;
    for (std::size_t i = 1; i < table.size(); ++i) out.push_back(std::stod(table[i].at(at)));
    return out;
  }
  double difference(const std::string& name) const {
    const std::vector<double> a = column("fmu", name), b = column("native", name);
    if (a.size() != b.size()) return INFINITY;
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
    return worst;
  }
  /// The FMU 2.0 of tests/fmu as controller.fmu; `description`: its last attributes.
  void packController(const std::string& kind = "CoSimulation") const {
    write("modelDescription.xml",
          R"(<fmiModelDescription fmiVersion="2.0" modelName="c" guid="{7}"><)" + kind +
              R"( modelIdentifier="fmi2_controller"/>
<DefaultExperiment stepSize="0.01"/><ModelVariables>
<ScalarVariable name="e" valueReference="0" causality="input"><Real start="0"/></ScalarVariable>
<ScalarVariable name="kp" valueReference="1" causality="parameter"><Real start="1"/></ScalarVariable>
<ScalarVariable name="ki" valueReference="2" causality="parameter"><Real start="0"/></ScalarVariable>
<ScalarVariable name="u" valueReference="3" causality="output"><Real/></ScalarVariable>
<ScalarVariable name="on" valueReference="4" causality="input"><Boolean start="true"/></ScalarVariable>
<ScalarVariable name="count" valueReference="5" causality="output"><Integer/></ScalarVariable>
<ScalarVariable name="running" valueReference="6" causality="output"><Boolean/></ScalarVariable>
</ModelVariables></fmiModelDescription>)");
    ASSERT_EQ(shell("mkdir -p binaries/linux64 && cp '" + std::string(DYNAMY_BINARY_DIR) +
                    "/lib/tests/fmi2_controller.so' binaries/linux64 && '" DYNAMY_CMAKE
                    "' -E tar cf controller.fmu --format=zip modelDescription.xml binaries"),
              0)
        << err();
  }
  void writeCart(const std::string& fmu, const std::string& settings,
                 const std::string& force = "{c.u}") const {
    write("cart.xml", R"(<dynamy version="1"><plugin library="fmu"/>
  <systems><PointMass name="cart" position="0 0 0" mass="2"/></systems>
  <forces>
    )" + fmu + R"(
    <ForceInput on="cart" force=")" +
                          force + R"(; 0; 0"/>
  </forces>
  )" + settings + R"(<record signals="cart.x c.*" every="10ms"/></dynamy>)");
  }
};

constexpr const char* kTolerance = R"(<simulation until="2" tolerance="1e-10"/>)";

TEST_F(FmuImport, IsTheControllerThatWasExported) {
  write("pid.xml", R"(<dynamy version="1"><parameter name="kp" value="10"/>
  <systems><PointMass name="nothing" mass="1"/></systems>
  <forces><Input name="e"/><Pid name="pid" error="e.out" kp="{kp}" ki="20" kd="15" period="10ms"
    lower="-20" upper="20"/></forces>
  <simulation until="3" tolerance="1e-10"/><record signals="pid.out pid.integral"/></dynamy>)");
  ASSERT_EQ(call("export fmu pid.xml"), 0) << err();
  for (const char* settings : {kTolerance, R"(<simulation until="2" step="4ms"/>)"}) {
    writeCart(
        R"(<Fmu name="c" file="pid.fmu" inputs="e" values="1 - cart.x" parameters="kp=40" period="10ms"/>)",
        settings, "{c.pid.out}");
    ASSERT_EQ(call("run cart.xml --quiet --out fmu --trust"), 0) << err();
    write("native.xml", R"(<dynamy version="1">
  <systems><PointMass name="cart" position="0 0 0" mass="2"/></systems>
  <forces><Pid name="c" error="1 - cart.x" kp="40" ki="20" kd="15" period="10ms" lower="-20" upper="20"/>
    <ForceInput on="cart" force="c.out; 0; 0"/></forces>)" +
                            std::string(settings) +
                            R"(<record signals="cart.x c.*" every="10ms"/></dynamy>)");
    ASSERT_EQ(call("run native.xml --quiet --out native"), 0) << err();
    // Both sample at the same instants; the error e takes one rounding on its way.
    EXPECT_LE(difference("cart.x"), 1e-13) << settings;
    EXPECT_LE(difference("c.out"), 1e-11) << settings;
    // It writes its state, so that a run can be continued, and another one begins anew.
    ASSERT_EQ(call("run cart.xml --quiet --out half --trust --until 1"), 0) << err();
    ASSERT_EQ(call("resume half --until 2 --quiet --trust"), 0) << err();
    const std::vector<double> whole = column("fmu", "cart.x"), resumed = column("half", "cart.x");
    EXPECT_NEAR(resumed.back(), whole.back(), 1e-13) << settings;
  }
  // An FMU with another content is not that of the run.
  ASSERT_EQ(call("run cart.xml --quiet --out half --trust --until 1"), 0) << err();
  ASSERT_EQ(call("export fmu pid.xml --set kp=11"), 0) << err();
  EXPECT_EQ(call("resume half --until 2 --quiet --trust"), 2);
  EXPECT_NE(err().find("is not what the run was made with"), std::string::npos) << err();
}

TEST_F(FmuImport, TravelsInTheFmuOfItsModel) {
  packController();
  writeCart(
      R"(<Fmu name="c" file="controller.fmu" inputs="e" values="1 - cart.x" parameters="kp=40"/>)",
      kTolerance);
  ASSERT_EQ(call("run cart.xml --quiet --out fmu --trust"), 0) << err();
  ASSERT_EQ(call("export fmu cart.xml --trust -o whole.fmu --signals cart.x"), 0) << err();
  ASSERT_EQ(shell("mkdir whole && cd whole && '" DYNAMY_CMAKE "' -E tar xf ../whole.fmu"), 0);
  ASSERT_EQ(shell("'" + std::string(DYNAMY_BINARY_DIR) +
                  "/bin/fmu_master' whole run until=0.5 h=0.01 out=cart.x | tail -n 1"),
            0)
      << err();
  // The last line: t and the signal; row 50 of the run is that instant.
  EXPECT_NEAR(std::stod(out().substr(out().find(' '))), column("fmu", "cart.x").at(50), 1e-12)
      << out();
}

TEST_F(FmuImport, TakesFmi2AndNumbersOfOtherTypes) {
  packController();
  writeCart(
      R"(<Fmu name="c" file="controller.fmu" inputs="e on" values="1 - cart.x; t &lt; 1.5" parameters="kp=40 ki=20"/>)",
      kTolerance);
  ASSERT_EQ(call("run cart.xml --quiet --out fmu --trust"), 0) << err();
  // Its steps end at the samples: I_k = I_{k−1} + ki e_{k−1} T.
  const std::vector<double> x = column("fmu", "cart.x"), u = column("fmu", "c.u"),
                            on = column("fmu", "c.running"), count = column("fmu", "c.count");
  double I = 0.0, place = 0.0, speed = 0.0;
  for (int k = 0; k <= 200; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (k > 0) I += 20.0 * 0.01 * (1.0 - x[i - 1]);
    const bool runs = k < 150;
    const double expected = runs ? 40.0 * (1.0 - x[i]) + I : 0.0;
    // The motion by its closed form; rounding of 200 samples.
    EXPECT_NEAR(x[i], place, 1e-11) << k;
    EXPECT_NEAR(u[i], expected, 1e-9) << k;
    EXPECT_EQ(on[i], runs ? 1.0 : 0.0) << k;
    EXPECT_EQ(count[i], k) << k;
    place += 0.01 * speed + 0.5 * 1e-4 * expected / 2.0, speed += 0.01 * expected / 2.0;
  }
}

TEST_F(FmuImport, SaysWhatAnFmuDoesNotHave) {
  packController();
  const auto refused = [&](const std::string& attributes, const std::string& text,
                           const std::string& options = "--trust") {
    writeCart("<Fmu name=\"c\" " + attributes + "/>", kTolerance);
    EXPECT_EQ(call("check cart.xml " + options), 2) << attributes;
    EXPECT_NE(err().find(text), std::string::npos) << attributes << '\n' << err();
  };
  refused(R"(file="controller.fmu")", "comes with the model; its code runs only if you trust it",
          "");
  refused(R"(file="controller.fmu" inputs="e oh" values="1; 2")", "the FMU has no input \"oh\"");
  refused(R"(file="controller.fmu" inputs="e oh" values="1; 2")", "did you mean \"on\"?");
  refused(R"(file="controller.fmu" parameters="kq=2")", "the FMU has no parameter \"kq\"");
  refused(R"(file="controller.fmu" parameters="kp")", "as in kp=40 ki=10");
  refused(R"(file="controller.fmo")", "there is no such file");
  refused(R"(file="modelDescription.xml")", "it is no archive (zip)");
  packController("ModelExchange");
  refused(R"(file="controller.fmu")", "it is not for co-simulation");
}

TEST_F(FmuImport, SaysWhyASampleFails) {
  packController();
  writeCart(R"(<Fmu name="c" file="controller.fmu" inputs="e" values="t &gt; 0.5 ? 2000 : 0"/>)",
            kTolerance);
  EXPECT_NE(call("run cart.xml --out fmu --trust"), 0);
  EXPECT_NE((out() + err()).find("fmi2DoStep failed: e is 2000"), std::string::npos)
      << out() << err();
}

}  // namespace
}  // namespace dynamy
