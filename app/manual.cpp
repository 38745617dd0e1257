/// dynamy manual: prints the page for man(1), made from the declarations of the commands.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cctype>
#include <dynamy/core/version.hpp>
#include <sstream>

#include "command_text.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace {

/// Escapes a text for troff, including hyphens, which man would turn into another sign.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  // troff would take a line that begins with . or ' for a request.
  if (out.starts_with('.') || out.starts_with('\'')) out.insert(0, "\\&");
  return out;
}

std::string optionEntry(const OptionText& o) {
  std::string names;
  for (const std::string& name : o.names)
    names += (names.empty() ? "" : ", ") +
             (o.argument ? "\\fI" + roff(name) + "\\fR" : "\\fB" + roff(name) + "\\fR");
  if (!o.argument && !o.value.empty()) names += " \\fI" + roff(o.value) + "\\fR";
  std::string text = o.text;
  if (!o.standard.empty()) text += " (default: " + o.standard + ")";
  return ".TP\n" + names + "\n" + roff(text) + "\n";
}

/// Sections that follow the commands. In the footer, lines "word  text" stand under a heading.
std::string footerSections(const std::string& footer) {
  std::string out;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    if (!line.starts_with(' ')) {
      std::string title = line.substr(0, line.find(':'));
      for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      out += ".SH " + title + "\n";
      continue;
    }
    const std::size_t word = line.find_first_not_of(' ');
    const std::size_t end = line.find("  ", word);
    const std::size_t text = line.find_first_not_of(' ', end);
    if (text == std::string::npos) continue;
    out += ".TP\n\\fB" + roff(line.substr(word, end - word)) + "\\fR\n" + roff(line.substr(text)) +
           "\n";
  }
  return out;
}

}  // namespace

std::string manualPage(const CLI::App& app) {
  std::string out =
      fmt::format(".TH DYNAMY 1 \"\" \"dynamY {}\" \"User commands\"\n", versionString());
  out += ".SH NAME\ndynamy \\- simulation of multibody systems with impacts and friction\n";
  out += ".SH SYNOPSIS\n";
  const std::vector<CommandText> commands = commandTexts(app);
  for (const CommandText& c : commands)
    out += ".PP\n\\fBdynamy " + roff(c.name) + "\\fR " + roff(synopsis(c)) + "\n";
  out += ".SH DESCRIPTION\n" + roff(app.get_description()) + ".\n";
  out += ".SH OPTIONS\n";
  for (const OptionText& o : optionTexts(app)) out += optionEntry(o);
  out += ".SH COMMANDS\n";
  for (const CommandText& c : commands) {
    out += ".SS dynamy " + roff(c.name) + "\n" + roff(c.text) + "\n";
    for (const OptionText& o : c.options)
      if (o.names.back() != "--help") out += optionEntry(o);
  }
  return out + footerSections(app.get_footer());
}

void addManual(CLI::App& app, Program&) {
  CLI::App* c =
      app.add_subcommand("manual", "this text as a page for man: dynamy manual | man -l -");
  c->callback([&app] { fmt::print("{}", manualPage(app)); });
}

}  // namespace dynamy::app
