#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <dynamy/io/files/json_writer.hpp>

namespace dynamy {

void appendNumber(std::string& out, double x) {
  if (std::isnan(x)) {
    out += "nan";  // without the sign that to_chars would write
    return;
  }
  std::array<char, 32> text;  // the longest is 24 characters: -1.2345678901234567e-308
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  out.append(text.data(), end);
}

void appendJsonString(std::string& out, std::string_view text) {
  constexpr std::string_view hex = "0123456789abcdef";
  out += '"';
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          out += "\\u00";
          out += hex[static_cast<unsigned char>(c) >> 4];
          out += hex[static_cast<unsigned char>(c) & 15];
        } else {
          out += c;
        }
    }
  }
  out += '"';
}

JsonWriter& JsonWriter::key(std::string_view name) {
  assert(!levels_.empty() && levels_.back().isObject && !afterKey_);
  separate();
  appendJsonString(out_, name);
  out_ += indent_ > 0 ? ": " : ":";
  afterKey_ = true;
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  separate();
  appendJsonString(out_, text);
  return *this;
}

JsonWriter& JsonWriter::raw(std::string_view json) {
  separate();
  out_ += json;
  return *this;
}

JsonWriter& JsonWriter::number(double x) {
  separate();
  if (std::isfinite(x)) {
    appendNumber(out_, x);
  } else {
    out_ += "null";
  }
  return *this;
}

JsonWriter& JsonWriter::integer(std::int64_t x) { return raw(std::to_string(x)); }
JsonWriter& JsonWriter::natural(std::uint64_t x) { return raw(std::to_string(x)); }

JsonWriter& JsonWriter::open(char bracket) {
  const bool isListed = bracket == '{' && !afterKey_ && !levels_.empty();
  if (isListed) levels_.back().hasLines = true;  // objects in an array have lines of their own
  separate();
  if (isListed) newLine();
  out_ += bracket;
  levels_.push_back({bracket == '{', true, bracket == '{'});
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  assert(!levels_.empty() && levels_.back().isObject == (bracket == '}') && !afterKey_);
  const Level level = levels_.back();
  levels_.pop_back();
  if (level.hasLines && !level.isEmpty) newLine();
  out_ += bracket;
  return *this;
}

/// Writes the separator before a key or a value: nothing after a key, otherwise a comma and, in
/// objects, a new line.
void JsonWriter::separate() {
  if (afterKey_) {
    afterKey_ = false;
    return;
  }
  if (levels_.empty()) return;
  Level& level = levels_.back();
  if (!level.isEmpty) out_ += indent_ > 0 && !level.hasLines ? ", " : ",";
  level.isEmpty = false;
  if (level.isObject) newLine();
}

void JsonWriter::newLine() {
  if (indent_ <= 0) return;
  out_ += '\n';
  out_.append(levels_.size() * static_cast<std::size_t>(indent_), ' ');
}

}  // namespace dynamy
