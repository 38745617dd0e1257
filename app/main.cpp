#include "command_line.hpp"
#include "run/endings.hpp"

int main(int argc, char** argv) {
  dynamy::app::takeFileLimitsAsErrors();
  return dynamy::app::runCommandLine(argc, argv);
}
