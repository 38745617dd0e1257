/// Texts that live as long as the program, so that views of them never dangle.
#pragma once
#include <string>
#include <string_view>

namespace dynamy {

/// View of the same characters that stays valid until the program ends; equal texts are kept once.
/// For texts of which there are few, such as names of methods and descriptions of signals. May be
/// called by several threads.
std::string_view keptText(std::string text);

}  // namespace dynamy
