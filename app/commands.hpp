/// All sub-commands of the program.
#pragma once
#include "program.hpp"

namespace dynamy::app {

/// Declares all sub-commands in the order of `dynamy --help`; their callbacks set
/// program.exitCode.
void addCommands(CLI::App& app, Program& program);

}  // namespace dynamy::app
