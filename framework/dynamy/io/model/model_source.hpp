/// ModelSource: the files of a model as one flat list of elements: includes are followed,
/// replicates unrolled, parameters evaluated, defaults collected, plug-ins loaded.
#pragma once
#include <deque>
#include <dynamy/io/model/attribute_reader.hpp>
#include <dynamy/io/model/parameter_overrides.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/io/xml/vocabulary.hpp>
#include <optional>

namespace dynamy {

/// An element or a word of the format, with its scope.
struct ModelItem {
  const XmlNode* node = nullptr;
  const Scope* scope = nullptr;
  std::string section;  ///< "systems", "forces", "elements"; "" for simulation, record and check
};

class ModelSource {
 public:
  ModelSource(Registry& registry, PluginLoader& plugins, const Overrides& overrides,
              Faults& faults);
  /// Appends to `files` every file that is read from now on, and every file that is searched but
  /// missing, and adds to `parameters` the values of their parameters; null: neither.
  void noteInto(std::vector<std::filesystem::path>* files,
                std::map<std::string, double>* parameters) {
    noted_ = files, notedParameters_ = parameters;
  }

  /// Reads the model and all it includes. Throws ModelError if the first file cannot be read.
  void read(const std::filesystem::path& file);
  void parse(std::string text, std::string name, const std::filesystem::path& folder);

  const std::vector<ModelItem>& elements() const { return elements_; }
  const std::vector<ModelItem>& settings() const { return settings_; }  ///< of the first file
  const XmlDocument& document() const { return documents_.front(); }
  const Vocabulary& vocabulary() const { return vocabulary_; }
  const std::string& title() const { return title_; }
  /// Name of a plug-in that is not loaded and probably has this type, "" if there is none; no value
  /// if a plug-in was refused, so that unknown types probably belong to it.
  std::optional<std::string> libraryOf(std::string_view type) const {
    return typesAreMissing_ ? std::nullopt : std::optional(plugins_->libraryOf(type));
  }

  /// Calls `use(child, scope)` for the children of `node`, with replicates unrolled and without
  /// `<doc>`. Reports text that is not allowed there.
  template <class Use>
  void forEachChild(const XmlNode& node, const Scope& scope, const Use& use);

 private:
  struct Including {
    std::vector<std::filesystem::path> chain;  ///< canonical paths, outermost first
    const XmlNode* node = nullptr;             ///< `<include>`, null for the first file
    const Scope* scope = nullptr;
  };
  void addFile(XmlDocument document, const Including& from, std::filesystem::path folder);
  bool checkRoot(const XmlNode& root, const Scope& scope);
  void loadPlugins(const XmlNode& root, const Scope& scope);
  void readParameters(const XmlNode& root, Scope& scope, const Including& from);
  void walk(const XmlNode& parent, const Scope& scope, const Including& from, bool isRoot);
  void walkSection(const XmlNode& section, const Scope& scope);
  void include(const XmlNode& node, const Scope& scope, const Including& from);
  std::vector<const Scope*> turns(const XmlNode& replicate, const Scope& scope);
  void note(const std::filesystem::path& file) {
    if (noted_ != nullptr) noted_->push_back(file);
  }

  Registry* registry_;
  PluginLoader* plugins_;
  ParameterOverrides overrides_;
  Faults* faults_;
  std::vector<std::filesystem::path>* noted_ = nullptr;
  std::map<std::string, double>* notedParameters_ = nullptr;
  Vocabulary vocabulary_;
  std::deque<XmlDocument> documents_;
  std::size_t textSize_ = 0;    ///< bytes of all files
  std::size_t replicated_ = 0;  ///< elements that replicates have made
  std::deque<Scope> scopes_;
  std::vector<ModelItem> elements_, settings_;
  std::string title_;
  bool typesAreMissing_ = false;
};

template <class Use>
void ModelSource::forEachChild(const XmlNode& node, const Scope& scope, const Use& use) {
  refuseText(node, scope, *faults_);
  for (const XmlNode& child : node.children) {
    if (child.tag == "doc") continue;
    if (child.tag != "replicate") {
      use(child, scope);
      continue;
    }
    for (const Scope* turn : turns(child, scope)) forEachChild(child, *turn, use);
  }
}

}  // namespace dynamy
