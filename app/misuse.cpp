#include "misuse.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>
#include <filesystem>

namespace dynamy::app {
namespace {

/// The names of all options, "--until" or "-h".
std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> out;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) out.push_back("--" + name);
    for (const std::string& name : option->get_snames()) out.push_back('-' + name);
  }
  return out;
}

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// The sub-command that has the name `word` in other programs.
std::string commandOfOthers(std::string_view word) {
  for (const auto& [other, ours] : {std::pair("simulate", "run"),
                                    {"sim", "run"},
                                    {"start", "run"},
                                    {"validate", "check"},
                                    {"lint", "check"},
                                    {"show", "view"},
                                    {"replay", "view"},
                                    {"animate", "view"},
                                    {"play", "view"},
                                    {"video", "view"},
                                    {"plot", "report"},
                                    {"info", "describe"},
                                    {"explain", "describe"},
                                    {"types", "list"},
                                    {"elements", "list"},
                                    {"modes", "eigen"},
                                    {"watch", "run --watch"},
                                    {"live", "run --live"},
                                    {"optimize", "fit"},
                                    {"identify", "fit"},
                                    {"convert", "import"},
                                    {"continue", "resume"},
                                    {"restart", "resume"},
                                    {"benchmark", "bench"},
                                    {"xsd", "schema"}})
    if (word == other) return ours;
  return {};
}

Misuse unknownCommand(const std::string& word, const CLI::App& in, const std::string& before) {
  std::vector<std::string> known;
  for (const CLI::App* sub : commandsOf(in)) known.push_back(sub->get_name());
  std::string hint = didYouMean(nearest(word, known));
  if (hint.empty() && before.empty()) hint = didYouMean(commandOfOthers(word));
  std::error_code error;
  if (hint.empty() && before.empty() &&
      (word.ends_with(".xml") || std::filesystem::is_regular_file(word, error)))
    hint = "a command stands before the model: dynamy run " + word;
  if (hint.empty()) hint = unknownNameHint(word, known);
  return {"there is no command \"" + before + word + '"', hint};
}

/// The commands that have the option `name`: "run, sweep"; `before` stands before their names.
std::vector<std::string> commandsWith(const CLI::App& app, const std::string& name,
                                      const std::string& before = {}) {
  std::vector<std::string> out;
  for (const CLI::App* command : commandsOf(app)) {
    const std::string full = before + command->get_name();
    const auto names = optionNames(*command);
    if (std::find(names.begin(), names.end(), name) != names.end()) out.push_back(full);
    for (std::string& inner : commandsWith(*command, name, full + ' '))
      out.push_back(std::move(inner));
  }
  return out;
}

std::string joinedWords(const std::vector<std::string>& words, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < std::min(words.size(), most); ++i)
    out += (i > 0 ? ", " : "") + words[i];
  return words.size() > most ? out + ", …" : out;
}

/// The remedy for an option of other programs that is no option here; "" if there is none.
std::string optionOfOthers(std::string_view word) {
  for (const auto& [others, hint] :
       {std::pair(" gui window render visualize visualise display show ",
                  "the picture of a run is in its folder, dynamy view DIR shows it; dynamy run "
                  "MODEL --live shows it while it computes"),
        {" plot plots figure graph ",
         "a run draws its signals into signals.svg of its folder; dynamy report DIR makes a page"},
        {" verbose debug loglevel v vv ", "there is nothing more to print; --json prints run.json"},
        {" param params parameter parameters define variable var override ",
         "a parameter of the model is given by --set NAME=VALUE"},
        {" csv save export hdf5 h5 format ",
         "a run always writes its folder; --signals csv or --signals hdf5 is the format of its "
         "signals"}})
    if (std::string_view(others).find(' ' + std::string(word) + ' ') != std::string_view::npos)
      return hint;
  return {};
}

