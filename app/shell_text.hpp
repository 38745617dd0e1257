/// Quotes words for a POSIX shell.
#pragma once
#include <string>

namespace dynamy::app {

/// `text` as one word in single quotes. All characters in it, such as blanks, quotes, `$` and line
/// ends, are taken literally.
std::string shellQuoted(const std::string& text);

/// `text` as one word for a command that a person reads: quoted only if necessary.
std::string shellWord(const std::string& text);

}  // namespace dynamy::app
