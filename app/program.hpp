/// Shared by all sub-commands: registry and plug-ins, exit codes, values of options.
#pragma once
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;  // compiling its header takes seconds; only files that use options include it
}

namespace dynamy::app {

inline constexpr int kOk = 0;      ///< done, all checks passed
inline constexpr int kFailed = 1;  ///< the simulation or a check failed
inline constexpr int kModel = 2;   ///< error in model, plug-in or file
/// The run reached its end, but a step or a figure does not fulfil the requirements of the model;
/// the warnings say which. kFailed takes precedence.
inline constexpr int kQualified = 3;
inline constexpr int kUsage = 64;        ///< wrong command line
inline constexpr int kOutOfMemory = 71;  ///< memory ran out
inline constexpr int kCannotWrite = 74;  ///< a file cannot be written: the disk is full, …
inline constexpr int kSignalled = 128;   ///< plus the signal's number: ended by a signal

/// State of one call of the program.
struct Program {
  Registry registry;
  PluginLoader plugins;
  std::vector<std::string> libraries;  ///< given by --plugin
  bool trust = false;                  ///< --trust: models may load libraries of their own
  int exitCode = kOk;

  /// Registers the types of the framework, of the standard elements and of the libraries in
  /// --plugin. Throws ModelError.
  void load();
};

/// Declares the option --plugin, and for a command that reads models also --trust.
void addPlugins(CLI::App& command, Program& program, bool readsModels = true);

/// "1.5", "10s", "2ms" → seconds. Throws CLI::ValidationError.
double seconds(const std::string& text, const std::string& option);
/// The same of an instant, which may be 0.
double instant(const std::string& text, const std::string& option);

/// "name=value" → both. Throws CLI::ValidationError.
std::pair<std::string, std::string> assignment(const std::string& text);
/// The values of a repeated option. Throws CLI::ValidationError if a name is given twice.
std::vector<std::pair<std::string, std::string>> assignments(const std::vector<std::string>& texts,
                                                             const std::string& option = "--set");
/// The same of `option`, whose value is a finite number.
std::pair<std::string, std::string> numberAssignment(const std::string& option,
                                                     const std::string& text);

/// Makes a scheme, solver or impact law by its registered name. Attributes may follow the name, as
/// in "ConstraintIndex index=3"; all others have their defaults. Throws ModelError with the nearest
/// name of this kind.
template <class T>
std::unique_ptr<T> method(const Registry& registry, const std::string& words);
std::unique_ptr<Element> methodElement(const Registry& registry, const std::string& words,
                                       Kind kind);
template <class T>
std::unique_ptr<T> method(const Registry& registry, const std::string& words) {
  return std::unique_ptr<T>(
      static_cast<T*>(methodElement(registry, words, T::kKind).release()));  // the kind is checked
}

/// Calls `call` and returns its exit code. Errors of models, files and others are printed and
/// become an exit code; errors of the command line (CLI::ParseError) are passed on.
int withErrorsTold(const std::function<int()>& call);

/// The version and what the program was built with, several lines.
std::string versionText();

/// Declares `dynamy bench precision`, below `bench`; its callback sets program.exitCode.
void addBenchPrecision(CLI::App& bench, Program& program);

}  // namespace dynamy::app
