/// Files and folders on the command line.
#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <system_error>

namespace dynamy::app {

/// Refuses an empty name. Otherwise an empty shell variable would silently select the default.
inline CLI::Validator someName() {
  return CLI::Validator(
      [](std::string& name) {
        return name.empty() ? std::string("the name is empty") : std::string();
      },
      "");
}

/// Throws if the file `out` that a command is to write is the file `in` that it reads.
inline void requireOtherFile(const std::string& out, const std::string& in) {
  std::error_code error;
  if (std::filesystem::equivalent(out, in, error))
    throw CLI::ValidationError("--out", out + " is the file that is read; it was not touched");
}

}  // namespace dynamy::app
