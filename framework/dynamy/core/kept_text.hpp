/// Texts that live as long as the program, so that views of them never dangle.
#pragma once
#include <string>
#include <string_view>

namespace dynamy {

/// The same characters for good; equal texts are kept once. For texts of which there are few: names
/// of methods, descriptions of signals. May be called by several threads.
std::string_view keptText(std::string text);

}  // namespace dynamy
