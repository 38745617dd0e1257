#include <gtest/gtest.h>

#include <dynamy/core/expression/expression.hpp>
#include <unit/io/model/load_text.hpp>

namespace dynamy {
namespace {

using namespace dummy;

TEST(ModelLoader, MakesElementsWithValuesAndPlaces) {
  const Model m = load(around(
      "<doc>A ball.</doc>"
      "<systems><Ball name=\"b\" mass=\"500g\" z=\"5mm\"><Disc radius=\"0.1\"/></Ball></systems>"
      "<forces><Weight/></forces>"
      "<elements><Stop on=\"b\"><Law mu=\"0.3\"/></Stop></elements>"));
  ASSERT_EQ(m.systems().size(), 1u);
  EXPECT_EQ(ball(m).name(), "b");
  EXPECT_EQ(ball(m).type(), "Ball");
  EXPECT_EQ(ball(m).place(), (Place("m.xml", 2, 28, 5)));
  EXPECT_EQ(ball(m).shapes.size(), 1u);
  EXPECT_EQ(m.initialState().q[0], 5 * 1e-3);
  EXPECT_EQ(m.forces().size(), 1u);
  EXPECT_EQ(stop(m).law->mu, 0.3);
  EXPECT_EQ(m.doc, "A ball.");
  EXPECT_EQ(m.title, "m");
  EXPECT_EQ(m.file.name, "m.xml");
}

TEST(ModelLoader, TakesSectionsInAnyOrderAndRepeated) {
  const Model m =
      load(around("<elements><Stop on=\"b\"><Law/></Stop></elements>"
                  "<systems><Ball name=\"a\" mass=\"{m}\"/></systems>"
                  "<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                  "<parameter name=\"m\" value=\"{2*n}\"/><parameter name=\"n\" value=\"3g\"/>"));
  EXPECT_EQ(m.systems().size(), 2u);
}

TEST(ModelLoader, EvaluatesExpressionsInNumbersVectorsAndFormulas) {
  const Model m = load(around(
      "<parameter name=\"n\" value=\"2\"/><systems><Ball name=\"b\" mass=\"{n + 1}kg\" z=\"{-n}\" "
      "velocity=\"0 {n} {3 * n}\" drive=\"1 - {0 - n}*t\"/></systems>"));
  EXPECT_EQ(m.initialState().q[0], -2.0);
  EXPECT_EQ(ball(m).drive, "1 - (-2)*t");
}

TEST(ModelLoader, ReadsSimulationRecordAndChecks) {
  const Model m =
      load(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                  "<simulation until=\"5\" step=\"1ms\" gTol=\"1e-9\" onNonConvergence=\"stop\"/>"
                  "<record signals=\"b.z b.*\" every=\"10ms\" frames=\"30Hz\" view=\"xz\"/>"
                  "<check signal=\"b.z\" at=\"4\" value=\"0.5\" tolerance=\"0.25\"/>"
                  "<check signal=\"b.vz\" measure=\"max\" over=\"1 5\" between=\"0.7 0.8\"/>"));
  EXPECT_EQ(m.simulation.until, 5.0);
  EXPECT_EQ(m.simulation.step, 1e-3);
  EXPECT_EQ(m.simulation.gTol, 1e-9);
  EXPECT_EQ(m.simulation.onNonConvergence, NonConvergence::stop);
  EXPECT_EQ(m.record.signals, (std::vector<std::string>{"b.z", "b.*"}));
  EXPECT_EQ(m.record.every, 10 * 1e-3);
  EXPECT_EQ(m.record.framesPerSecond, 30.0);
  EXPECT_EQ(m.view, "xz");
  ASSERT_EQ(m.checks.size(), 2u);
  EXPECT_EQ(m.checks[0].at, 4.0);
  EXPECT_EQ(m.checks[0].low, 0.25);
  EXPECT_EQ(m.checks[0].high, 0.75);
  EXPECT_EQ(m.checks[0].text, "0.5 ± 0.25");
  EXPECT_EQ(m.checks[1].measure, CheckSettings::Measure::max);
  EXPECT_EQ(m.checks[1].from, 1.0);
  EXPECT_EQ(m.checks[1].to, 5.0);
  EXPECT_EQ(m.checks[1].text, "0.7 … 0.8");
}

TEST(ModelLoader, DefaultsFillWhatAnElementLacks) {
  const Model m =
      load(around("<systems><Ball name=\"a\"/><Ball name=\"b\" class=\"high\"/>"
                  "<Ball name=\"c\" class=\"high\" z=\"9\"/></systems>"
                  "<defaults><Ball mass=\"1\" z=\"2\"/><Ball class=\"high\" z=\"{h}\"/></defaults>"
                  "<parameter name=\"h\" value=\"7\"/>"));
  EXPECT_EQ(m.initialState().q, Eigen::Vector3d(2, 7, 9));
}

TEST(ModelLoader, ReplicatesWithIndexAndNamesOfTheSameTurn) {
  const Model m = load(around(
      "<systems><replicate count=\"3\" index=\"k\"><Ball name=\"b\" mass=\"1\" z=\"{k/2}\"/>"
      "</replicate></systems>"
      "<elements><replicate count=\"2\"><Stop on=\"b\" frames=\"b.tip b[{i+1}]\"><Law/></Stop>"
      "</replicate></elements>"));
  ASSERT_EQ(m.systems().size(), 3u);
  EXPECT_EQ(ball(m, 2).name(), "b[2]");
  EXPECT_EQ(m.initialState().q, Eigen::Vector3d(0, 0.5, 1));
  ASSERT_EQ(m.contacts().size(), 2u);
  EXPECT_EQ(stop(m, 1).on, "b[1]");
  EXPECT_EQ(stop(m, 1).frames, "b[1].tip b[2]");
}

TEST(ModelLoader, GivesValuesThatComeBackTheBitsOfTheFirst) {
  // From the second turn on expressions are compiled. A power computed as a product would differ.
  const std::string z = "(k+1.1)^7*sin(0.3*k)+h*(k>3)-(k-k)/3";
  const Model m = load(
      around("<parameter name=\"h\" value=\"0.7\"/><systems><replicate count=\"20\" index=\"k\">"
             "<Ball name=\"b\" mass=\"1\" z=\"{" +
             z + "}\"/></replicate></systems>"));
  for (int k = 0; k < 20; ++k) {
    SymbolTable numbers;
    numbers.constant("h", 0.7), numbers.constant("k", k);
    // Written with 17 digits and read again: the same number.
    EXPECT_EQ(m.initialState().q[k], evaluateConstant(z, numbers)) << k;
  }
}

TEST(ModelLoader, TellsWhatIsWrongInALaterTurn) {
  const auto turns = [](const std::string& mass) {
    return errors(inSystems("<replicate count=\"4\"><Ball mass=\"" + mass + "\"/></replicate>"));
  };
  EXPECT_NE(turns("{1/(i-2)+2}").find("the expression has no finite value, is inf"),
            std::string::npos);
  EXPECT_NE(turns("{1.5-i}").find("mass"), std::string::npos);
  EXPECT_NE(turns("{i+1}}").find("\"}\" without \"{\""), std::string::npos);
}

TEST(ModelLoader, ReplicatesWholeSectionsAndInsideOfElements) {
  const Model m = load(around(
      "<replicate count=\"2\"><systems><replicate count=\"2\" index=\"j\">"
      "<Ball name=\"b\" mass=\"{1+i+j}\"><replicate count=\"3\"><Disc radius=\"1\"/></replicate>"
      "</Ball></replicate></systems></replicate>"));
  ASSERT_EQ(m.systems().size(), 4u);
  EXPECT_EQ(ball(m, 2).name(), "b[1][0]");
  EXPECT_EQ(ball(m, 2).shapes.size(), 3u);
}

TEST(ModelLoader, OverridesReplaceParameters) {
  const std::string text = around(
      "<parameter name=\"h\" value=\"1\" min=\"0\" max=\"{g}\"/><parameter name=\"g\" value=\"2\"/>"
      "<systems><Ball name=\"b\" mass=\"1\" z=\"{2*h}\"/></systems>");
  EXPECT_EQ(load(text).initialState().q[0], 2.0);
  EXPECT_EQ(load(text, {{"h", "500mm"}}).initialState().q[0], 1.0);
  EXPECT_EQ(errors(text, {{"h", "3"}}), "error: --set h=3: must be between 0 and 2, is 3");
  EXPECT_EQ(errors(text, {{"hh", "3"}}),
            "error: --set hh=3: no parameter \"hh\" — did you mean \"h\"?");
  EXPECT_EQ(errors(text, {{"h", "high"}}),
            "error: --set h=high: cannot be read: expected a number, found \"high\"");
}

}  // namespace
}  // namespace dynamy
