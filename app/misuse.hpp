/// Errors of the command line in the words of the user: what is wrong and what was probably meant.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace dynamy::app {

/// The fault of a command line and a hint at what the user may have meant.
struct Misuse {
  std::string text, hint;
};

/// Describes why `words` are no command of `app`; `error`: what the parser reports.
Misuse misuse(const CLI::App& app, const CLI::ParseError& error,
              const std::vector<std::string>& words);

}  // namespace dynamy::app
