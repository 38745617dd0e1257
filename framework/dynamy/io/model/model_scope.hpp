/// Scope: what a value of a model file may refer to: parameters, indices, the prefix of its names.
/// Also the collector of errors, which knows the lines of all files read.
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

/// Attributes of `<defaults>`: type → class ("" for all) → where they stand.
struct DefaultEntry {
  const XmlNode* node = nullptr;
  const Scope* scope = nullptr;
};
using DefaultsTable = std::map<std::string, std::map<std::string, DefaultEntry>>;

/// A file that is being read, or one turn of a replicate inside of it, which holds its index only
/// and finds all else in the scope around it.
struct Scope {
  const Scope* outer = nullptr;  ///< around a turn; null for a file
  const XmlDocument* document = nullptr;
  std::string prefix;  ///< of names: "left/"
  std::string suffix;  ///< of names: "[2]"
  std::map<std::string, double, std::less<>>
      numbers;  ///< parameters of the file, or the turn's index

  // Of a file only.
  std::filesystem::path folder;
  std::set<std::string, std::less<>>
      broken;  ///< names whose own value is wrong: their users stay silent
  DefaultsTable defaults;
  bool defaultsAreBroken = false;  ///< what lacks an attribute stays silent
  /// Values that were resolved once; compiled from the second time on.
  mutable std::unordered_map<const XmlAttribute*, std::shared_ptr<CompiledBraces>> braces;

  const Scope& file() const;
  /// Number behind a name, from the innermost turn outwards; nullptr if there is none.
  const double* number(std::string_view name) const;
  bool isBroken(std::string_view name) const;
  /// The names of `wanted` that have a number.
  SymbolTable some(const std::vector<std::string>& wanted) const;
  /// All names with their numbers.
  SymbolTable all() const;
  std::size_t symbolCount() const;
};

/// Collects errors and gives them the line they stand in. Every `add` throws ModelError with all
/// errors once there are too many (FaultList).
class Faults {
 public:
  void file(const XmlDocument& document) { files_[document.name()] = &document; }
  void add(const Scope& scope, const Place& place, const XmlNode& node, std::string text,
           std::string hint = {});
  /// Adds the errors of a part that failed; those without a place get the node's.
  void add(const ModelError& error, const Scope& scope, const XmlNode& node);
  /// Adds errors of a built model; their places get their lines.
  void add(const ModelError& error);
  void add(Diagnostic diagnostic);
  std::size_t size() const { return all_.size(); }
  const std::vector<Diagnostic>& items() const { return all_.items(); }
  /// Throws ModelError if there is any.
  void throwIfAny() const { all_.throwIfAny(); }
  /// Throws ModelError: nothing more is read.
  [[noreturn]] void stop() {
    stopped_ = true;
    all_.throwAll();
  }
  /// What is thrown now ends the reading.
  bool ended() const { return stopped_ || all_.full(); }

 private:
  void fillLines(Diagnostic& d) const;
  std::map<std::string, const XmlDocument*, std::less<>> files_;
  FaultList all_;
  bool stopped_ = false;
};

/// Name that an element in `scope` gets: prefix + value of `name` + suffix; "" without name or with
/// a wrong one, which is reported.
std::string elementName(const XmlNode& node, const Scope& scope, const std::string& prefix,
                        Faults& faults);

}  // namespace dynamy
