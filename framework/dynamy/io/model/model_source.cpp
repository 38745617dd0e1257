#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/model/model_defaults.hpp>
#include <dynamy/io/model/model_source.hpp>
#include <dynamy/io/model/unknown_element.hpp>

namespace dynamy {

namespace fs = std::filesystem;

namespace {

/// True for attributes of the root that only XML itself and editors need.
bool isSchemaAttribute(const std::string& name) {
  return name == "xmlns" || name.starts_with("xmlns:") || name.starts_with("xsi:");
}

std::string joined(const std::vector<fs::path>& chain) {
  std::string out;
  for (const fs::path& p : chain) out += (out.empty() ? "" : " → ") + p.filename().string();
  return out;
}

std::size_t elementsIn(const XmlNode& node) {
  std::size_t n = node.children.size();
  for (const XmlNode& child : node.children) n += elementsIn(child);
  return n;
}

/// Reads the attributes of a word of the format.
bool readWord(const XmlNode& node, const Scope& scope, const Vocabulary& vocabulary, Faults& faults,
              Parameters& x) {
  x.type = node.tag;
  return AttributeReader(faults, nullptr)
      .read(node, scope, vocabulary.find(node.tag)->attributes, {}, x);
}

/// Adds the files that elements name: tables, meshes. Those that are included are noted when read.
void addFilesOf(const XmlNode& node, const fs::path& folder, std::vector<fs::path>& files) {
  for (const XmlNode& child : node.children) {
    const XmlAttribute* a = child.tag == "include" ? nullptr : child.attribute("file");
    if (a != nullptr && !a->value.empty()) files.push_back(folder / a->value);
    addFilesOf(child, folder, files);
  }
}

fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path result = fs::weakly_canonical(path, error);
  return error ? path : result;
}

}  // namespace

ModelSource::ModelSource(Registry& registry, PluginLoader& plugins, const Overrides& overrides,
                         Faults& faults)
    : registry_(&registry), plugins_(&plugins), overrides_(overrides), faults_(&faults) {}

void ModelSource::read(const fs::path& file) {
  note(file);
  Including from;
  from.chain.push_back(resolved(file));
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  addFile(XmlDocument::read(file), from, folder);
}

void ModelSource::parse(std::string text, std::string name, const fs::path& folder) {
  Including from;
  from.chain.push_back(resolved(folder / name));
  addFile(XmlDocument::parse(std::move(text), std::move(name)), from, folder);
}

void ModelSource::addFile(XmlDocument document, const Including& from, fs::path folder) {
  textSize_ += document.size();
  documents_.push_back(std::move(document));
  Scope& scope = scopes_.emplace_back();
  scope.document = &documents_.back();
  scope.folder = std::move(folder);
  faults_->file(*scope.document);
  if (from.node != nullptr) {
    // An included file uses the defaults of the including file, but only its own parameters.
    scope.defaults = from.scope->file().defaults;
    scope.prefix = from.scope->prefix;
    scope.suffix = from.scope->suffix;
    Parameters x;
    if (readWord(*from.node, *from.scope, vocabulary_, *faults_, x) && !x["prefix"].text.empty()) {
      scope.prefix += x["prefix"].text;
      if (!scope.prefix.ends_with('/')) scope.prefix += '/';
    }
  }
  const XmlNode& root = scope.document->root();
  if (textSize_ > kMostText) {
    faults_->add(scope, root.place, root,
                 "all files of the model together hold more than " +
                     std::to_string(kMostText / 1000000) + " MB of text");
    faults_->stop();
  }
  if (!checkRoot(root, scope)) return;
  if (noted_ != nullptr) addFilesOf(root, scope.folder, *noted_);
  loadPlugins(root, scope);
  readParameters(root, scope, from);
  readDefaults(root, scope, *registry_, vocabulary_, *faults_);
  walk(root, scope, from, true);
  if (from.node == nullptr) overrides_.reportUnused(root, *faults_);
}

