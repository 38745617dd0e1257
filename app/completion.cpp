/// dynamy completion SHELL: prints the script that completes words, made from the declarations of
/// the commands. The word for a value (MODEL, DIR, SCHEME …) determines how it is completed. Names
/// of types come from `dynamy list`, which also lists plug-ins in DYNAMY_PLUGIN_PATH.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

#include "command_text.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace {

/// The possible values of an option; the first member that is set applies.
struct OptionValues {
  std::string words;    ///< known words
  std::string list;     ///< else: options of `dynamy list --names` that print them
  std::string ending;   ///< else: files with this ending, "*" for any
  bool folder = false;  ///< else: a folder
};

OptionValues valuesOf(const OptionText& o) {
  OptionValues v;
  if (!o.choices.empty())
    v.words = fmt::format("{}", fmt::join(o.choices, " "));
  else if (o.value == "SCHEME" || o.value == "SCHEMES")
    v.list = " --kind scheme";
  else if (o.value == "SOLVER")
    v.list = " --kind solver";
  else if (o.value == "NAME")
    v.list = " ";
  else if (o.value == "MODEL")
    v.ending = "xml";
  else if (o.value == "PROBLEM")
    v.ending = "hdf5";
  else if (o.value == "LIBRARY")
    v.ending = "so";
  else if (o.value == "FILE")
    v.ending = "*";
  else if (o.value == "DIR")
    v.folder = true;
  return v;
}

std::vector<std::string> optionNames(const CommandText& c) {
  std::vector<std::string> all;
  for (const OptionText& o : c.options)
    if (!o.argument) all.push_back(o.names.back());
  return all;
}

std::string commandNames(const std::vector<CommandText>& commands) {
  std::vector<std::string> all;
  for (const CommandText& c : commands) all.push_back(c.name);
  return fmt::format("{}", fmt::join(all, " "));
}

/// Lines of bash that set `words`, `ending` or `folder` for the value of an option.
std::string bashValue(const OptionText& o) {
  const OptionValues v = valuesOf(o);
  if (!v.words.empty()) return fmt::format("words=\"{}\"", v.words);
  if (!v.list.empty())
    return fmt::format("words=$(\"${{COMP_WORDS[0]}}\" list --names{} 2>/dev/null)",
                       v.list == " " ? "" : v.list);
  if (!v.ending.empty()) return fmt::format("ending=\"{}\"", v.ending);
  if (v.folder) return "folder=1";
  return ":";
}

std::string bashCase(const CommandText& c) {
  std::string out = fmt::format("    {})\n      case $before in\n", c.name);
  std::string argument = ":";
  for (const OptionText& o : c.options) {
    if (o.argument) argument = bashValue(o);
    if (!o.argument && !o.value.empty())
      out += fmt::format("        {}) {} ;;\n", fmt::join(o.names, "|"), bashValue(o));
  }
  out += "        *)\n          if [[ $current == -* ]]; then\n";
  out += fmt::format("            words=\"{}\"\n", fmt::join(optionNames(c), " "));
  out += "          else\n            " + argument + "\n          fi\n          ;;\n";
  return out + "      esac\n      ;;\n";
}

std::string bash(const CLI::App& app) {
  const std::vector<CommandText> commands = commandTexts(app);
  std::string out =
      "# Completion for dynamy; made by: dynamy completion bash\n"
      "_dynamy() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
      "  local command=${COMP_WORDS[1]} words=\"\" ending=\"\" folder=\"\"\n"
      "  if ((COMP_CWORD == 1)); then command=\"\"; fi\n"
      "  case $command in\n";
  out += fmt::format("    \"\") words=\"{} {}\" ;;\n", commandNames(commands),
                     fmt::join(optionNames({"", "", optionTexts(app)}), " "));
  for (const CommandText& c : commands) out += bashCase(c);
  out +=
      "  esac\n"
      "  if [[ $ending == \"*\" ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
      "  elif [[ -n $ending ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -f -X \"!*.$ending\" -- \"$current\"; "
      "compgen -d -- \"$current\")\n"
      "  elif [[ -n $folder ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -d -- \"$current\")\n"
      "  else\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
      "  fi\n"
      "}\n"
      "complete -o filenames -F _dynamy dynamy\n";
  return out;
}

/// Escapes a text for single quotes of zsh or fish; for zsh also colons and brackets, which are
/// special in _arguments.
std::string quoted(const std::string& text, const std::string& shell) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += shell == "zsh" ? "'\\''" : "\\'";
    else if (shell == "zsh" && (c == ':' || c == '[' || c == ']'))
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

