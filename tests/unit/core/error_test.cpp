#include <gtest/gtest.h>

#include <dynamy/core/error.hpp>
#include <dynamy/core/utf8.hpp>

#include <algorithm>

namespace dynamy {
namespace {

Diagnostic misspelt() {
  return {.place = {"models/bad.xml", 7, 9, 6},
          .element = "Sphere",
          .text = "unknown attribute \"raduis\"",
          .hint = didYouMean("radius"),
          .sourceLine = "<Sphere raduis=\"0.1\"/>"};
}

TEST(Diagnostic, ShowsPlaceElementTextHintLineAndCaret) {
  EXPECT_EQ(misspelt().format(),
            "models/bad.xml:7:9: error: <Sphere>: unknown attribute \"raduis\" — did you mean "
            "\"radius\"?\n"
            "    7 | <Sphere raduis=\"0.1\"/>\n"
            "      |         ^~~~~~");
}

TEST(Diagnostic, LeavesOutWhatIsUnknown) {
  EXPECT_EQ((Diagnostic{.text = "no systems"}.format()), "error: no systems");
  EXPECT_EQ((Diagnostic{.place = {"a.xml"}, .text = "is empty"}.format()),
            "a.xml: error: is empty");
  EXPECT_EQ((Diagnostic{.place = {"a.xml", 3}, .text = "x", .sourceLine = "<a>"}.format()),
            "a.xml:3: error: x\n    3 | <a>");
}

TEST(Diagnostic, KeepsTabsSoThatTheCaretIsAligned) {
  Diagnostic d{.place = {"a.xml", 1, 4, 2}, .text = "x", .sourceLine = "\ta\tbc"};
  EXPECT_EQ(d.format(), "a.xml:1:4: error: x\n    1 | \ta\tbc\n      | \t \t^~");
}

TEST(Diagnostic, CountsCharactersNotBytes) {
  Diagnostic d{.place = {"a.xml", 1, 4, 2}, .text = "x", .sourceLine = "µεα bc"};
  d.place.column = columnOf(d.sourceLine, d.sourceLine.find("bc"));
  EXPECT_EQ(d.place.column, 5);
  EXPECT_EQ(d.format(), "a.xml:1:5: error: x\n    1 | µεα bc\n      |     ^~");
}

TEST(Diagnostic, GivesWideCharactersTwoColumnsAndCombiningMarksNone) {
  Diagnostic wide{.place = {"a", 1, 2, 1}, .text = "x", .sourceLine = "球b"};
  EXPECT_EQ(wide.format(), "a:1:2: error: x\n    1 | 球b\n      |   ^");
  Diagnostic mark{.place = {"a", 1, 3, 1}, .text = "x", .sourceLine = "e\u0301b"};
  EXPECT_EQ(mark.format(), "a:1:3: error: x\n    1 | e\u0301b\n      |  ^");
}

TEST(Diagnostic, ShowsAPlaceAtTheEndOfTheLine) {
  Diagnostic d{.place = {"a", 1, 4, 5}, .text = "x", .sourceLine = "<a>"};
  EXPECT_EQ(d.format(), "a:1:4: error: x\n    1 | <a>\n      |    ^");
}

TEST(Diagnostic, ShowsAWindowOfALongLine) {
  Diagnostic d{.place = {"a", 1, 1001, 3},
               .text = "x",
               .sourceLine = std::string(1000, 'a') + "bad" + std::string(1000, 'c')};
  EXPECT_EQ(d.format(), "a:1:1001: error: x\n    1 | …" + std::string(100, 'a') + "bad" +
                            std::string(57, 'c') + "…\n      |  " + std::string(100, ' ') + "^~~");
}

TEST(Diagnostic, ReplacesBytesThatATerminalCannotShow) {
  Diagnostic d{.place = {"a", 1, 3, 1}, .text = "x", .sourceLine = "\x1b\xff!"};
  EXPECT_EQ(d.format(), "a:1:3: error: x\n    1 | \uFFFD\uFFFD!\n      |   ^");
}

TEST(Diagnostic, ShowsNotesWithTheirOwnPlace) {
  Diagnostic d{.place = {"a.xml", 9, 7}, .text = "second \"b\"", .sourceLine = "<A name=\"b\"/>"};
  d.notes.push_back({{"a.xml", 2, 7, 1}, "the first is here", "<B name=\"b\"/>"});
  EXPECT_EQ(d.format(),
            "a.xml:9:7: error: second \"b\"\n    9 | <A name=\"b\"/>\n      |       ^\n"
            "a.xml:2:7: note: the first is here\n    2 | <B name=\"b\"/>\n      |       ^");
}

TEST(ModelError, CarriesItsDiagnosticsAndTheirText) {
  const ModelError error({misspelt(), Diagnostic{.text = "no systems"}});
  EXPECT_EQ(error.diagnostics().size(), 2u);
  EXPECT_EQ(std::string(error.what()), misspelt().format() + "\nerror: no systems");
  EXPECT_STREQ(ModelError("no systems", "add one").what(), "error: no systems — add one");
}

TEST(ModelError, TellsOnlyTheNumberOfErrorsAfterTheFirstHundred) {
  const std::string text = ModelError(std::vector<Diagnostic>(103, {.text = "bad"})).what();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 100);
  EXPECT_TRUE(text.ends_with("\n… and 3 more errors")) << text;
}

TEST(Diagnostics, ThrowsAllErrorsSortedByPlaceEachOnce) {
  Diagnostics all;
  EXPECT_NO_THROW(all.throwIfAny());
  all.add({.place = {"b.xml", 5, 1}, .text = "third"});
  all.add({.place = {"a.xml", 1, 1}, .text = "fourth"});
  all.add({.place = {"b.xml", 2, 9}, .text = "second"});
  all.add({.place = {"b.xml", 2, 3}, .text = "first"});
  all.add(ModelError(Diagnostic{.place = {"b.xml", 5, 1}, .text = "third"}));
  try {
    all.throwIfAny();
    FAIL() << "nothing thrown";
  } catch (const ModelError& error) {
    EXPECT_STREQ(error.what(),
                 "b.xml:2:3: error: first\nb.xml:2:9: error: second\nb.xml:5:1: error: third\n"
                 "a.xml:1:1: error: fourth");
  }
}

TEST(Expects, ThrowsTheConditionWithThePlaceOfTheCall) {
  EXPECT_NO_THROW(expects(true, "dt is positive"));
  const int line = __LINE__ + 2;
  try {
    expects(false, "dt is positive");
    FAIL() << "nothing thrown";
  } catch (const std::logic_error& error) {
    const std::string text = error.what();
    const std::string place =
        "error_test.cpp:" + std::to_string(line) + ": expected: dt is positive (in '";
    EXPECT_NE(text.find(place), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace dynamy
