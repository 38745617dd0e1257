/// Scope: the parameters, indices and name prefix that a value of a model file may refer to. Also
/// Faults, the collector of errors, which knows the lines of all files read.
#pragma once
#include <dynamy/core/expression/symbol_table.hpp>
#include <dynamy/io/xml/fault_list.hpp>
#include <dynamy/io/xml/xml.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>

namespace dynamy {

class CompiledBraces;
struct Scope;

/// Attributes of `<defaults>`: type → class ("" for all) → the element that holds them.
struct DefaultEntry {
  const XmlNode* node = nullptr;
  const Scope* scope = nullptr;
};
using DefaultsTable = std::map<std::string, std::map<std::string, DefaultEntry>>;

/// A file that is being read, or one turn of a replicate in it. A turn holds only its index;
/// everything else comes from the scope around it.
struct Scope {
  const Scope* outer = nullptr;  ///< around a turn; null for a file
  const XmlDocument* document = nullptr;
  std::string prefix;  ///< prefix of names: "left/"
  std::string suffix;  ///< suffix of names: "[2]"
  std::map<std::string, double, std::less<>>
      numbers;  ///< parameters of the file, or the turn's index

  // Members of files only.
  std::filesystem::path folder;
  std::set<std::string, std::less<>>
      broken;  ///< names with a wrong value: no further errors of their users
  DefaultsTable defaults;
  bool defaultsAreBroken = false;  ///< missing attributes are not reported
  /// Values that were resolved once; from the second time on they are compiled.
  mutable std::unordered_map<const XmlAttribute*, std::shared_ptr<CompiledBraces>> braces;

  const Scope& file() const;
  /// Number of a name, searched from the innermost turn outwards; nullptr if there is none.
  const double* number(std::string_view name) const;
  bool isBroken(std::string_view name) const;
  /// Those names in `wanted` that have a number, with their numbers.
  SymbolTable some(const std::vector<std::string>& wanted) const;
  /// All names with their numbers.
  SymbolTable all() const;
  std::size_t symbolCount() const;
};

/// Collects errors and adds the text of their lines. Every `add` throws ModelError with all errors
/// once there are too many (FaultList).
class Faults {
 public:
  void file(const XmlDocument& document) { files_[document.name()] = &document; }
  void add(const Scope& scope, const Place& place, const XmlNode& node, std::string text,
           std::string hint = {});
  /// Adds the errors of a part that failed; those without a place get the node's.
  void add(const ModelError& error, const Scope& scope, const XmlNode& node);
  /// Adds errors of a built model, with the text of their lines.
  void add(const ModelError& error);
  void add(Diagnostic diagnostic);
  std::size_t size() const { return all_.size(); }
  const std::vector<Diagnostic>& items() const { return all_.items(); }
  /// Throws ModelError if there is any.
  void throwIfAny() const { all_.throwIfAny(); }
  /// Throws ModelError and ends the reading.
  [[noreturn]] void stop() {
    stopped_ = true;
    all_.throwAll();
  }
  /// True: a ModelError thrown now ends the reading.
  bool ended() const { return stopped_ || all_.full(); }

 private:
  void fillLines(Diagnostic& d) const;
  std::map<std::string, const XmlDocument*, std::less<>> files_;
  FaultList all_;
  bool stopped_ = false;
};

/// Name of an element in `scope`: prefix + value of `name` + suffix; "" if it has no name or a
/// wrong one, which is reported.
std::string elementName(const XmlNode& node, const Scope& scope, const std::string& prefix,
                        Faults& faults);

/// Reports the text of a node that holds none.
void refuseText(const XmlNode& node, const Scope& scope, Faults& faults);

}  // namespace dynamy
