#include "program.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/core/version.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/io/reference/libraries.hpp>
#include <dynamy/io/run_files/frames_file.hpp>
#include <dynamy/io/xml/source_text.hpp>
#include <dynamy/io/xml/vocabulary.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <optional>
#include <sstream>
#include <system_error>

namespace dynamy::app {
namespace {

constexpr std::size_t kShownErrors = 100;  // as many as dynamy::format shows

/// Adds source lines to errors that were found after reading the model. Each file is read once.
std::vector<Diagnostic> withSourceLines(std::vector<Diagnostic> all) {
  std::map<std::string, std::optional<SourceText>> files;
  for (std::size_t i = 0; i < std::min(all.size(), kShownErrors); ++i) {
    Diagnostic& d = all[i];
    if (!d.sourceLine.empty() || d.place.line <= 0 || d.place.file.empty()) continue;
    const auto [at, isNew] = files.try_emplace(d.place.file);
    std::error_code error;
    if (isNew && std::filesystem::is_regular_file(d.place.file, error)) {
      std::ifstream in(d.place.file, std::ios::binary);
      std::ostringstream whole;
      whole << in.rdbuf();
      at->second.emplace(whole.str(), d.place.file);
    }
    const std::optional<SourceText>& text = at->second;
    if (text) d.sourceLine = text->shownLine(d.place);
  }
  return all;
}

}  // namespace

namespace {

/// Prints an error. If even that fails, as on a full disk, only the exit status reports it.
void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

bool isLackOfRoom(const std::error_code& code) {
  for (const auto c : {std::errc::no_space_on_device, std::errc::file_too_large,
                       std::errc::io_error, std::errc::broken_pipe})
    if (code == c) return true;
  return code.value() == EDQUOT;
}

}  // namespace

int withErrorsTold(const std::function<int()>& call) {
  try {
    const int status = call();
    // If the output cannot be written, the status reports it.
    return std::fflush(stdout) == 0 || status != kOk ? status : kCannotWrite;
  } catch (const CLI::ParseError&) {
    throw;
  } catch (const ModelError& e) {
    const std::size_t n = e.diagnostics().size();
    say(fmt::format("{}\n{} error{}\n", format(withSourceLines(e.diagnostics())), n,
                    n == 1 ? "" : "s"));
    return kModel;
  } catch (const WriteError& e) {  // the text has path and reason
    say(fmt::format("dynamy: {}\n", e.what()));
    return kCannotWrite;
  } catch (const FileError& e) {
    say(fmt::format("dynamy: {}\n", e.what()));
    return kModel;
  } catch (const std::bad_alloc&) {
    say("dynamy: out of memory\n");
    return kOutOfMemory;
  } catch (const std::system_error& e) {  // usually from printing
    say(fmt::format("dynamy: {}\n", e.what()));
    return isLackOfRoom(e.code()) ? kCannotWrite : kFailed;
  } catch (const std::exception& e) {
    say(fmt::format("dynamy: {}\n", e.what()));
    return kFailed;
  }
}

void Program::load() {
  registerFramework(registry);
  if (trust) plugins.trustModels();
  plugins.load(kStandardElements, registry);
  for (const std::string& library : libraries) plugins.load(library, registry);
}

void addPlugins(CLI::App& command, Program& program, bool readsModels) {
  command
      .add_option("--plugin", program.libraries,
                  "shared library with further types: a name, or a path with a '/'")
      ->type_name("LIBRARY");
  if (readsModels)
    command.add_flag("--trust", program.trust,
                     "load also libraries that come with the model, from its own folder");
}

namespace {

double timeIn(const std::string& text, const std::string& option, bool mayBeZero) {
  Attribute a;
  a.name = option, a.unit = Unit::time;
  a.positive().minOpen = !mayBeZero;
  ParameterValue value;
  value.declaration = &a, value.text = text, value.given = true;
  if (const auto fault = readValue(a, value)) {
    // Braces are of model files.
    const std::string hint =
        fault->hint.find("in braces") == std::string::npos ? fault->hint : "a time is 5, 5s or 5ms";
    throw CLI::ValidationError(
        option, '"' + text + "\": " + fault->text + (hint.empty() ? "" : ", " + hint));
  }
  return value.numbers.at(0);
}

}  // namespace

double seconds(const std::string& text, const std::string& option) {
  return timeIn(text, option, false);
}

double instant(const std::string& text, const std::string& option) {
  return timeIn(text, option, true);
}

namespace {

std::string withoutBlanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// "mu=0.3" for "mu:0.3" and "mu 0.3"; else an example with the name.
std::string likelyAssignment(const std::string& text) {
  const std::size_t end = text.find_first_of(": =");
  const std::string name = end == 0 ? "mu" : text.substr(0, end);
  const std::string value = end == std::string::npos ? "" : withoutBlanks(text.substr(end + 1));
  return name + '=' + (value.empty() ? "0.3" : value);
}

}  // namespace

std::pair<std::string, std::string> assignment(const std::string& text) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0)
    throw CLI::ValidationError('"' + text + '"',
                               "expected name=value, such as " + likelyAssignment(text));
  return {withoutBlanks(text.substr(0, at)), withoutBlanks(text.substr(at + 1))};
}

