/// The commands of the program as data: what --help shows, for the manual page and for completion
/// in shells. Rejected: a second set of texts beside the declarations, which would become outdated.
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace dynamy::app {

/// One option or argument of a command.
struct OptionText {
  std::vector<std::string> names;    ///< "--until"; an argument has its word, "MODEL"
  std::string value;                 ///< word for what follows, "TIME"; empty for a flag
  std::vector<std::string> choices;  ///< the admissible words, if they are few
  std::string text, standard;        ///< its purpose; the default value
  bool argument = false, required = false;
};

/// One sub-command.
struct CommandText {
  std::string name, text;
  std::vector<OptionText> options;  ///< in the order of --help: arguments first
};

/// Texts of all sub-commands in the order of --help.
std::vector<CommandText> commandTexts(const CLI::App& app);

/// Options of the program itself: --help, --version.
std::vector<OptionText> optionTexts(const CLI::App& app);

/// "MODEL [--until TIME] [--quiet]": what may follow the name of the command.
std::string synopsis(const CommandText& command);

/// The page for man(1).
std::string manualPage(const CLI::App& app);

/// The script that completes words for "bash", "zsh" or "fish".
std::string completionScript(const CLI::App& app, const std::string& shell);

}  // namespace dynamy::app
