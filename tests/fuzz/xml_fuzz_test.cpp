/// Mutated models: whatever the text, reading it gives a tree or a ModelError, and in a tree every
/// place leads back to the text. The seed is printed; DYNAMY_SEED repeats a run.

#include <dynamy/core/utf8.hpp>
#include <dynamy/io/xml/xml.hpp>

#include <gtest/gtest.h>

#include <fuzz/chosen_seed.hpp>
#include <random>
#include <string>

namespace dynamy {
namespace {

constexpr const char* kXml = R"(<?xml version="1.0"?>
<dynamy version="1">
  <doc>Ball &amp; floor: µ = 0.3, <!-- a comment --> h &lt; 2 <![CDATA[ a<b ]]></doc>
  <parameter name="e" value="0.8" min="0" max="0.999"/>
  <systems>
	<RigidBody name="ball" position="0 0 {h0 + 0.1}" velocity='0 0 0'>
      <Sphere radius="0.1"
              mass = "1kg"/>
    </RigidBody>
    <Ground name="world"><HalfSpace name="fløor" normal="0 0 1" material="concrete"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 &#45;9.81"/></forces>
</dynamy>
)";

class XmlMutator {
 public:
  explicit XmlMutator(unsigned seed) : random_(seed) {}

  std::string mutate(std::string text) {
    const std::size_t count = below(2) + 1;
    for (std::size_t i = 0; i < count; ++i) mutateOnce(text);
    return text;
  }
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }

 private:
  void mutateOnce(std::string& text) {
    static const std::string pieces[] = {
        "<",    ">",      "/>",         "</",    "\"",      "'",           "&",
        "&#",   "&#x20;", "&#x110000;", "<!--",  "-->",     "<![CDATA[",   "]]>",
        "<?",   "?>",     "<!",         "{",     "}",       "=",           "\r\n",
        "\n\r", "\r",     "\t",         "\xff",  "\xc3",    "µ",           "\x01",
        " ",    "<a>",    "</a>",       "&amp;", "e=\"1\"", "\xEF\xBB\xBF"};
    const std::size_t at = below(text.size() + 1);
    const std::size_t other = below(text.size() + 1);
    const std::size_t size = below(12) + 1;
    switch (below(8)) {
      case 0:
        text.erase(at, size);
        break;
      case 1:
        text.insert(at, pieces[below(std::size(pieces))]);
        break;
      case 2:
        text.insert(at, std::string(text, other, 4 * size));
        break;
      case 3:
        text.resize(below(10) == 0 ? at : text.size());
        break;
      case 4:
        text.insert(at, 1, static_cast<char>(below(256)));
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(' ' + below(95));
    }
    if (text.empty()) text = "<";
  }

  std::mt19937 random_;
};

/// The place lies inside of the document.
void checkPlace(const XmlDocument& document, const Place& place) {
  ASSERT_GE(place.line, 1);
  ASSERT_GE(place.column, 1);
  ASSERT_GE(place.length, 1);
  // One behind the end is the place of an empty value or of a line end.
  ASSERT_LE(place.column, characterCount(document.sourceLine(place.line)) + 1);
}

/// The part of the source line at a place.
std::string textAt(const XmlDocument& document, const Place& place) {
  const std::string_view line = document.sourceLine(place.line);
  std::string result;
  int column = 1;
  for (std::size_t at = 0; at < line.size(); ++column) {
    const Utf8Character c = nextCharacter(line, at);
    if (column >= place.column && column < place.column + place.length) result += c.bytes;
    at += c.bytes.size();
  }
  return result;
}

void checkNode(const XmlDocument& document, const XmlNode& node) {
  ASSERT_EQ(textAt(document, node.place), "<" + node.tag);
  for (const XmlAttribute& attribute : node.attributes) {
    ASSERT_EQ(textAt(document, attribute.namePlace), attribute.name);
    checkPlace(document, attribute.valuePlace);
    for (std::size_t i = 0; i < attribute.value.size(); ++i) {
      // What is no entity and no line end stands in the file as it stands in the value.
      const Place place = document.at(attribute, i);
      checkPlace(document, place);
      const std::string found = textAt(document, place);
      const bool plain = !found.empty() && found[0] != '&' && attribute.value[i] != '\n' &&
                         static_cast<unsigned char>(attribute.value[i]) < 0x80;
      if (plain && found != "\r") {
        ASSERT_EQ(found, std::string(1, attribute.value[i]));
      }
    }
    for (const XmlWord& word : xmlWords(attribute.value))
      ASSERT_EQ(attribute.value.substr(word.offset, word.text.size()), word.text);
  }
  for (std::size_t i = 0; i < node.text.size(); ++i) checkPlace(document, document.at(node, i, 3));
  for (const XmlNode& child : node.children) checkNode(document, child);
}

TEST(XmlFuzz, GivesATreeWithTruePlacesOrAModelError) {
  const unsigned seed = fuzz::chosenSeed();
  std::printf("seed %u\n", seed);
  RecordProperty("seed", std::to_string(seed));
  XmlMutator mutator(seed);
  int trees = 0, errors = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = i == 0 ? kXml : mutator.mutate(kXml);
    SCOPED_TRACE("DYNAMY_SEED=" + std::to_string(seed) + ", input " + std::to_string(i) + ":\n" +
                 text);
    try {
      const XmlDocument document = XmlDocument::parse(text, "fuzz.xml");
      checkNode(document, document.root());
      ++trees;
    } catch (const ModelError& error) {
      ASSERT_NE(i, 0) << error.what();
      // Everything wrong is found by the scanner, which knows the column.
      ASSERT_FALSE(error.diagnostics().empty());
      for (const Diagnostic& d : error.diagnostics()) {
        ASSERT_EQ(d.text.find("the file is no XML"), std::string::npos) << error.what();
        ASSERT_EQ(d.text.find("read in two ways"), std::string::npos) << error.what();
        ASSERT_EQ(d.place.file, "fuzz.xml");
      }
      ++errors;
    }
    if (HasFatalFailure()) return;
  }
  // Both outcomes occur, else the mutations are too weak or too strong: about 30 % are trees, and
  // 100 of 2000 is far outside of the scatter of ±2 %.
  EXPECT_GT(trees, 100);
  EXPECT_GT(errors, 100);
  std::printf("%d trees, %d errors\n", trees, errors);
}

TEST(XmlFuzz, SurvivesRandomBytes) {
  const unsigned seed = fuzz::chosenSeed();
  std::printf("seed %u\n", seed);
  XmlMutator random(seed);
  for (int i = 0; i < 500; ++i) {
    std::string text(random.below(200) + 1, ' ');
    for (char& c : text) c = static_cast<char>(random.below(256));
    EXPECT_THROW(XmlDocument::parse(text, "fuzz.xml"), ModelError) << "DYNAMY_SEED=" << seed;
  }
}

}  // namespace
}  // namespace dynamy