bool ModelSource::checkRoot(const XmlNode& root, const Scope& scope) {
  if (root.tag != "dynamy") {
    faults_->add(scope, root.place, root, "a model begins with <dynamy version=\"1\">",
                 meantFormat(root.tag));
    return false;
  }
  XmlNode own;  // copy of the root without the attributes of the schema
  own.tag = root.tag;
  own.place = root.place;
  for (const XmlAttribute& a : root.attributes)
    if (!isSchemaAttribute(a.name)) own.attributes.push_back(a);
  Parameters x;
  if (!AttributeReader(*faults_, nullptr)
           .read(own, scope, vocabulary_.find("dynamy")->attributes, {}, x))
    return false;
  if (x["version"].integer() != kModelVersion) {
    faults_->add(scope, x["version"].place, root,
                 "the format has version " + x["version"].text + ", this program reads version " +
                     std::to_string(kModelVersion),
                 "write version=\"" + std::to_string(kModelVersion) + '"');
    return false;
  }
  if (documents_.size() == 1) title_ = x["title"].text;
  refuseText(root, scope, *faults_);
  return true;
}

void ModelSource::loadPlugins(const XmlNode& root, const Scope& scope) {
  for (const XmlNode& node : root.children) {
    if (node.tag != "plugin") continue;
    Parameters x;
    if (!readWord(node, scope, vocabulary_, *faults_, x)) {
      typesAreMissing_ = true;
      continue;
    }
    for (const fs::path& file : plugins_->candidates(x["library"].text, scope.folder)) note(file);
    try {
      plugins_->load(x["library"].text, scope.folder, *registry_);
    } catch (const ModelError& e) {
      typesAreMissing_ = true;
      for (Diagnostic d : e.diagnostics()) {
        d.place = x["library"].place;
        d.element = node.label();
        faults_->add(std::move(d));
      }
    }
  }
}

void ModelSource::readParameters(const XmlNode& root, Scope& scope, const Including& from) {
  ParameterEvaluator evaluator(scope, *vocabulary_.find("parameter"), *faults_);
  for (const XmlNode& node : root.children)
    if (node.tag == "parameter") evaluator.add(node);
  // An unknown element may be a misspelt parameter: uses of its name give no further errors.
  for (const XmlNode& node : root.children)
    if (const XmlAttribute* name = node.attribute("name"); name && !vocabulary_.find(node.tag))
      if (!evaluator.has(name->value)) scope.broken.insert(name->value);
  const std::vector<std::string> known = evaluator.names();  // for hints

  // Values of <set> in the including file.
  for (std::size_t i = 0; from.node != nullptr && i < from.node->children.size(); ++i) {
    const XmlNode& set = from.node->children[i];
    Parameters x;
    if (set.tag != "set" || !readWord(set, *from.scope, vocabulary_, *faults_, x)) continue;
    const std::string& name = x["name"].text;
    if (!evaluator.has(name)) {
      faults_->add(*from.scope, x["name"].place, set,
                   "\"" + scope.document->name() + "\" has no parameter \"" + name + '"',
                   unknownNameHint(name, known));
      continue;
    }
    evaluator.replace(
        {name, x["value"], [this, &set, &from, place = x["value"].place](const std::string& fault) {
           faults_->add(*from.scope, place, set, fault);
         }});
  }

  overrides_.apply(scope, evaluator, *faults_);  // --set on the command line
  evaluator.evaluate();
  if (notedParameters_ == nullptr) return;
  for (const std::string& name : known)
    if (const double* value = scope.number(name)) (*notedParameters_)[scope.prefix + name] = *value;
}

/// Reads the children of the root, or of a replicate of whole sections.
void ModelSource::walk(const XmlNode& parent, const Scope& scope, const Including& from,
                       bool isRoot) {
  const Word& root = *vocabulary_.find("dynamy");
  for (const XmlNode& node : parent.children) {
    const std::string& tag = node.tag;
    const bool known =
        std::find(root.children.begin(), root.children.end(), tag) != root.children.end();
    const bool section = tag == "systems" || tag == "forces" || tag == "elements";
    if (section) {
      walkSection(node, scope);
    } else if (tag == "replicate") {
      refuseText(node, scope, *faults_);
      for (const Scope* turn : turns(node, scope)) walk(node, *turn, from, false);
    } else if (tag == "include") {
      include(node, scope, from);
    } else if (!known) {
      if (const RegisteredType* type = registry_->find(tag)) {
        faults_->add(
            scope, node.place, parent,
            "<" + tag + "> is " + kindWithArticle(type->kind) + rightPlace(*type, *registry_));
      } else {
        std::string hint = meantElement(tag, root.children, *registry_, vocabulary_);
        if (hint.empty()) hint = "known here: " + quotedList(root.children);
        faults_->add(scope, node.place, parent, "unknown element <" + tag + '>', std::move(hint));
      }
    } else if (!isRoot && tag != "doc") {
      faults_->add(scope, node.place, parent, "<" + tag + "> cannot be replicated");
    } else if (tag == "simulation" || tag == "record" || tag == "check" || tag == "orbit") {
      if (from.node == nullptr) settings_.push_back({&node, &scope, {}});
    }
  }
}

