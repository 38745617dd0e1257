/// The tables of words of other programs (core/other_words) name what exists: elements, their
/// attributes, units.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/core/expression/expression_functions.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/io/xml/vocabulary.hpp>
#include <map>
#include <regex>
#include <set>
#include <sstream>

extern "C" const dynamy::PluginInfo* dynamy_plugin_info();

namespace dynamy {
namespace {

/// Elements and words of the file with the names of their attributes.
std::map<std::string, std::set<std::string>> vocabulary() {
  Registry registry;
  registerFramework(registry);
  dynamy_plugin_info()->registerElements(registry);
  std::map<std::string, std::set<std::string>> out;
  const auto take = [&](const std::string& name, const Attributes& attributes) {
    out[name].insert("name");
    for (const Attribute& a : attributes.list()) out[name].insert(a.name);
  };
  for (const RegisteredType* t : registry.types()) take(t->name, t->attributes);
  const Vocabulary words;
  for (const Word& w : words.words()) take(w.name, w.attributes);
  return out;
}

std::vector<std::string> split(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

/// Checks every <Element attribute="…"> and every other attribute="…" of a hint.
void expectKnown(const std::string& hint) {
  static const auto known = vocabulary();
  static const std::regex tag("</?([A-Za-z]+)([^<>]*)>"), attribute("([A-Za-z]+)=\"");
  std::string rest = hint;
  for (std::smatch m; std::regex_search(rest, m, tag); rest = m.prefix().str() + m.suffix().str()) {
    const std::string name = m[1], inside = m[2];
    ASSERT_TRUE(known.contains(name)) << hint;
    for (std::sregex_iterator i(inside.begin(), inside.end(), attribute), end; i != end; ++i)
      EXPECT_TRUE(known.at(name).contains((*i)[1])) << hint;
  }
  for (std::sregex_iterator i(rest.begin(), rest.end(), attribute), end; i != end; ++i)
    EXPECT_TRUE(std::any_of(known.begin(), known.end(), [&](const auto& k) {
      return k.second.contains((*i)[1]);
    })) << hint;
}

TEST(OtherWords, NameElementsThatExist) {
  for (const OtherWord& row : otherElements()) {
    EXPECT_NE(row.hint.find('<'), std::string_view::npos) << row.hint;
    expectKnown(std::string(row.hint));
  }
}

TEST(OtherWords, NameAttributesThatExist) {
  const auto known = vocabulary();
  for (const OtherWord& row : otherAttributes()) {
    expectKnown(std::string(row.hint));
    expectKnown(std::string(row.elsewhere));
    EXPECT_FALSE(row.ours.empty() && row.elsewhere.empty()) << row.words;
    for (const std::string& name : split(row.ours))
      EXPECT_TRUE(std::any_of(known.begin(), known.end(),
                              [&](const auto& k) { return k.second.contains(name); }))
          << name << " of " << row.words;
  }
}

TEST(OtherWords, AreFoundByTheLastWordOfAName) {
  EXPECT_EQ(elementByLastWord("RotationalMotor"), elementOfOthers("motor"));
  EXPECT_EQ(elementByLastWord("linear_spring_damper"), elementOfOthers("damper"));
  EXPECT_EQ(elementByLastWord("Europe"), "");  // no word begins with "rope"
}

TEST(OtherWords, NameUnitsThatExist) {
  for (const OtherWord& row : otherUnits()) {
    EXPECT_TRUE(row.ours.empty() || parseUnitSuffix(row.ours)) << row.ours;
    EXPECT_NE(row.ours.empty(), row.hint.empty()) << row.words;
    if (!row.ours.empty()) continue;
    const std::string amount = amountInOurs(split(row.words)[0]);
    EXPECT_NE(parseQuantity(amount).family, UnitFamily::none) << row.words << ": " << amount;
  }
  EXPECT_EQ(unitOfOthers("degrees/sec"), "deg/s");
  EXPECT_EQ(unitInOurs("in"), "1in is 0.0254m");
}

TEST(OtherWords, NameFunctionsThatExistOrAnExpression) {
  SymbolTable symbols;
  for (const char* name : {"condition", "a", "b", "x"}) symbols.variable(name);
  for (const OtherWord& row : otherFunctions()) {
    for (const std::string& word : split(row.words)) EXPECT_EQ(findFunction(word), nullptr) << word;
    if (findFunction(row.ours) != nullptr) continue;
    EXPECT_NO_THROW(Expression::compile(row.ours, symbols)) << row.ours;
  }
  EXPECT_EQ(functionOfOthers("LN"), "log");
  EXPECT_EQ(functionOfOthers("frobnicate"), "");
}

TEST(OtherWords, AreNoWordsOfOursAndStandInOneRow) {
  const auto known = vocabulary();
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
  };
  std::set<std::string> names, seen;
  for (const auto& entry : known) names.insert(lower(entry.first));
  names.erase("integrator");  // a block here, a scheme to others
  for (const OtherWord& row : otherElements())
    for (const std::string& word : split(row.words)) {
      // Within a name of ours the case decides, and that is reported first.
      EXPECT_FALSE(names.contains(word)) << word;
      EXPECT_TRUE(seen.insert(word).second) << word << " stands twice";
      EXPECT_EQ(word, lower(word));
    }
  EXPECT_GE(seen.size(), 40u);
}

TEST(OtherWords, AnAttributeIsThatOfTheElementAtHand) {
  const std::vector<std::string> law{"mu", "epsilonN"}, sphere{"radius", "mass"};
  EXPECT_EQ(attributeOfOthers("friction_coefficient", law).name, "mu");
  EXPECT_EQ(attributeOfOthers("friction", law).hint,
            "in dynamY the coefficient of friction is mu=\"…\"");
  EXPECT_EQ(attributeOfOthers("friction", sphere).name, "");
  EXPECT_EQ(attributeOfOthers("friction", sphere).hint,
            "in dynamY friction belongs to the law of two materials, <UnilateralCoulomb mu=\"…\">, "
            "or is a "
            "law inside of a joint, <GivenFriction force=\"…\">");
  EXPECT_EQ(attributeOfOthers("colour", law).hint,
            "in dynamY a colour belongs to a shape: <Sphere colour=\"…\">");
  EXPECT_EQ(attributeOfOthers("shininess", law).hint, "");
}

}  // namespace
}  // namespace dynamy
