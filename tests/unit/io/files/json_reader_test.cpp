#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/files/json_writer.hpp>

namespace dynamy {
namespace {

std::string faultOf(const std::string& text) {
  try {
    readJson(text, "a.json");
  } catch (const FileError& e) {
    return e.what();
  }
  return "none";
}

TEST(JsonReader, ReadsWhatTheWriterWrites) {
  std::string text;
  JsonWriter json(text, 2);
  json.beginObject().member("a", 0.1).member("b", "µ \"\\\n\x01").member("c", true);
  json.key("d").beginArray().value(-3).value(std::nan("")).beginObject().endObject().endArray();
  json.key("e").beginArray().endArray().endObject();
  const JsonValue v = readJson(text, "a.json");
  EXPECT_EQ(v["a"].value, 0.1);
  EXPECT_EQ(v["b"].text, "µ \"\\\n\x01");
  EXPECT_TRUE(v["c"].flag);
  ASSERT_EQ(v["d"].items.size(), 3u);
  EXPECT_EQ(v["d"].items[0].value, -3.0);
  EXPECT_FALSE(v["d"].items[1]);
  EXPECT_EQ(v["d"].items[2].type, JsonValue::Type::object);
  EXPECT_EQ(v["e"].type, JsonValue::Type::array);
}

TEST(JsonReader, WhatIsNotThereIsNull) {
  const JsonValue v = readJson("{\"a\": {}}", "a.json");
  EXPECT_FALSE(v["b"]["c"]);
  EXPECT_TRUE(std::isnan(v["a"]["b"].value));
}

TEST(JsonReader, ReadsEscapedCharacters) {
  EXPECT_EQ(readJson(R"("\u00b5 \u20ac \ud83d\ude00 \/")", "a.json").text, "µ € 😀 /");
}

TEST(JsonReader, SaysWhereItStumbled) {
  EXPECT_EQ(faultOf("{\n  \"a\" 1}"), "a.json:2:7: expected ':'");
  EXPECT_EQ(faultOf("[1, 2"), "a.json:1:6: expected ']'");
  EXPECT_EQ(faultOf("[1] 2"), "a.json:1:5: expected the end of the file");
  EXPECT_EQ(faultOf("{\"a\": nan}"), "a.json:1:7: expected a value");
  EXPECT_EQ(faultOf("\"ab"), "a.json:1:4: expected the end of a string");
  EXPECT_EQ(faultOf(R"("\u12")"), "a.json:1:4: expected four hexadecimal digits");
  EXPECT_EQ(faultOf(""), "a.json:1:1: expected a value");
  EXPECT_EQ(faultOf(std::string(1000, '[')),
            "a.json:1:102: expected less brackets inside of each other");
}

}  // namespace
}  // namespace dynamy
