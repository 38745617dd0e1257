#pragma once
/// \file
/// Files that are no text, recognised by their first bytes: what a message calls them, and what to
/// do with them. Rejected: the end of the file's name, which is wrong just where a file was
/// exchanged for another.

#include <string_view>

namespace dynamy {

/// What a file is, e.g. "compressed by gzip", and the hint of a message; "" if it may be text.
struct ForeignFormat {
  std::string_view name, remedy;
};

/// `bytes`: the beginning of the file, 8 bytes or more if it has them.
ForeignFormat foreignFormat(std::string_view bytes);

}  // namespace dynamy
