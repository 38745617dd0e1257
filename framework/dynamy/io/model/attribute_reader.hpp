/// Reads the attributes of an XML element against their declaration: own value, class default,
/// default of the type, default of the declaration. All faults are reported, each with its place.
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
  /// Full name of what `name` means in `scope`: the nearest turn of a replicate, then the nearest
  /// part; "" if there is none. `kind`: "system", "frame", … or "" for any.
  std::string resolve(const std::string& name, const Scope& scope, std::string_view kind) const;
  /// All names of a kind, for "did you mean", as one writes them in `scope`.
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

  /// Fills x.values, one for each of `declared`. `common`: attributes that are allowed besides
  /// (name, class). False: something was wrong.
  bool read(const XmlNode& node, const Scope& scope, const Attributes& declared,
            std::span<const std::string_view> common, Parameters& x) const;
  /// Reports attributes of the node that are not declared.
  static bool isMisspelt(const std::string& name, const XmlNode& node, const Attributes& declared,
                         std::span<const std::string_view> common);
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
  bool resolveReferences(const Source& source, const XmlAttribute& written, const Scope& scope,
                         const ResolvedText& text, ParameterValue& value) const;
  Faults* faults_;
  const NameTable* names_;
};

}  // namespace dynamy
