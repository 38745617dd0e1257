#include <dynamy/io/xml/xml.hpp>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace dynamy {
namespace {

XmlDocument parse(std::string text) { return XmlDocument::parse(std::move(text), "m.xml"); }

std::string errorOf(std::string text) {
  try {
    parse(std::move(text));
  } catch (const ModelError& error) {
    return error.what();
  }
  return "no error";
}

std::string readError(const std::filesystem::path& file) {
  try {
    XmlDocument::read(file);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "no error";
}

Place place(int line, int column, int length) { return {"m.xml", line, column, length}; }

void expectPlace(const Place& actual, int line, int column, int length) {
  EXPECT_EQ(actual.format() + " length " + std::to_string(actual.length),
            place(line, column, length).format() + " length " + std::to_string(length));
}

/// A folder for the files of one test, removed at its end.
class XmlFile : public ::testing::Test {
 protected:
  XmlFile()
      : folder_(std::filesystem::temp_directory_path() /
                ("dynamy_xml_test_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~XmlFile() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::filesystem::path folder_;
};

// Content.

TEST(XmlTree, HoldsTagsAttributesTextsAndChildrenInOrder) {
  const XmlDocument document = parse(
      "<?xml version=\"1.0\"?>\n<!-- a model -->\n"
      "<a x='1' y=\"2\"><b/>text<c>more</c></a>\n");
  const XmlNode& root = document.root();
  EXPECT_EQ(root.tag, "a");
  ASSERT_EQ(root.attributes.size(), 2u);
  EXPECT_EQ(root.attributes[0].name, "x");
  EXPECT_EQ(root.attributes[1].value, "2");
  ASSERT_EQ(root.children.size(), 2u);
  EXPECT_EQ(root.children[1].tag, "c");
  EXPECT_EQ(root.children[1].text, "more");
  EXPECT_EQ(root.text, "text");
  EXPECT_EQ(root.attribute("y")->value, "2");
  EXPECT_EQ(root.attribute("z"), nullptr);
}

TEST(XmlTree, LabelsANodeByItsName) {
  EXPECT_EQ(parse("<Ball/>").root().label(), "Ball");
  EXPECT_EQ(parse("<Ball x=\"1\" name=\"b\"/>").root().label(), "Ball name=\"b\"");
}

TEST(XmlTree, DecodesEntitiesAndLineEnds) {
  const XmlDocument document = parse("<a v=\"&lt;&#176;&#xB0;&amp;\r\n&quot;\">1 &gt; 0</a>");
  EXPECT_EQ(document.root().attributes[0].value, "<°°&\n\"");
  EXPECT_EQ(document.root().text, "1 > 0");
}

TEST(XmlTree, JoinsTextAroundCommentsAndCdata) {
  EXPECT_EQ(parse("<a>\n one<!-- x --> two<![CDATA[ <3> ]]>\n</a>").root().text, "one two <3>");
  EXPECT_EQ(parse("<a>  \n <!-- x --> </a>").root().text, "");
}

// Places.

TEST(XmlPlace, GivesLineColumnAndLengthOfElementsNamesAndValues) {
  const XmlDocument document = parse("<a>\n  <Sphere radius=\"0.1\" mass='2'/>\n</a>");
  const XmlNode& sphere = document.root().children[0];
  expectPlace(sphere.place, 2, 3, 7);
  expectPlace(sphere.attributes[0].namePlace, 2, 11, 6);
  expectPlace(sphere.attributes[0].valuePlace, 2, 19, 3);
  expectPlace(sphere.attributes[1].namePlace, 2, 24, 4);
  expectPlace(sphere.attributes[1].valuePlace, 2, 30, 1);
}

TEST(XmlPlace, CountsTabsAndUtf8AsOneColumn) {
  const XmlDocument document = parse("<a>\n\t<b näme=\"µ = ½\" x=\"1\"/></a>");
  const XmlNode& b = document.root().children[0];
  expectPlace(b.place, 2, 2, 2);
  expectPlace(b.attributes[0].namePlace, 2, 5, 4);
  expectPlace(b.attributes[0].valuePlace, 2, 11, 5);
  expectPlace(b.attributes[1].valuePlace, 2, 21, 1);
  expectPlace(document.at(b.attributes[0], 5, 2), 2, 15, 1);  // ½, bytes 5 and 6
}

TEST(XmlPlace, OfAByteInsideOfACharacterIsTheCharacter) {
  const XmlDocument document = parse("<a v=\"球x\"/>");
  const XmlAttribute& v = document.root().attributes[0];
  for (std::size_t byte = 0; byte < 3; ++byte) expectPlace(document.at(v, byte, 1), 1, 7, 1);
  expectPlace(document.at(v, 2, 2), 1, 7, 2);
}

TEST(XmlPlace, IsTheSameWithWindowsLineEndsAndAByteOrderMark) {
  const XmlDocument document =
      parse("\xEF\xBB\xBF<a p=\"1\">\r\n  <b\r\n    x=\"2\"/>\r\n</a>\r\n");
  expectPlace(document.root().place, 1, 1, 2);
  expectPlace(document.root().attributes[0].namePlace, 1, 4, 1);
  expectPlace(document.root().children[0].place, 2, 3, 2);
  expectPlace(document.root().children[0].attributes[0].valuePlace, 3, 8, 1);
  EXPECT_EQ(document.sourceLine(1), "<a p=\"1\">");
  EXPECT_EQ(document.sourceLine(3), "    x=\"2\"/>");
  EXPECT_EQ(document.sourceLine(5), "");
  EXPECT_EQ(document.sourceLine(0), "");
}

TEST(XmlPlace, FollowsAValueOverSeveralLines) {
  const XmlDocument document = parse("<a v=\"0 0\n    {h}\r\n 1\"/>");
  const XmlAttribute& v = document.root().attributes[0];
  EXPECT_EQ(v.value, "0 0\n    {h}\n 1");
  expectPlace(v.valuePlace, 1, 7, 3);
  expectPlace(document.at(v, v.value.find("{h}"), 3), 2, 5, 3);
  expectPlace(document.at(v, v.value.find('1'), 1), 3, 2, 1);
}

TEST(XmlPlace, MapsAnOffsetBehindEntitiesBackToTheFile) {
  const XmlDocument document = parse("<a v=\"{x &lt; y} &#xB0;bad\"/>");
  const XmlAttribute& v = document.root().attributes[0];
  EXPECT_EQ(v.value, "{x < y} °bad");
  expectPlace(document.at(v, v.value.find('<'), 1), 1, 10, 4);  // all of &lt;
  expectPlace(document.at(v, v.value.find('y'), 1), 1, 15, 1);
  expectPlace(document.at(v, v.value.find("bad"), 3), 1, 24, 3);
  expectPlace(document.at(v, 999, 5), 1, 27, 1);  // cut at the end of the value
}

TEST(XmlPlace, FindsTheTextBehindWhiteSpaceCommentsAndCdata) {
  const XmlDocument document = parse("<a>\n  one &amp; two <!-- c -->three<![CDATA[ 4&5]]>\n</a>");
  const XmlNode& a = document.root();
  EXPECT_EQ(a.text, "one & two three 4&5");
  expectPlace(a.textPlace, 2, 3, 13);
  expectPlace(document.at(a, a.text.find("two"), 3), 2, 13, 3);
  expectPlace(document.at(a, a.text.find("three"), 5), 2, 27, 5);
  expectPlace(document.at(a, a.text.find("4&5"), 3), 2, 42, 3);
}

TEST(XmlPlace, GivesTheElementIfThereIsNoText) {
  const XmlDocument document = parse("<a> <b/></a>");
  EXPECT_EQ(document.root().textPlace.line, 0);
  expectPlace(document.at(document.root(), 0, 1), 1, 1, 2);
}

TEST(XmlDiagnostic, ShowsThePartOfAValueThatIsWrong) {
  const XmlDocument document = parse("<a>\n\t<Sphere name=\"s\" center=\"0 0 {h+}\"/>\n</a>");
  const XmlNode& sphere = document.root().children[0];
  const XmlAttribute& center = *sphere.attribute("center");
  const XmlWord word = xmlWords(center.value)[2];
  EXPECT_EQ(document
                .diagnostic(document.at(center, word.offset, word.text.size()), sphere,
                            "a term is missing", "after \"+\"")
                .format(),
            "m.xml:2:31: error: <Sphere name=\"s\">: a term is missing — after \"+\"\n"
            "    2 | \t<Sphere name=\"s\" center=\"0 0 {h+}\"/>\n"
            "      | \t                             ^~~~");
}

// Errors: each message with its place, word by word.

TEST(XmlError, NamesBothPlacesOfAMismatchedTag) {
  EXPECT_EQ(errorOf("<a>\n  <b>\n  </a>\n"),
            "m.xml:3:3: error: <b>: expected </b>, found </a> — a tag without children "
            "ends with \"/>\"\n    3 |   </a>\n      |   ^~~\n"
            "m.xml:2:3: note: <b> is opened here\n    2 |   <b>\n      |   ^~");
}

TEST(XmlError, ShowsAnElementThatIsNotClosed) {
  EXPECT_EQ(
      errorOf("<a>\n  <b x=\"1\">\n"),
      "m.xml:2:3: error: <b>: the element is not closed — expected </b> before the end of the "
      "file\n    2 |   <b x=\"1\">\n      |   ^~");
  EXPECT_EQ(errorOf("<a/></b>"),
            "m.xml:1:5: error: <b>: </b> closes nothing\n    1 | <a/></b>\n      |     ^~~");
}

TEST(XmlError, ShowsATagWithoutItsEnd) {
  EXPECT_EQ(errorOf("<a x=\"1\"\n<b/>"),
            "m.xml:1:1: error: <a>: the tag has no \">\"\n    1 | <a x=\"1\"\n      | ^~");
  EXPECT_EQ(errorOf("<a></a"),
            "m.xml:1:4: error: <a>: the closing tag has no \">\"\n    1 | <a></a\n      |    ^~~");
  EXPECT_EQ(errorOf("<a>< b/></a>"),
            "m.xml:1:4: error: <a>: no name follows \"<\" — a tag has no blank there, <b; in a "
            "text \"<\" is written &lt;\n"
            "    1 | <a>< b/></a>\n      |    ^");
}

TEST(XmlError, ShowsAllDoubledAttributesWithTheFirst) {
  EXPECT_EQ(errorOf("<a x=\"1\" x=\"2\">\n<b y=\"1\" z=\"\" y=\"2\"/></a>"),
            "m.xml:1:10: error: <a>: the attribute \"x\" is given twice\n"
            "    1 | <a x=\"1\" x=\"2\">\n      |          ^\n"
            "m.xml:1:4: note: the first is here\n    1 | <a x=\"1\" x=\"2\">\n      |    ^\n"
            "m.xml:2:15: error: <b>: the attribute \"y\" is given twice\n"
            "    2 | <b y=\"1\" z=\"\" y=\"2\"/></a>\n      |               ^\n"
            "m.xml:2:4: note: the first is here\n"
            "    2 | <b y=\"1\" z=\"\" y=\"2\"/></a>\n      |    ^");
}

TEST(XmlError, ShowsAMissingQuote) {
  EXPECT_EQ(errorOf("<a mass=1/>"),
            "m.xml:1:9: error: <a>: the value of \"mass\" is not in quotes — write mass=\"1\"\n"
            "    1 | <a mass=1/>\n      |         ^");
  EXPECT_EQ(
      errorOf("<a mass=\"1/>\n<b x=\"2\"/>"),
      "m.xml:1:9: error: <a>: the value of \"mass\" has no closing quote — in a value \"<\" is "
      "written &lt;\n    1 | <a mass=\"1/>\n      |         ^~~~");
  EXPECT_EQ(errorOf("<a mass=\"1 size=\"2\"/>"),
            "m.xml:1:9: error: <a>: the value of \"mass\" has no closing quote — write mass=\"1\"\n"
            "    1 | <a mass=\"1 size=\"2\"/>\n      |         ^~~~~~~");
  EXPECT_EQ(errorOf("<a mass=\"1"),
            "m.xml:1:9: error: <a>: the value of \"mass\" has no closing quote — write mass=\"1\"\n"
            "    1 | <a mass=\"1\n      |         ^~");
}

TEST(XmlError, ShowsAnAttributeWithoutValueSpaceOrName) {
  EXPECT_EQ(errorOf("<a fixed/>"),
            "m.xml:1:4: error: <a>: the attribute \"fixed\" has no value — write fixed=\"…\"\n"
            "    1 | <a fixed/>\n      |    ^~~~~");
  EXPECT_EQ(errorOf("<a x=\"1\"y=\"2\"/>"),
            "m.xml:1:9: error: <a>: expected a space after the value of \"x\"\n"
            "    1 | <a x=\"1\"y=\"2\"/>\n      |         ^");
  EXPECT_EQ(errorOf("<a 1x=\"1\"/>"),
            "m.xml:1:4: error: <a>: unexpected character \"1\" — an attribute is written "
            "name=\"value\"\n    1 | <a 1x=\"1\"/>\n      |    ^");
}

TEST(XmlError, ShowsUnknownEntities) {
  EXPECT_EQ(errorOf("<a v=\"&deg;\">x & y</a>"),
            "m.xml:1:7: error: <a>: unknown entity \"&deg;\" — known are &lt; &gt; &amp; &quot; "
            "&apos; &#number; and a plain & is written &amp;\n"
            "    1 | <a v=\"&deg;\">x & y</a>\n      |       ^~~~~\n"
            "m.xml:1:16: error: <a>: no entity begins at this \"&\" — known are &lt; &gt; &amp; "
            "&quot; &apos; &#number; and a plain & is written &amp;\n"
            "    1 | <a v=\"&deg;\">x & y</a>\n      |                ^");
  EXPECT_NE(errorOf("<a v=\"&#0;&#xD800;&#x110000;\"/>").find("unknown entity \"&#0;\""),
            std::string::npos);
}

TEST(XmlError, ShowsWhatStandsOutsideOfTheRoot) {
  EXPECT_EQ(
      errorOf("<a/>\n<b/>"),
      "m.xml:2:1: error: <b>: second root element — a file has one root element\n"
      "    2 | <b/>\n      | ^~\nm.xml:1:1: note: <a> is the first\n    1 | <a/>\n      | ^~");
  EXPECT_EQ(errorOf("hello <a/>"),
            "m.xml:1:1: error: text before the first element — a model is an XML file and begins "
            "with <dynamy version=\"1\">\n    1 | hello <a/>\n      | ^~~~~~");
  EXPECT_EQ(errorOf("<a/> end"),
            "m.xml:1:6: error: text after the end of the root element — an element was closed too "
            "early, or twice\n"
            "    1 | <a/> end\n      |      ^~~");
  EXPECT_EQ(errorOf("<!-- only -->"), "m.xml: error: there is no element in it");
  EXPECT_EQ(errorOf("<a><?x?></a>"),
            "m.xml:1:4: error: <a>: <? ?> is allowed only before the first element\n"
            "    1 | <a><?x?></a>\n      |    ^~");
}

TEST(XmlError, ShowsCommentsAndSectionsThatAreNotClosed) {
  EXPECT_EQ(errorOf("<a><!-- x </a>"),
            "m.xml:1:4: error: <a>: the comment is not closed by -->\n"
            "    1 | <a><!-- x </a>\n      |    ^~~~");
  EXPECT_EQ(errorOf("<a><![CDATA[ x </a>"),
            "m.xml:1:4: error: <a>: the CDATA section is not closed by ]]>\n"
            "    1 | <a><![CDATA[ x </a>\n      |    ^~~~~~~~~");
}

TEST(XmlError, RefusesDocumentTypes) {
  EXPECT_EQ(errorOf("<!DOCTYPE a [<!ENTITY b \"c\">]><a/>"),
            "m.xml:1:1: error: document types and their entities are not read — remove the "
            "declaration\n    1 | <!DOCTYPE a [<!ENTITY b \"c\">]><a/>\n      | ^~");
}

TEST(XmlError, RefusesWhatIsNoText) {
  EXPECT_EQ(errorOf(""), "m.xml: error: the file is empty");
  EXPECT_EQ(errorOf(" \n\t"), "m.xml: error: the file is empty");
  EXPECT_EQ(
      errorOf(std::string("\x7f"
                          "ELF\0\1",
                          6)),
      "m.xml: error: the file is a program or a library (ELF), no text — a text file is needed");
  EXPECT_EQ(errorOf("<a x=\"\xe9\"/>"),
            "m.xml:1:7: error: the byte 0xE9 is no UTF-8 — store the file as UTF-8\n"
            "    1 | <a x=\"\uFFFD\"/>\n      |       ^");
  EXPECT_EQ(errorOf(std::string("\xff\xfe<\0a\0", 6)),
            "m.xml: error: the text is UTF-16 — store the file as UTF-8");
}

TEST(XmlError, RefusesNestingWithoutEnd) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_EQ(errorOf(deep).substr(0, 71),
            "m.xml:1:193: error: <a>: elements are nested deeper than 64\n    1 | …");
}

// Files.

TEST_F(XmlFile, IsReadWithItsPathInPlaces) {
  const std::filesystem::path file = write("ball.xml", "<a>\n<b/></a>");
  const XmlDocument document = XmlDocument::read(file);
  EXPECT_EQ(document.root().children[0].place.format(), file.string() + ":2:1");
  EXPECT_EQ(document.name(), file.string());
}

TEST_F(XmlFile, ThatIsMissingIsSaidWithANearName) {
  write("bouncing_ball.xml", "<a/>");
  const std::string near = (folder_ / "bouncing_ball.xml").string();
  const std::string typo = (folder_ / "bouncing_bal.xml").string();
  EXPECT_EQ(readError(typo),
            typo + ": error: there is no such file — did you mean \"" + near + "\"?");
  EXPECT_EQ(readError(folder_ / "none" / "x.xml"),
            (folder_ / "none" / "x.xml").string() +
                ": error: there is no such file — there is no folder " +
                (folder_ / "none").string());
}

TEST_F(XmlFile, MustBeARegularFile) {
  EXPECT_EQ(readError(folder_),
            folder_.string() + ": error: this is a folder, not a file — no XML file is in it");
  EXPECT_EQ(readError("/dev/null"), "/dev/null: error: this is no regular file");
}

TEST_F(XmlFile, MustNotBeEmpty) {
  const std::string file = write("empty.xml", "").string();
  EXPECT_EQ(readError(file), file + ": error: the file is empty");
}

// Helpers.

TEST(XmlWords, AreSeparatedByWhiteSpaceWithTheirOffsets) {
  const auto words = xmlWords(" 0  0.5\n{h0 + 0.1}\t");
  ASSERT_EQ(words.size(), 3u);
  EXPECT_EQ(words[0].text, "0");
  EXPECT_EQ(words[0].offset, 1u);
  EXPECT_EQ(words[1].text, "0.5");
  EXPECT_EQ(words[1].offset, 4u);
  EXPECT_EQ(words[2].text, "{h0 + 0.1}");
  EXPECT_EQ(words[2].offset, 8u);
  EXPECT_TRUE(words[2].balanced);
  EXPECT_TRUE(xmlWords("").empty());
  EXPECT_TRUE(xmlWords(" \n").empty());
}

TEST(XmlWords, KeepSuffixesAndNestedBracesTogether) {
  const auto words = xmlWords("{2 * {a b}}mm 5mm");
  ASSERT_EQ(words.size(), 2u);
  EXPECT_EQ(words[0].text, "{2 * {a b}}mm");
  EXPECT_EQ(words[1].text, "5mm");
}

TEST(XmlWords, TellBracesWithoutPartner) {
  EXPECT_FALSE(xmlWords("{a b")[0].balanced);
  EXPECT_EQ(xmlWords("{a b")[0].text, "{a b");
  EXPECT_FALSE(xmlWords("a} b")[0].balanced);
  EXPECT_TRUE(xmlWords("a} b")[1].balanced);
}

TEST(XmlEscape, GivesBackWhatWasWritten) {
  const std::string text = "a<b & \"c\" > 'd'\t\n\r°";
  EXPECT_EQ(escapeXmlText("<&>\"'"), "&lt;&amp;&gt;\"'");
  EXPECT_EQ(escapeXmlValue("\"'\n"), "&quot;&apos;&#10;");
  EXPECT_EQ(escapeXmlText(std::string_view("\0\x1b", 2)), "\uFFFD\uFFFD");
  const XmlDocument document =
      parse("<a v=\"" + escapeXmlValue(text) + "\">" + escapeXmlText("x" + text) + "</a>");
  EXPECT_EQ(document.root().attributes[0].value, text);
  EXPECT_EQ(document.root().text, "x" + text);
}

}  // namespace
}  // namespace dynamy