void ModelSource::walkSection(const XmlNode& section, const Scope& scope) {
  AttributeReader(*faults_, nullptr).allDeclared(section, scope, {}, {});
  forEachChild(section, scope, [&](const XmlNode& node, const Scope& inner) {
    elements_.push_back({&node, &inner, section.tag});
  });
}

void ModelSource::include(const XmlNode& node, const Scope& scope, const Including& from) {
  refuseText(node, scope, *faults_);
  for (const XmlNode& child : node.children)
    if (child.tag != "set" && child.tag != "doc")
      faults_->add(scope, child.place, node, "unknown element <" + child.tag + '>',
                   "known here: \"set\", \"doc\"");
  Parameters x;
  if (!readWord(node, scope, vocabulary_, *faults_, x)) return;
  const fs::path file = scope.file().folder / x["file"].text;
  note(file);
  Including inner{from.chain, &node, &scope};
  inner.chain.push_back(resolved(file));
  const auto& last = inner.chain.back();
  const Place& place = x["file"].place;
  if (std::find(from.chain.begin(), from.chain.end(), last) != from.chain.end()) {
    faults_->add(scope, place, node, "the file includes itself: " + joined(inner.chain));
    return;
  }
  if (inner.chain.size() > kDeepestInclude) {
    faults_->add(scope, place, node,
                 "files are included deeper than " + std::to_string(kDeepestInclude));
    return;
  }
  if (documents_.size() > kMostIncludes) {
    faults_->add(scope, place, node,
                 "the model includes more than " + std::to_string(kMostIncludes) + " files",
                 "does each of them include several others?");
    faults_->stop();
  }
  try {
    XmlDocument document = XmlDocument::read(file.lexically_normal());
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    addFile(std::move(document), inner, folder);
  } catch (const ModelError& e) {
    if (faults_->ended()) throw;
    for (Diagnostic d : e.diagnostics()) {
      if (d.place.line <= 0) {  // no such file: the place is where it is named
        d.text = '"' + file.lexically_normal().string() + "\": " + d.text;
        if (!d.hint.starts_with("did you mean"))
          d.hint = "a path is relative to the file in which it stands";
        d.place = x["file"].place;
        d.element = node.label();
      }
      faults_->add(std::move(d));
    }
  }
}

/// Makes one scope for each turn of a replicate, with the index as its number.
std::vector<const Scope*> ModelSource::turns(const XmlNode& replicate, const Scope& scope) {
  Parameters x;
  if (!readWord(replicate, scope, vocabulary_, *faults_, x)) return {};
  const auto count = static_cast<std::size_t>(x["count"].integer());
  const auto tooMany = [&](const std::string& what) {
    faults_->add(scope, x["count"].place, replicate,
                 "all replicates together make more than " + what,
                 "many equal bodies are better one population");
    return std::vector<const Scope*>();
  };
  if (scopes_.size() + count > kMostTurns) return tooMany(std::to_string(kMostTurns) + " turns");
  replicated_ += count * elementsIn(replicate);
  if (replicated_ > kMostReplicated) return tooMany(std::to_string(kMostReplicated) + " elements");
  std::vector<const Scope*> out;
  for (std::size_t i = 0; i < count; ++i) {
    Scope& turn = scopes_.emplace_back();
    turn.outer = &scope, turn.document = scope.document;
    turn.prefix = scope.prefix, turn.suffix = scope.suffix + '[' + std::to_string(i) + ']';
    turn.numbers[x["index"].text] = static_cast<double>(i);
    out.push_back(&turn);
  }
  return out;
}

}  // namespace dynamy
