/// Files and folders on the command line.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace dynamy::app {

/// Refuses "": an empty variable of a shell would stand for the default without a word.
inline CLI::Validator someName() {
  return CLI::Validator(
      [](std::string& name) {
        return name.empty() ? std::string("the name is empty") : std::string();
      },
      "");
}

}  // namespace dynamy::app
