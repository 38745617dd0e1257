#pragma once
/// \file
/// Characters of UTF-8 text, in which columns of error messages and checks of files count.

#include <cstddef>
#include <string>
#include <string_view>

namespace dynamy {

/// One character (code point); a byte that is no UTF-8 is an invalid character of its own.
struct Utf8Character {
  std::string_view bytes = {};
  char32_t code = 0;
  bool valid = true;
};

/// The character that begins at byte `at` < text.size(). Overlong forms, surrogates and codes
/// beyond U+10FFFF are invalid (RFC 3629).
Utf8Character nextCharacter(std::string_view text, std::size_t at);

/// Number of characters.
int characterCount(std::string_view utf8);

/// Column (from 1) of the byte at `offset` in a line of UTF-8 text.
int columnOf(std::string_view line, std::size_t offset);

/// The text with the letters A to Z in lower case.
std::string inLowerCase(std::string_view text);

}  // namespace dynamy
