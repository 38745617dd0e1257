/// The program `dynamy`: reads the command line, calls one sub-command and turns errors into exit
/// codes. Results go to standard output, errors and progress to standard error.
#pragma once

namespace dynamy::app {

/// Returns the exit code. Takes what main() is given.
int runCommandLine(int argc, char** argv);

}  // namespace dynamy::app
