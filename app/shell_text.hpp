/// Words for a POSIX shell.
#pragma once
#include <string>

namespace dynamy::app {

/// `text` as one word, in single quotes: whatever is in it, blanks, quotes, `$` or line ends,
/// means itself.
std::string shellQuoted(const std::string& text);

/// The same for a command that a person reads: quoted only if it must be.
std::string shellWord(const std::string& text);

}  // namespace dynamy::app
