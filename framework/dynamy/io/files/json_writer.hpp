#pragma once
/// \file
/// JSON, written straight to the end of a string: for run.json, scenes and the replay. Numbers have
/// the shortest text that reads back to the same double. JSON has no NaN and no infinity; both
/// become null. A document tree, and with it a JSON library, is not needed: the text is neither
/// read back nor changed nor searched.

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Streaming writer. Calls follow the grammar of JSON; breaking it is a fault of the caller
/// (assert).
///
///     JsonWriter json(text);
///     json.beginObject().member("steps", 12).key("box").beginArray().value(0.5).endArray();
///     json.endObject();
class JsonWriter {
 public:
  /// Appends to `out`, which outlives the writer. `indent`: spaces per level; 0 writes one line.
  explicit JsonWriter(std::string& out, int indent = 0) : out_(out), indent_(indent) {}

  JsonWriter& beginObject() { return open('{'); }
  JsonWriter& endObject() { return close('}'); }
  JsonWriter& beginArray() { return open('['); }
  JsonWriter& endArray() { return close(']'); }
  /// Writes the name of the next member of the open object.
  JsonWriter& key(std::string_view name);

  /// Writes a string (UTF-8) with its escapes.
  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(const std::string& text) { return value(std::string_view(text)); }
  /// Writes true, false, an integer, or a floating-point number (null if it is not finite).
  template <class T>
  requires std::integral<T> || std::floating_point<T> JsonWriter& value(T x) {
    if constexpr (std::same_as<T, bool>)
      return raw(x ? "true" : "false");
    else if constexpr (std::floating_point<T>)
      return number(static_cast<double>(x));
    else if constexpr (std::signed_integral<T>)
      return integer(static_cast<std::int64_t>(x));
    else
      return natural(static_cast<std::uint64_t>(x));
  }
  /// Writes all values of a range as an array.
  template <class Range>
  JsonWriter& values(const Range& range) {
    beginArray();
    for (const auto& x : range) value(x);
    return endArray();
  }
  template <class T>
  JsonWriter& member(std::string_view name, const T& x) {
    return key(name).value(x);
  }
  /// Writes a value that is JSON text already.
  JsonWriter& raw(std::string_view json);

 private:
  struct Level {
    bool isObject;
    bool isEmpty;
    bool hasLines;  ///< its members stand on lines of their own
  };
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  JsonWriter& number(double x);
  JsonWriter& integer(std::int64_t x);
  JsonWriter& natural(std::uint64_t x);
  void separate();
  void newLine();

  std::string& out_;
  int indent_;
  bool afterKey_ = false;
  std::vector<Level> levels_;
};

/// Appends `text` as a JSON string with its quotes.
void appendJsonString(std::string& out, std::string_view text);

/// Appends the shortest decimal text that reads back to the same double, or "nan", "inf", "-inf".
void appendNumber(std::string& out, double x);

}  // namespace dynamy
