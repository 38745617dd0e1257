#include "command_text.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>

namespace dynamy::app {
namespace {

/// "TEXT:{bash,zsh,fish}" → the words in braces.
std::vector<std::string> choicesIn(const std::string& type) {
  std::vector<std::string> out;
  const std::size_t begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return out;
  std::istringstream words(type.substr(begin + 1, end - begin - 1));
  for (std::string word; std::getline(words, word, ',');) out.push_back(word);
  return out;
}

}  // namespace

std::vector<OptionText> optionTexts(const CLI::App& app) {
  std::vector<OptionText> all;
  for (const CLI::Option* o : app.get_options()) {
    OptionText t;
    t.argument = o->get_positional();
    if (t.argument) {
      t.names.push_back(o->get_name(true));
    } else {
      for (const std::string& name : o->get_snames()) t.names.push_back("-" + name);
      for (const std::string& name : o->get_lnames()) t.names.push_back("--" + name);
    }
    const bool flag = o->get_type_size() == 0;
    if (!flag) t.value = t.argument ? t.names.front() : o->get_type_name();
    t.choices = choicesIn(o->get_type_name());
    // The name of a check follows the word for the value: "FLOAT:POSITIVE".
    t.value = t.value.substr(0, t.value.find(':'));
    t.text = o->get_description(), t.standard = o->get_default_str();
    t.required = o->get_required();
    all.push_back(t);
  }
  std::stable_partition(all.begin(), all.end(), [](const OptionText& t) { return t.argument; });
  return all;
}

std::vector<CommandText> commandTexts(const CLI::App& app) {
  std::vector<CommandText> all;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    all.push_back({sub->get_name(), sub->get_description(), optionTexts(*sub)});
  return all;
}

std::string synopsis(const CommandText& command) {
  std::string out;
  for (const OptionText& o : command.options) {
    if (o.names.back() == "--help") continue;
    const std::string one = o.names.back() + (o.argument || o.value.empty() ? "" : " " + o.value);
    out += (out.empty() ? "" : " ") + (o.required ? one : "[" + one + "]");
  }
  return out;
}

}  // namespace dynamy::app
