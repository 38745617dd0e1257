/// The classes of a source text: how many functions and data they have, and which member functions
/// a text defines outside of their classes. A reader of tokens and brackets, no compiler: it knows
/// the C++ that is written here. Rejected: a compiler's syntax tree, which takes minutes and a tool
/// that not every machine has.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy::architecture {

/// The words and brackets of a text, without comments, strings and preprocessor lines. "::" is one
/// token; a string or a character is the token \"\".
std::vector<std::string> tokensOf(std::string_view text);

struct ClassSize {
  std::string name;
  int functions = 0;  ///< constructors and static functions, too
  int data = 0;       ///< without static members
};

/// All classes and structs that are defined in a text, those inside of others and of functions, too.
std::vector<ClassSize> classesIn(const std::vector<std::string>& tokens);

/// Names of the classes of which a text defines member functions as `Class::function(…)`.
std::set<std::string> classesDefinedOutside(const std::vector<std::string>& tokens);

}  // namespace dynamy::architecture