/// An option that the command `in` does not have: the word of another program, an option of other
/// commands, the nearest name, the only one that begins so, or all names.
Misuse unknownOption(const std::string& name, const CLI::App& app, const CLI::App& in,
                     const std::string& before) {
  const std::vector<std::string> known = optionNames(in);
  std::vector<std::string> bare, likely, shown;
  for (const std::string& k : known) {
    if (k == "--help" || k == "-h") continue;
    shown.push_back(k);
    bare.push_back(k.substr(k.find_first_not_of('-')));
    if (bare.back().starts_with(name.substr(name.find_first_not_of('-')))) likely.push_back(k);
  }
  const Misuse wrong{"there is no option \"" + name + '"', {}};
  const std::string word = name.substr(name.find_first_not_of('-'));
  if (const std::string other = attributeOfOthers(word, bare).name; !other.empty())
    return {wrong.text, didYouMean("--" + other)};
  if (const std::string hint = optionOfOthers(word); !hint.empty()) return {wrong.text, hint};
  if (!name.starts_with("--") && likely.size() == 1)
    return {wrong.text, didYouMean(likely.front())};
  const std::string all = shown.empty() ? "it has none" : "known: " + quotedList(shown);
  constexpr std::size_t kMostCommands = 4;
  if (const auto others = commandsWith(app, name); !others.empty()) {
    const std::string have = joinedWords(others, kMostCommands);
    if (before.empty())
      return {"a command is missing before \"" + name + '"', "it belongs to: " + have};
    return {"dynamy " + before + "has no option \"" + name + '"',
            "it belongs to: " + have + "; " + all};
  }
  if (!name.starts_with("--") && !likely.empty())
    return {wrong.text, likely.size() == 1 ? didYouMean(likely.front())
                                           : "options have two signs: " + quotedList(likely)};
  // Any letter is near any other.
  if (const std::string near = word.size() > 1 ? nearest(name, known) : ""; !near.empty())
    return {wrong.text, didYouMean(near)};
  return {wrong.text, shown.empty() ? "the command has none" : all};
}

/// "MODEL [OPTIONS]": what may follow the command.
std::string argumentsOf(const CLI::App& command) {
  std::string out;
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) out += ' ' + option->get_name();
  return out + " [OPTIONS]";
}

/// What the parser reports of a command whose words are all known.
Misuse wrongValues(const CLI::App& in, const std::string& before, const CLI::ParseError& error) {
  const std::string text = error.what();
  const std::string command = "dynamy " + before.substr(0, before.find_last_not_of(' ') + 1);
  const auto is = [&](CLI::ExitCodes code) {
    return error.get_exit_code() == static_cast<int>(code);
  };
  const auto optionBefore = [&](const char* end) -> const CLI::Option* {
    return in.get_option_no_throw(text.substr(0, text.find(end)));
  };
  if (const CLI::Option* option =
          is(CLI::ExitCodes::RequiredError) ? optionBefore(" is required") : nullptr)
    return {command + " needs " + option->get_name() + ": " + option->get_description(), {}};
  if (is(CLI::ExitCodes::RequiredError) && !commandsOf(in).empty()) {
    std::vector<std::string> known;
    for (const CLI::App* sub : commandsOf(in)) known.push_back(sub->get_name());
    return {command + " needs one of " + quotedList(known), {}};
  }
  if (const CLI::Option* option =
          is(CLI::ExitCodes::ArgumentMismatch) ? optionBefore(":") : nullptr)
    return {option->get_name() + " needs a value, " + option->get_type_name() + ": " +
                option->get_description(),
            {}};
  if (!is(CLI::ExitCodes::ExtrasError)) return {text, {}};
  const std::string word = text.substr(text.rfind(' ') + 1);  // the first one is the last
  if (const std::string option = "--" + word.substr(0, word.find('='));
      word.find('=') != std::string::npos && in.get_option_no_throw(option) != nullptr)
    return {'"' + word + "\" is a word too many",
            didYouMean(option + ' ' + word.substr(word.find('=') + 1))};
  if (parseUnitSuffix(word) || !unitOfOthers(word).empty())
    return {'"' + word + "\" is a word too many",
            "a unit stands right after its number, without a blank: 5s"};
  const bool sets =
      word.find('=') != std::string::npos && in.get_option_no_throw("--set") != nullptr;
  return {'"' + word + "\" is a word too many",
          sets ? didYouMean("--set " + word) : "write " + command + argumentsOf(in)};
}

bool isShortOption(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         std::isalpha(static_cast<unsigned char>(word[1])) != 0;
}

}  // namespace

Misuse misuse(const CLI::App& app, const CLI::ParseError& error,
              const std::vector<std::string>& words) {
  if (words.empty()) return {"a command is missing, such as dynamy run model.xml", {}};
  const CLI::App* in = &app;
  std::string before;
  for (const std::string& word : words) {
    if (word.starts_with("--") || isShortOption(word)) {
      const std::string name = word.substr(0, word.find('='));
      const std::vector<std::string> known = optionNames(*in);
      if (std::find(known.begin(), known.end(), name) == known.end())
        return unknownOption(name, app, *in, before);
    } else if (!word.starts_with("-") && !commandsOf(*in).empty()) {
      const auto commands = commandsOf(*in);
      const auto at = std::find_if(commands.begin(), commands.end(),
                                   [&](const CLI::App* sub) { return sub->get_name() == word; });
      if (at == commands.end()) return unknownCommand(word, *in, before);
      in = *at, before += word + ' ';
    }
  }
  return wrongValues(*in, before, error);
}

}  // namespace dynamy::app
