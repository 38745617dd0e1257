#include <gtest/gtest.h>

#include <dynamy/core/declared/parameters.hpp>

#include <numbers>
#include <stdexcept>

namespace dynamy {
namespace {

/// Fault of a given text for a declaration: text, or "" if it is right.
std::string faultOf(const Attribute& a, const std::string& text) {
  ParameterValue v;
  v.declaration = &a;
  v.text = text;
  v.given = true;
  const auto fault = readValue(a, v);
  if (!fault) return {};
  return fault->hint.empty() ? fault->text : fault->text + " — " + fault->hint;
}

double numberOf(const Attribute& a, const std::string& text) {
  ParameterValue v;
  v.declaration = &a;
  v.text = text;
  v.given = true;
  EXPECT_FALSE(readValue(a, v));
  return v.numbers.at(0);
}

TEST(ReadValue, ReadsNumbersWithSuffixesAsSi) {
  Attributes a;
  EXPECT_EQ(numberOf(a.required("l", Unit::length, ""), "5mm"), 5 * 1e-3);
  EXPECT_EQ(numberOf(a.required("l", Unit::length, ""), "-2.5e-1"), -0.25);
  EXPECT_EQ(numberOf(a.required("phi", Unit::angle, ""), "180deg"), std::numbers::pi);
  EXPECT_EQ(numberOf(a.required("x", Unit::any, ""), "5mm"), 5 * 1e-3);
}

TEST(ReadValue, SaysWhichUnitItExpects) {
  Attributes a;
  EXPECT_EQ(faultOf(a.required("l", Unit::length, ""), "30deg"), "expects a length [m], has [rad]");
  EXPECT_EQ(faultOf(a.required("M", Unit::torque, ""), "3J"), "expects a torque [N m], has [J]");
  EXPECT_EQ(faultOf(a.required("n", Unit::none, ""), "3kg"),
            "expects a number without unit, has [kg]");
}

TEST(ReadValue, SaysTheRangeAndTheValue) {
  Attributes a;
  EXPECT_EQ(faultOf(a.required("m", Unit::mass, "").positive(), "-1"), "must be > 0, is -1");
  EXPECT_EQ(faultOf(a.required("m", Unit::mass, "").positive(), "0"), "must be > 0, is 0");
  EXPECT_EQ(faultOf(a.required("mu", Unit::none, "").nonNegative(), "-0.3"),
            "must be >= 0, is -0.3");
  EXPECT_EQ(faultOf(a.required("e", Unit::none, "").between(0, 1), "1.5"),
            "must be between 0 and 1, is 1.5");
  EXPECT_EQ(faultOf(a.required("n", Unit::none, "").atLeast(2), "1"), "must be >= 2, is 1");
  EXPECT_EQ(faultOf(a.required("m", Unit::mass, "").positive(), "nan"), "must be a number, is nan");
}

TEST(ReadValue, SaysTheSizeOfAVector) {
  Attributes a;
  EXPECT_EQ(faultOf(a.requiredVector("r", Unit::length, 3, ""), "0 1"), "expects 3 numbers, has 2");
  EXPECT_EQ(faultOf(a.requiredVector("r", Unit::length, 3, ""), ""), "expects 3 numbers, has none");
  EXPECT_EQ(faultOf(a.required("r", Unit::length, ""), "0 1"), "expects 1 number, has 2");
  EXPECT_EQ(faultOf(a.requiredVector("r", Unit::length, 0, ""), "0 1 2 3 4"), "");
}

TEST(ReadValue, RefusesAZeroVectorWhereOneMustNotVanish) {
  Attributes a;
  const Attribute& q = a.vector("orientation", Unit::none, 4, "1 0 0 0", "").notZero();
  EXPECT_EQ(faultOf(q, "0 0 0 0"), "must not be zero");
  EXPECT_EQ(faultOf(q, "0 0 0 2"), "");
}

TEST(ReadValue, PointsAtTheFaultyPart) {
  Attributes a;
  const Attribute& r = a.requiredVector("r", Unit::length, 3, "");
  ParameterValue v;
  v.declaration = &r;
  v.given = true;
  v.text = "0 30deg 1";
  const auto fault = readValue(r, v);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->offset, 2u);
  EXPECT_EQ(fault->length, 5u);
}

TEST(ReadValue, KnowsWholeNumbersFlagsAndWords) {
  Attributes a;
  EXPECT_EQ(faultOf(a.add(AttributeType::integer, "n", std::nullopt, ""), "2.5"),
            "expects a whole number, is 2.5");
  EXPECT_EQ(faultOf(a.add(AttributeType::flag, "f", std::nullopt, ""), "yes"),
            "expects true or false, is \"yes\"");
  EXPECT_EQ(faultOf(a.choice("w", {"stop", "warn"}, "warn", ""), "stopp"),
            "expects one of \"stop\", \"warn\", is \"stopp\" — did you mean \"stop\"?");
  EXPECT_EQ(faultOf(a.choice("w", {"stop", "warn"}, "warn", ""), "ignore"),
            "expects one of \"stop\", \"warn\", is \"ignore\"");
}

/// An element with one attribute of each kind that matters here.
struct Thing final : Element {
  static constexpr Kind kKind = Kind::system;
  static void declare(Attributes& a) {
    a.required("mass", Unit::mass, "mass of the thing").positive();
    a.vector("position", Unit::length, 3, "0 0 1", "where it is");
    a.add(AttributeType::integer, "count", "2", "how many");
    a.add(AttributeType::flag, "fixed", "false", "does it move");
    a.add(AttributeType::expressions, "T", std::nullopt, "formulas").mayBeAbsent();
  }
  explicit Thing(const Parameters& x) : Element(x) {}
};

/// All messages of a C++ model's faults, or "".
std::string faultsOf(const std::vector<GivenValue>& given) {
  try {
    Parameters::of<Thing>("Thing", "a", given);
  } catch (const ModelError& e) {
    return e.what();
  }
  return {};
}

TEST(Parameters, GivenInCppConvertToWhatIsDeclared) {
  const Parameters x = Parameters::of<Thing>(
      "Thing", "a", {{"mass", 0.1}, {"position", {1.0, 2.0, 1.0 / 3.0}}, {"fixed", "true"}});
  EXPECT_EQ(double(x["mass"]), 0.1);
  EXPECT_EQ(x["position"].vec3(), Vec3(1, 2, 1.0 / 3.0));
  EXPECT_EQ(x["count"].integer(), 2);
  EXPECT_TRUE(x["fixed"].flag());
  EXPECT_TRUE(x.has("count"));
  EXPECT_FALSE(x.has("T"));
  EXPECT_FALSE(x.has("nothing"));
  EXPECT_THROW(x["nothing"], std::logic_error);
  EXPECT_THROW((void)x["mass"].integer(), std::logic_error);
  const Thing thing(x);
  EXPECT_EQ(thing.name(), "a");
  EXPECT_EQ(thing.type(), "Thing");
}

TEST(Parameters, TellAllFaultsOfACppModelAtOnce) {
  EXPECT_EQ(
      faultsOf({{"mas", 1.0}, {"position", {1.0, 2.0}}, {"count", 1.5}}),
      "error: <Thing name=\"a\">: unknown attribute \"mas\" — did you mean \"mass\"?\n"
      "error: <Thing name=\"a\">: missing attribute \"mass\" — mass of the thing\n"
      "error: <Thing name=\"a\">: position=\"1 2\": expects 3 numbers, has 2 — where it is [m]\n"
      "error: <Thing name=\"a\">: count=\"1.5\": expects a whole number, is 1.5");
  EXPECT_EQ(faultsOf({{"mass", 1.0}, {"mass", 2.0}}),
            "error: <Thing name=\"a\">: attribute \"mass\" is given twice");
}

TEST(Parameters, SplitWordsAndFormulas) {
  const Parameters x =
      Parameters::of<Thing>("Thing", "a", {{"mass", 1.0}, {"T", " sin(x) ;  y; "}});
  const auto parts = x["T"].parts(';');
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].text, "sin(x)");
  EXPECT_EQ(parts[1].text, "y");
  EXPECT_EQ(parts[1].offset, 11u);
  EXPECT_EQ(parts[2].text, "");
  EXPECT_EQ(x["T"].words(), (std::vector<std::string>{"sin(x)", ";", "y;"}));
}

TEST(Parameters, AValueWithoutFileNamesItsAttributeInAFault) {
  const Parameters x = Parameters::of<Thing>("Thing", "a", {{"mass", 1.0}, {"T", "sin(x"}});
  EXPECT_STREQ(x["T"].fault("expected \")\"", "", 5, 0).what(),
               "error: T=\"sin(x\": expected \")\"");
}

}  // namespace
}  // namespace dynamy
