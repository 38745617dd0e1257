/// Limits of reading, each told by name, and reading that takes time and memory in proportion to
/// the size of the text: what these models cost before is said beside each.
#include <gtest/gtest.h>

#include <fstream>
#include <unit/io/files/scratch_folder.hpp>
#include <unit/io/model/load_text.hpp>

namespace dynamy {
namespace {

using namespace dummy;

std::vector<Diagnostic> faults(const std::string& text, const fs::path& folder = ".") {
  try {
    load(text, {}, folder);
  } catch (const ModelError& e) {
    return e.diagnostics();
  }
  return {};
}

std::string repeated(const std::string& text, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += text;
  return out;
}

TEST(Limits, AChainOfParametersMayBeAsLongAsItLikes) {  // before: the stack overran
  std::string chain = "<parameter name=\"p0\" value=\"2\"/>";
  for (int i = 20000; i > 0; --i)
    chain += "<parameter name=\"p" + std::to_string(i) + "\" value=\"{p" + std::to_string(i - 1) +
             "}\"/>";
  const Model m =
      load(around(chain + "<systems><Ball name=\"b\" mass=\"1\" z=\"{p20000}\"/></systems>"));
  EXPECT_EQ(m.initialState().q[0], 2.0);
}

TEST(Limits, ACircleOfParametersIsToldOnce) {
  std::string circle = "<parameter name=\"p0\" value=\"{p999}\"/>";
  for (int i = 1; i < 1000; ++i)
    circle += "\n<parameter name=\"p" + std::to_string(i) + "\" value=\"{p" +
              std::to_string(i - 1) + "}\"/>";
  const std::vector<Diagnostic> all = faults(around(circle));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].text,
            "the parameter \"p1\" depends on itself: p0 → … → p8 → p7 → p6 → p5 → p4 → p3 → p2 → "
            "p1 → p0");
}

TEST(Limits, ReadingEndsAfterAThousandErrors) {  // before: 20 000 copies of one line, gigabytes
  const std::vector<Diagnostic> all =
      faults(inSystems(repeated("<Ball mass=\"1\" a=\"0\"/>", 20000)));
  ASSERT_EQ(all.size(), kMostErrors + 1);
  EXPECT_EQ(all.front().place.format(), "m.xml:2:25");
  EXPECT_EQ(all[999].place.format(), "m.xml:2:" + std::to_string(25 + 999 * 22));
  EXPECT_EQ(all[999].sourceLine, "");  // a line of 440 kB is no help
  EXPECT_EQ(all.back().text, "reading ends after so many errors");
  const std::string entities = around("<doc>" + repeated("&a;", 20000) + "</doc>");
  EXPECT_EQ(faults(entities).size(), kMostErrors + 1);
}

TEST(Limits, ErrorsThatRepeatInEveryTurnEndTheReading) {
  const std::vector<Diagnostic> all = faults(inSystems(
      "<replicate count=\"90000\"><Ball mass=\"1\" a=\"0\"/><Ball mass=\"-1\"/></replicate>"));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.back().text, "reading ends after so many errors");
}

TEST(Limits, AttributesOfOneElementAreCounted) {  // before: compared in pairs
  std::string many = "<Ball";
  for (int i = 0; i < 20000; ++i) many += " a" + std::to_string(i) + "=\"\"";
  const std::vector<Diagnostic> all = faults(inSystems(many + "/>"));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].text, "the element has more than 256 attributes");
  EXPECT_EQ(all[0].place.line, 2);
}

TEST(Limits, ManyParametersInManyTurnsAreNotCopied) {  // before: 10^7 names, a gigabyte
  std::string text;
  for (int i = 0; i < 1000; ++i)
    text += "<parameter name=\"p" + std::to_string(i) + "\" value=\"" + std::to_string(i) + "\"/>";
  text +=
      "<systems><replicate count=\"10000\" index=\"k\">"
      "<Ball name=\"b\" mass=\"1\" z=\"{p7 + k}\" drive=\"p9*t\"/></replicate></systems>";
  const Model m = load(around(text));
  ASSERT_EQ(m.systems().size(), 10000u);
  EXPECT_EQ(m.initialState().q[9999], 7.0 + 9999.0);
}