/// The part ":word:action" of an argument of zsh's _arguments.
std::string zshValue(const OptionText& o) {
  const OptionValues v = valuesOf(o);
  std::string action = " ";
  if (!v.words.empty()) action = "(" + v.words + ")";
  // The space in front keeps _arguments from adding arguments of its own.
  if (!v.list.empty()) action = fmt::format(" _dynamy_names{}", v.list == " " ? "" : v.list);
  if (!v.ending.empty()) action = v.ending == "*" ? "_files" : "_files -g \"*." + v.ending + "\"";
  if (v.folder) action = "_files -/";
  return ":" + o.value + ":" + action;
}

std::string zshArguments(const std::vector<OptionText>& options) {
  std::string out;
  for (const OptionText& o : options) {
    if (o.argument)
      out += fmt::format(" \\\n        '{}'", zshValue(o));
    else
      for (const std::string& name : o.names)
        out += fmt::format(" \\\n        '*{}[{}]{}'", name, quoted(o.text, "zsh"),
                           o.value.empty() ? "" : zshValue(o));
  }
  return out;
}

std::string zsh(const CLI::App& app) {
  const std::vector<CommandText> commands = commandTexts(app);
  std::string out =
      "#compdef dynamy\n# Completion for dynamy; made by: dynamy completion zsh\n"
      "_dynamy_names() {\n"
      "  local -a names\n  names=(${(f)\"$(_call_program names $words[1] list --names \"$@\" "
      "2>/dev/null)\"})\n  compadd -a names\n}\n"
      "_dynamy_commands() {\n  local -a commands\n  commands=(\n";
  for (const CommandText& c : commands)
    out += fmt::format("    '{}:{}'\n", c.name, quoted(c.text, "zsh"));
  out += "  )\n  _describe command commands\n}\n_dynamy() {\n  local program=$words[1]\n";
  out += "  _arguments -C" + zshArguments(optionTexts(app)) +
         " \\\n        '1: :_dynamy_commands' '*:: :->rest' && return\n";
  out += "  case $words[1] in\n";
  for (const CommandText& c : commands)
    out += fmt::format("    {})\n      words[1]=$program\n      _arguments{} ;;\n", c.name,
                       zshArguments(c.options));
  return out + "  esac\n}\n_dynamy \"$@\"\n";
}

std::string fishValue(const OptionText& o) {
  const OptionValues v = valuesOf(o);
  if (!v.words.empty()) return fmt::format(" -x -a '{}'", v.words);
  if (!v.list.empty())
    return fmt::format(" -x -a '(dynamy list --names{} 2>/dev/null)'", v.list == " " ? "" : v.list);
  if (!v.ending.empty())
    return v.ending == "*" ? " -r -F"
                           : fmt::format(" -x -a '(__fish_complete_suffix .{})'", v.ending);
  if (v.folder) return " -x -a '(__fish_complete_directories)'";
  return " -x";
}

std::string fish(const CLI::App& app) {
  std::string out =
      "# Completion for dynamy; made by: dynamy completion fish\ncomplete -c dynamy -f\n";
  const auto flag = [](const OptionText& o) {
    std::string names;
    for (const std::string& name : o.names)
      names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    return names;
  };
  const std::string none = "__fish_use_subcommand";
  for (const OptionText& o : optionTexts(app))
    out += fmt::format("complete -c dynamy -n '{}'{} -d '{}'\n", none, flag(o),
                       quoted(o.text, "fish"));
  for (const CommandText& c : commandTexts(app)) {
    out += fmt::format("complete -c dynamy -n '{}' -a {} -d '{}'\n", none, c.name,
                       quoted(c.text, "fish"));
    for (const OptionText& o : c.options)
      out += fmt::format("complete -c dynamy -n '__fish_seen_subcommand_from {}'{}{} -d '{}'\n",
                         c.name, o.argument ? "" : flag(o), o.value.empty() ? "" : fishValue(o),
                         quoted(o.text, "fish"));
  }
  return out;
}

}  // namespace

std::string completionScript(const CLI::App& app, const std::string& shell) {
  if (shell == "zsh") return zsh(app);
  return shell == "fish" ? fish(app) : bash(app);
}

void addCompletion(CLI::App& app, Program&) {
  auto shell = std::make_shared<std::string>();
  CLI::App* c = app.add_subcommand("completion", "the script that lets a shell complete words");
  c->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  c->callback([shell, &app] { fmt::print("{}", completionScript(app, *shell)); });
}

}  // namespace dynamy::app
