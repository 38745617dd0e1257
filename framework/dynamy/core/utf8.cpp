#include <dynamy/core/utf8.hpp>

#include <algorithm>

namespace dynamy {

Utf8Character nextCharacter(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const Utf8Character invalid{text.substr(at, 1), 0, false};
  const unsigned char lead = byte(at);
  if (lead < 0x80) return {text.substr(at, 1), lead, true};

  // Number of bytes from the first one, then six bits from each further one.
  std::size_t size = 0;
  if (lead >= 0xC2 && lead < 0xE0) size = 2;
  if (lead >= 0xE0 && lead < 0xF0) size = 3;
  if (lead >= 0xF0 && lead < 0xF5) size = 4;
  if (size == 0 || at + size > text.size()) return invalid;
  char32_t code = lead & (0x7Fu >> size);
  for (std::size_t i = at + 1; i < at + size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return invalid;
    code = (code << 6) | (byte(i) & 0x3Fu);
  }

  const bool overlong = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (overlong || surrogate || code > 0x10FFFF) return invalid;
  return {text.substr(at, size), code, true};
}

int characterCount(std::string_view utf8) {
  int count = 0;
  for (std::size_t at = 0; at < utf8.size(); ++count) at += nextCharacter(utf8, at).bytes.size();
  return count;
}

int columnOf(std::string_view line, std::size_t offset) {
  return characterCount(line.substr(0, std::min(offset, line.size()))) + 1;
}

std::string inLowerCase(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

}  // namespace dynamy