TEST(Limits, ElementsOfAllTurnsAreCounted) {
  const std::string ball = "<Ball name=\"b\" mass=\"1\"/>";
  const std::vector<Diagnostic> all =
      faults(inSystems("<replicate count=\"90000\">" + repeated(ball, 20) + "</replicate>"));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].text, "all replicates together make more than 1000000 elements");
  EXPECT_EQ(all[0].place.format(), "m.xml:2:28");
}

TEST(Limits, ListedSignalsAreCounted) {
  const std::vector<Diagnostic> all =
      faults(around("<systems><Ball name=\"b\" mass=\"1\"/></systems><record signals=\"" +
                    repeated("b.z ", 10001) + "\"/>"));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].text, "more than 10000 signals are listed");
}

class IncludeLimits : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& inside) const {
    std::ofstream(folder_ / name) << around(inside);
  }
  testing::ScratchFolder folder_;
};

TEST_F(IncludeLimits, FilesThatDoubleAreCounted) {  // before: 2^30 files, no end
  for (int i = 0; i < 30; ++i) {
    const std::string next = "<include file=\"inc_" + std::to_string(i + 1) + ".xml\"/>";
    write("inc_" + std::to_string(i) + ".xml", next + next);
  }
  write("inc_30.xml", "");
  const std::vector<Diagnostic> all =
      faults(around("<include file=\"inc_0.xml\"/>"), folder_.path());
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].text, "the model includes more than 1000 files");
  EXPECT_GT(all[0].place.line, 0);
}

TEST_F(IncludeLimits, TheDepthIsNoCircle) {
  for (int i = 0; i < 40; ++i)
    write("d" + std::to_string(i) + ".xml",
          "<include file=\"d" + std::to_string(i + 1) + ".xml\"/>");
  const std::vector<Diagnostic> all = faults(around("<include file=\"d0.xml\"/>"), folder_.path());
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].text, "files are included deeper than 32");
}

TEST(FiniteNumbers, AreAllThatAnAttributeTakes) {
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"inf\"/>")),
            "m.xml:2:22: error: <Ball>: mass must be finite, is inf");
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"1\" velocity=\"0 0 -inf\"/>")),
            "m.xml:2:39: error: <Ball>: velocity must be finite, is -inf");
  EXPECT_EQ(firstError(around("<simulation until=\"inf\"/>")),
            "m.xml:2:20: error: <simulation>: until must be finite, is inf");
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"1e308t\"/>")),
            "m.xml:2:22: error: <Ball>: mass the number 1e308t is out of range");
  EXPECT_EQ(firstError(around("<parameter name=\"p\" value=\"inf\"/>")),
            "m.xml:2:28: error: <parameter name=\"p\">: value must be finite, is inf");
}

TEST(FiniteNumbers, BoundsOfAChecksBandMayBeMissing) {
  const Model m = load(around(
      "<systems><Ball name=\"b\" mass=\"1\"/></systems><simulation until=\"1\" step=\"1e-3\"/>"
      "<check signal=\"b.z\" measure=\"min\" over=\"0.5 inf\" between=\"0 inf\"/>"));
  EXPECT_EQ(m.checks[0].high, std::numeric_limits<double>::infinity());
}

TEST(FiniteNumbers, AreDemandedOfASetFromOutside) {
  const std::string text = around("<parameter name=\"p\" value=\"1\"/>");
  EXPECT_EQ(errors(text, {{"p", "inf"}}), "error: --set p=inf: must be finite, is inf");
  EXPECT_EQ(errors(text, {{"p", "nan"}}), "error: --set p=nan: must be a number, is nan");
}

}  // namespace
}  // namespace dynamy
