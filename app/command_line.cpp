#include "command_line.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>
#include <vector>

#include "commands.hpp"
#include "misuse.hpp"
#include "run/endings.hpp"

namespace dynamy::app {
namespace {

int usage(const CLI::App& app, const CLI::ParseError& error,
          const std::vector<std::string>& words) {
  if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
  const Misuse wrong = misuse(app, error, words);
  fmt::print(stderr, "dynamy: {}{}\n", wrong.text, wrong.hint.empty() ? "" : " — " + wrong.hint);
  fmt::print(stderr, "  dynamy --help lists the commands, dynamy COMMAND --help its options\n");
  return kUsage;
}

/// Shown below the commands, and a part of the manual page.
constexpr const char* kFooter =
    "Exit status:\n"
    "  0   done as the model asks, all checks passed\n"
    "  1   the simulation or a check failed; dynamy check: bodies start inside each other\n"
    "  2   error in a model, a plug-in or a file\n"
    "  3   finished, but a warning says that a step missed what the model asks for\n"
    "      (an inclusion unsolved, energy gained, bodies overlap, ...); run --accept makes it 0\n"
    "  64  wrong command line\n"
    "  71  out of memory\n"
    "  74  a file cannot be written: the disk is full, or a limit of the system is reached\n"
    "  128+N  a run was ended by signal N and can be resumed: 130 Ctrl-C, 143 SIGTERM, 129 SIGHUP\n"
    "Environment:\n"
    "  DYNAMY_PLUGIN_PATH  folders, separated by ':', that are searched for plug-ins\n"
    "  XDG_CONFIG_HOME     folder of dynamy/trusted: folders whose models may bring plug-ins\n"
    "Files:\n"
    "  runs/MODEL  what a run writes, if --out does not name another folder";

/// "help run" asks for "run --help", as in other programs; "version" for "--version".
std::vector<std::string> inOptions(std::vector<std::string> words) {
  if (words.empty() || (words[0] != "help" && words[0] != "version")) return words;
  const std::string option = "--" + words[0];
  words.erase(words.begin());
  words.push_back(option);
  return words;
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  Program program;
  CLI::App app{"dynamY: simulation of multibody systems with impacts and friction", "dynamy"};
  addCommands(app, program);
  app.footer(kFooter);
  const std::vector<std::string> words = inOptions(std::vector<std::string>(argv + 1, argv + argc));
  try {
    return withErrorsTold([&] {
      app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // the last one first
      return program.exitCode;
    });
  } catch (const CLI::ParseError& e) {
    return usage(app, e, words);
  }
}

}  // namespace dynamy::app
