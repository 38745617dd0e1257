/// Files and folders on the command line.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace dynamy::app {

/// Refuses an empty name. Otherwise an empty shell variable would silently select the default.
inline CLI::Validator someName() {
  return CLI::Validator(
      [](std::string& name) {
        return name.empty() ? std::string("the name is empty") : std::string();
      },
      "");
}

}  // namespace dynamy::app
