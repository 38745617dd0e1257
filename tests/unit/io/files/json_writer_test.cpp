#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <dynamy/io/files/json_writer.hpp>
#include <limits>
#include <vector>

namespace dynamy {
namespace {

template <class T>
std::string jsonOf(const T& x) {
  std::string text;
  JsonWriter(text).value(x);
  return text;
}

TEST(JsonWriter, PutsCommasAndColonsWhereTheyBelong) {
  std::string text;
  JsonWriter json(text);
  json.beginObject().member("a", 1).key("b").beginArray().value(2).value("c").beginObject();
  json.endObject().endArray().key("d").values(std::vector{0.5, 2.0}).member("e", true).endObject();
  EXPECT_EQ(text, R"({"a":1,"b":[2,"c",{}],"d":[0.5,2],"e":true})");
}

TEST(JsonWriter, IndentsObjectsAndKeepsListsOfNumbersOnOneLine) {
  std::string text;
  JsonWriter json(text, 2);
  json.beginObject().key("v").values(std::vector{1, 2}).key("list").beginArray();
  json.beginObject().member("n", 1).endObject().beginObject().member("n", 2).endObject();
  json.endArray().endObject();
  EXPECT_EQ(text,
            "{\n  \"v\": [1, 2],\n  \"list\": [\n    {\n      \"n\": 1\n    },\n"
            "    {\n      \"n\": 2\n    }\n  ]\n}");
}

TEST(JsonWriter, EscapesQuotesBackslashesAndControlCharacters) {
  EXPECT_EQ(jsonOf(std::string("a\"b\\c\n\t\r\x01\x1f", 10)), R"("a\"b\\c\n\t\r\u0001\u001f")");
  EXPECT_EQ(jsonOf(std::string("\0", 1)), R"("\u0000")");
}

TEST(JsonWriter, LeavesUtf8AsItIs) { EXPECT_EQ(jsonOf("μ = 0.3"), "\"μ = 0.3\""); }

TEST(JsonWriter, EscapesKeys) {
  std::string text;
  JsonWriter(text).beginObject().member("a\"b", 1).endObject();
  EXPECT_EQ(text, R"({"a\"b":1})");
}

TEST(JsonWriter, WritesNumbersThatAreNotFiniteAsNull) {
  EXPECT_EQ(jsonOf(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(jsonOf(-std::numeric_limits<double>::infinity()), "null");
}

TEST(JsonWriter, WritesTheShortestTextThatReadsBackTheSame) {
  EXPECT_EQ(jsonOf(0.1), "0.1");
  EXPECT_EQ(jsonOf(1e300), "1e+300");
  EXPECT_EQ(jsonOf(-0.0), "-0");
  for (const double x : {1.0 / 3.0, 5e-324, 1.7976931348623157e308, 123456789.123456789}) {
    EXPECT_EQ(std::strtod(jsonOf(x).c_str(), nullptr), x);
  }
}

TEST(JsonWriter, WritesTheLargestIntegers) {
  EXPECT_EQ(jsonOf(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  EXPECT_EQ(jsonOf(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

}  // namespace
}  // namespace dynamy
