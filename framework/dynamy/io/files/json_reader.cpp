#include <algorithm>
#include <charconv>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_reader.hpp>

namespace dynamy {
namespace {

constexpr int kDeepest = 100;

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  JsonValue whole() {
    JsonValue v = value(0);
    blanks();
    if (at_ < text_.size()) fail("the end of the file");
    return v;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    const std::string_view before = text_.substr(0, at_);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t begin = before.rfind('\n');
    const std::size_t column = at_ - (begin == std::string_view::npos ? 0 : begin + 1) + 1;
    throw FileError(file_ + ':' + std::to_string(line) + ':' + std::to_string(column),
                    "expected " + expected);
  }
  void blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  bool takes(char c) {
    blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!takes(c)) fail(std::string("'") + c + "'");
  }
  bool takesWord(std::string_view word) {
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }

  JsonValue value(int depth) {
    if (depth > kDeepest) fail("less brackets inside of each other");
    blanks();
    JsonValue v;
    if (takes('{')) {
      v.type = JsonValue::Type::object;
      if (takes('}')) return v;
      do {
        expect('"');
        v.names.push_back(string());
        expect(':');
        v.items.push_back(value(depth + 1));
      } while (takes(','));
      expect('}');
    } else if (takes('[')) {
      v.type = JsonValue::Type::array;
      if (takes(']')) return v;
      do v.items.push_back(value(depth + 1));
      while (takes(','));
      expect(']');
    } else if (takes('"')) {
      v.type = JsonValue::Type::text;
      v.text = string();
    } else if (takesWord("true")) {
      v.type = JsonValue::Type::boolean, v.flag = true;
    } else if (takesWord("false")) {
      v.type = JsonValue::Type::boolean;
    } else if (!takesWord("null")) {
      v.type = JsonValue::Type::number;
      const char* const end = text_.data() + text_.size();
      const bool digits = text_.find_first_of("-0123456789", at_) == at_;  // no "nan", no "inf"
      const auto [rest, error] = std::from_chars(text_.data() + at_, end, v.value);
      if (!digits || error != std::errc()) fail("a value");
      at_ = static_cast<std::size_t>(rest - text_.data());
    }
    return v;
  }

  /// The rest of a string, after its opening quote.
  std::string string() {
    std::string out;
    for (;;) {
      if (at_ >= text_.size()) fail("the end of a string");
      const char c = text_[at_++];
      if (c == '"') return out;
      if (c != '\\') {
        out += c;
        continue;
      }
      constexpr std::string_view kEscaped = "\"\\/bfnrt", kMeant = "\"\\/\b\f\n\r\t";
      const std::size_t k = at_ < text_.size() ? kEscaped.find(text_[at_]) : std::string::npos;
      if (k != std::string::npos) {
        out += kMeant[k], ++at_;
      } else if (takesWord("u")) {
        appendUtf8(out, codePoint());
      } else {
        fail("an escape");
      }
    }
  }
  unsigned hexadecimal() {
    unsigned code = 0;
    const char* const begin = text_.data() + at_;
    if (text_.size() - at_ < 4 || std::from_chars(begin, begin + 4, code, 16).ptr != begin + 4)
      fail("four hexadecimal digits");
    at_ += 4;
    return code;
  }
  /// The character of an escape, after its \u; two escapes form one character beyond U+FFFF.
  unsigned codePoint() {
    const unsigned high = hexadecimal();
    if (high < 0xd800 || high > 0xdbff || !takesWord("\\u")) return high;
    const unsigned low = hexadecimal();
    return 0x10000 + ((high - 0xd800) << 10) + ((low - 0xdc00) & 0x3ff);
  }
  static void appendUtf8(std::string& out, unsigned code) {
    const auto put = [&out](unsigned byte) { out += static_cast<char>(byte); };
    const auto more = [&](int shift) { put(0x80 | ((code >> shift) & 0x3f)); };
    if (code < 0x80) {
      put(code);
    } else if (code < 0x800) {
      put(0xc0 | (code >> 6)), more(0);
    } else if (code < 0x10000) {
      put(0xe0 | (code >> 12)), more(6), more(0);
    } else {
      put(0xf0 | (code >> 18)), more(12), more(6), more(0);
    }
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
};

}  // namespace

const JsonValue& JsonValue::operator[](std::string_view name) const {
  static const JsonValue kNull;
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? kNull : items[static_cast<std::size_t>(found - names.begin())];
}

std::optional<long> JsonValue::whole(long least, long most) const {
  if (!(value >= static_cast<double>(least)) || !(value <= static_cast<double>(most))) return {};
  return static_cast<long>(value);
}

JsonValue readJson(std::string_view text, const std::string& file) {
  return Reader(text, file).whole();
}

}  // namespace dynamy
