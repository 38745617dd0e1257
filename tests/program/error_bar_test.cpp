/// dynamy run --error-bar: what a second run says about the first, for people, in run.json and on
/// the page of dynamy report.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/io/files/json_reader.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

class ErrorBar : public ProgramTest {
 protected:
  JsonValue facts() const { return readJson(readWholeFile(path("o/run.json")), "run.json"); }
};

/// x'' = −x, x(0) = 1 m.
std::string oscillator(const std::string& how) {
  return "<dynamy version=\"1\"><systems><Coordinates name=\"m\" q=\"x\" q0=\"1\" units=\"m\" "
         "M=\"1\" potential=\"x^2/2\"/></systems><simulation until=\"10\" " +
         how +
         "/><record signals=\"m.x m.x_dot\" every=\"0.1\"/>"
         "<check signal=\"m.x\" value=\"{cos(10)}\" tolerance=\"1e-2\"/></dynamy>\n";
}

TEST_F(ErrorBar, OfEveryRecordedSignalIsTheChangeAtATenthOfTheTolerance) {
  write("m.xml", oscillator("tolerance=\"1e-4\""));
  ASSERT_EQ(call("run m.xml --error-bar --out o"), 0) << err();
  EXPECT_NE(out().find("error bars by a run with a tenth of the tolerance, 1e-05"),
            std::string::npos)
      << out();
  const JsonValue bars = facts()["errorBars"];
  EXPECT_DOUBLE_EQ(bars["tolerance"].value, 1e-5);
  ASSERT_EQ(bars["signals"].items.size(), 2u);
  ASSERT_EQ(call("run m.xml --tolerance 1e-5 --out second"), 0) << err();
  const JsonValue second = readJson(readWholeFile(path("second/run.json")), "run.json");
  const double end = second["checks"].items[0]["got"].value, truth = std::cos(10.0);
  for (const JsonValue& s : bars["signals"].items) EXPECT_GE(s["largest"].value, s["bar"].value);
  const JsonValue& x = bars["signals"].items[0];
  EXPECT_EQ(x["name"].text, "m.x");
  EXPECT_EQ(x["bar"].value, std::abs(x["end"].value - end));
  // It is the error of the first run up to that of the second; the rounding of cos 10.
  EXPECT_GT(std::abs(x["end"].value - truth), 1e-9);
  EXPECT_NEAR(x["bar"].value, std::abs(x["end"].value - truth), std::abs(end - truth) + 1e-15);
  ASSERT_EQ(bars["checks"].items.size(), 1u);
  // Twice the change.
  EXPECT_NEAR(bars["checks"].items[0]["bar"].value, 2.0 * bars["signals"].items[0]["bar"].value,
              1e-12);
  EXPECT_FALSE(bars["chaotic"].flag);
  EXPECT_EQ(bars["horizon"].type, JsonValue::Type::null);
  ASSERT_EQ(call("report o"), 0) << err();
  const std::string page = readWholeFile(path("o/report.html"));
  EXPECT_NE(page.find("<h2>Error bars</h2>"), std::string::npos);
  EXPECT_NE(page.find("scheme, tolerance"), std::string::npos);
}

TEST_F(ErrorBar, OfAFixedStepHalvesIt) {
  write("m.xml", oscillator("step=\"1e-2\""));
  ASSERT_EQ(call("run m.xml --error-bar --json --out o"), 0) << err();
  EXPECT_EQ(out(), readWholeFile(path("o/run.json")));
  EXPECT_EQ(facts()["errorBars"]["step"].value, 5e-3);
}

TEST_F(ErrorBar, SaysWhereAChaoticMotionIsLost) {
  // A double pendulum that goes over the top.
  write("b.xml", R"xml(<dynamy version="1">
  <systems><Coordinates name="p" q="a b" units="rad rad" q0="{pi/2} {pi/2}" u0="6 0"
    kineticEnergy="a_dot^2 + b_dot^2/2 + a_dot*b_dot*cos(a - b)"
    potential="-9.81*(2*cos(a) + cos(b))"/></systems>
  <simulation until="20" tolerance="1e-8"/><record signals="p.a_dot p.b_dot" every="20ms"/></dynamy>
)xml");
  ASSERT_EQ(call("run b.xml --error-bar --out o"), 0) << err();
  const JsonValue bars = facts()["errorBars"];
  EXPECT_TRUE(bars["chaotic"].flag);
  ASSERT_EQ(bars["horizon"].type, JsonValue::Type::number);
  EXPECT_LT(bars["horizon"].value, 20.0);
  EXPECT_NE(out().find("the motion is chaotic"), std::string::npos) << out();
  EXPECT_NE(out().find("beyond, no figure of a single motion means anything"), std::string::npos);
  ASSERT_EQ(call("report o"), 0) << err();
  const std::string page = readWholeFile(path("o/report.html"));
  for (const char* text : {"switches located, accumulations passed", "finding switches",
                           "steps that were too long", "the motion is chaotic", "is lost at t = "})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace dynamy
