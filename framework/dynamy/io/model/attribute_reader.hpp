/// Reads the attributes of an XML element and checks them against their declaration. The value is
/// the first that exists of: own value, class default, default of the type, default of the
/// declaration. All faults are reported, each with its place.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/model/model_scope.hpp>
#include <span>

namespace dynamy {

struct ResolvedText;

/// Names of all elements of a model that others may refer to.
class NameTable {
 public:
  /// Enters a name; reports a second use of it.
  void declare(const std::string& name, Kind kind, const XmlNode& node, const Scope& scope,
               Faults& faults);
  /// Full name of the element that `name` means in `scope`, searched in the nearest turn of a
  /// replicate first, then in the nearest part; "" if there is none. `kind`: "system", "frame", …
  /// or "" for any.
  std::string resolve(const std::string& name, const Scope& scope, std::string_view kind) const;
  /// All names of a kind as they are written in `scope`, for "did you mean" hints.
  std::vector<std::string> known(const Scope& scope, std::string_view kind) const;

 private:
  struct Entry {
    Kind kind;
    Place place;
  };
  bool is(const std::string& name, std::string_view kind) const;
  std::map<std::string, Entry, std::less<>> names_;
};

class AttributeReader {
 public:
  /// `names` null: references are not resolved.
  AttributeReader(Faults& faults, const NameTable* names) : faults_(&faults), names_(names) {}

  /// Fills x.values with one value for each attribute in `declared`. `common`: further attributes
  /// that are allowed (name, class). False: an error was reported.
  bool read(const XmlNode& node, const Scope& scope, const Attributes& declared,
            std::span<const std::string_view> common, Parameters& x) const;
  /// Whether the node has an undeclared attribute that probably means `name`.
  static bool isMisspelt(const std::string& name, const XmlNode& node, const Attributes& declared,
                         std::span<const std::string_view> common);
  /// Reports attributes of the node that are not declared; false if there are any.
  bool allDeclared(const XmlNode& node, const Scope& scope, const Attributes& declared,
                   std::span<const std::string_view> common) const;

 private:
  struct Source {
    const XmlNode* node;
    const Scope* scope;
  };
  bool sources(const XmlNode& node, const Scope& scope, std::vector<Source>& out) const;
  bool readOne(const Source& source, const XmlAttribute& written, const XmlNode& node,
               const Scope& scope, ParameterValue& value) const;
  void nameSignals(const Scope& scope, ResolvedText& text) const;
  bool resolveReferences(const Source& source, const XmlAttribute& written, const Scope& scope,
                         const ResolvedText& text, ParameterValue& value) const;
  Faults* faults_;
  const NameTable* names_;
};

}  // namespace dynamy