std::vector<std::pair<std::string, std::string>> assignments(const std::vector<std::string>& texts,
                                                             const std::string& option) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const std::string& text : texts) {
    out.push_back(assignment(text));
    for (std::size_t i = 0; i + 1 < out.size(); ++i)
      if (out[i].first == out.back().first)
        throw CLI::ValidationError(
            option + ' ' + text, '"' + out[i].first + "\" has a value already by " + option + ' ' +
                                     texts[i] + "; leave one of them out");
  }
  return out;
}

std::pair<std::string, std::string> numberAssignment(const std::string& option,
                                                     const std::string& text) {
  auto out = assignment(text);
  char* end = nullptr;
  const double value = std::strtod(out.second.c_str(), &end);
  if (out.second.empty() || *end != '\0' || !std::isfinite(value))
    throw CLI::ValidationError(option, '"' + out.second + "\" is no finite number");
  return out;
}

std::unique_ptr<Element> methodElement(const Registry& registry, const std::string& words,
                                       Kind kind) {
  std::istringstream in(words);
  std::string name, given;
  in >> name;
  std::vector<GivenValue> values;
  while (in >> given) {
    if (const RegisteredType* other = registry.find(given); other != nullptr && other->kind == kind)
      throw ModelError('"' + words + "\" names two " + std::string(kindText(kind)) + 's',
                       "names stand between commas: " + name + ',' + given);
    const auto [attribute, value] = assignment(given);
    values.emplace_back(attribute, value);
  }
  const RegisteredType* type = registry.find(name);
  if (type == nullptr || type->kind != kind) {
    std::vector<std::string> known;
    for (const RegisteredType* t : registry.types())
      if (t->kind == kind) known.push_back(t->name);
    std::string hint = elementOfOthers(name);
    if (hint.empty() && type != nullptr)
      hint = '"' + name + "\" is of the kind " + std::string(kindText(type->kind));
    if (hint.empty() || !nearest(name, known).empty()) hint = unknownNameHint(name, known);
    throw ModelError("no " + std::string(kindText(kind)) + " named \"" + name + '"', hint);
  }
  return type->make(Parameters::of(type->attributes, type->name, "", values));
}

std::string versionText() {
  const PluginInfo f = frameworkFingerprint();
  std::string out = fmt::format("dynamY {}\n", versionString());
  out += fmt::format(" compiler   {}, {}\n", f.compiler, f.standardLibrary);
  out += fmt::format(" libraries  {}\n", libraryVersions());
  out += fmt::format(" plug-ins   binary interface {}, Eigen alignment {} bytes\n", f.abi,
                     f.eigenMaxAlignBytes);
  out += fmt::format(" formats    models {}, frames {}; contact problems of FCLIB; replay\n",
                     kModelVersion, kFramesVersion);
#ifdef NDEBUG
  out += " build      release";
#else
  out += " build      with assertions";
#endif
  return out;
}

}  // namespace dynamy::app
