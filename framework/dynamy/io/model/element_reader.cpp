#include <algorithm>
#include <array>
#include <dynamy/core/declared/formula_fault.hpp>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/io/model/braces.hpp>
#include <dynamy/io/model/element_reader.hpp>
#include <dynamy/io/model/unknown_element.hpp>
#include <limits>
#include <new>
#include <set>

namespace dynamy {
namespace {

const std::string kSideBySide =
    "bodies stand side by side; a joint in <elements> connects two of them: <Revolute between=\"A "
    "B\" "
    "axis=\"…\"/>";

constexpr std::array<std::string_view, 2> kNameAndClass{"name", "class"};

/// Up to this number, all names are given to every element, so that its messages can list and
/// suggest them.
constexpr std::size_t kFewSymbols = 100;

/// Words of all formulas that an element may read: its own, those of its children and of its
/// defaults.
void wordsOf(const XmlNode& node, const Scope& scope, std::vector<std::string>& words) {
  for (const XmlAttribute& a : node.attributes) namesIn(a.value, words);
  const DefaultsTable& defaults = scope.file().defaults;
  if (const auto at = defaults.find(node.tag); at != defaults.end())
    for (const auto& [name, entry] : at->second)
      if (entry.node != nullptr)
        for (const XmlAttribute& a : entry.node->attributes) namesIn(a.value, words);
  for (const XmlNode& child : node.children) wordsOf(child, scope, words);
}

/// Numbers for the formulas of an element. If there are many parameters, it gets only those named
/// in its text: thousands of parameters would otherwise be copied in thousands of turns.
std::vector<std::pair<std::string, double>> symbolsFor(const XmlNode& node, const Scope& scope) {
  SymbolTable table;
  std::set<std::string, std::less<>> broken;
  if (scope.symbolCount() <= kFewSymbols) {
    table = scope.all(), broken = scope.file().broken;
  } else {
    std::vector<std::string> words;
    wordsOf(node, scope, words);
    table = scope.some(words);
    for (const std::string& word : words)
      if (scope.isBroken(word)) broken.insert(word);
  }
  std::vector<std::pair<std::string, double>> out;
  for (const std::string& name : table.names()) out.emplace_back(name, table.find(name)->value);
  for (const std::string& name : broken)  // reported already: no second error in a formula
    out.emplace_back(name, std::numeric_limits<double>::quiet_NaN());
  return out;
}

/// "1 law", "2 shapes".
std::string counted(int n, const ChildRule& rule) {
  const std::string what =
      rule.only.empty() ? std::string(kindText(rule.kind)) : '<' + rule.only + '>';
  return std::to_string(n) + ' ' + what + (n == 1 || !rule.only.empty() ? "" : "s");
}

/// What a child is, with the example of its parent if that has children.
std::string exampleOf(const std::string& text, const std::string& example) {
  return example.find("</") == std::string::npos ? text : text + ", as in " + example;
}

bool fits(const ChildRule& rule, const RegisteredType& type) {
  return rule.kind == type.kind && (rule.only.empty() || rule.only == type.name);
}

/// Throws ModelError unless the user trusts the folder of the file with code that `value` names.
void requireTrust(const ParameterValue& value, const PluginLoader& plugins) {
  try {
    plugins.requireTrust(value.existingFile(), "file",
                         "copy it to a folder that only you may write");
  } catch (const ModelError& e) {
    if (e.diagnostics().front().place.file.empty())
      throw value.fault(e.diagnostics().front().text, e.diagnostics().front().hint, 0,
                        value.text.size());
    throw;
  }
}

}  // namespace

/// "it is an attribute: <RigidBody mass="…">" for a child <mass> of <RigidBody>; else "".
std::string ElementReader::asAttribute(const std::string& tag, const std::string& parent) const {
  const RegisteredType* type = registry_->find(parent);
  const Word* word = source_->vocabulary().find(parent);
  const Attributes* declared = type != nullptr   ? &type->attributes
                               : word != nullptr ? &word->attributes
                                                 : nullptr;
  if (declared == nullptr || declared->find(tag) == nullptr) return {};
  return "it is an attribute: <" + parent + ' ' + tag + "=\"…\">";
}

void ElementReader::unknownElement(const XmlNode& node, const Scope& scope, const XmlNode& parent,
                                   const std::vector<std::string>& allowed) {
  std::string hint = asAttribute(node.tag, parent.tag);
  if (hint.empty()) {
    hint = meantElement(node.tag, allowed, *registry_, source_->vocabulary());
    const std::optional<std::string> library = source_->libraryOf(node.tag);
    // The plug-in that may bring the element is reported already; only misspelt names are not of it.
    if (!library && !hint.starts_with("did you mean")) return;
    if (hint.empty() && library && !library->empty())
      hint = "the plug-in \"" + *library + "\" is not loaded; add <plugin library=\"" + *library +
             "\"/> below <dynamy>";
  }
  const RegisteredType* outer = registry_->find(parent.tag);
  if (outer != nullptr && outer->kind == Kind::system && hint.ends_with("<systems>"))
    hint += ": " + kSideBySide;
  if (hint.empty() && !allowed.empty()) hint = "known here: " + quotedList(allowed);
  faults_->add(scope, node.place, parent, "unknown element <" + node.tag + '>', std::move(hint));
}

const RegisteredType* ElementReader::typeIn(const Word& section, const XmlNode& node,
                                            const Scope& scope, const XmlNode& parent) {
  const RegisteredType* type = registry_->find(node.tag);
  const auto allowed = [&](const RegisteredType& t) {
    return std::find(section.kinds.begin(), section.kinds.end(), t.kind) != section.kinds.end();
  };
  if (type != nullptr && allowed(*type)) return type;
  if (type != nullptr) {
    faults_->add(
        scope, node.place, parent,
        "<" + node.tag + "> is " + kindWithArticle(type->kind) + rightPlace(*type, *registry_));
    return nullptr;
  }
  std::vector<std::string> names;
  for (const RegisteredType* t : registry_->types())
    if (allowed(*t)) names.push_back(t->name);
  unknownElement(node, scope, parent, names);
  return nullptr;
}

std::unique_ptr<Element> ElementReader::read(const XmlNode& node, const Scope& scope,
                                             const RegisteredType& type, std::string name) {
  Parameters x;
  x.type = type.name;
  x.name = std::move(name);
  x.place = node.place;
  x.declaration = &type.attributes;
  x.symbols = symbolsFor(node, scope);
  bool good = attributes_.read(node, scope, type.attributes, kNameAndClass, x);
  good = readChildren(node, scope, type, x) && good;
  if (!good) return nullptr;
  try {
    for (const ParameterValue& value : x.values)
      if (value.given && value.declaration->code) requireTrust(value, *plugins_);
    return type.make(x);
  } catch (const ModelError& e) {
    faults_->add(e, scope, node);
  } catch (const ExpressionError& e) {
    faults_->add(scope, node.place, node, e.message(), formulaHint(e));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {  // an exception of a plug-in or of a library that it uses
    faults_->add(scope, node.place, node, "its constructor failed: " + std::string(e.what()), "");
  }
  return nullptr;
}

bool ElementReader::readChildren(const XmlNode& node, const Scope& scope,
                                 const RegisteredType& type, Parameters& x) {
  const std::vector<ChildRule>& rules = type.attributes.children();
  std::vector<int> counts(rules.size(), 0);
  const std::size_t before = faults_->size();
  bool good = true;
  source_->forEachChild(node, scope, [&](const XmlNode& child, const Scope& inner) {
    good = readChild(child, inner, node, type, counts, x) && good;
  });

  // Checks that there are enough children of each kind.
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (counts[i] >= rules[i].min || !good) continue;
    faults_->add(scope, node.place, node,
                 "needs " + std::string(rules[i].max == rules[i].min ? "" : "at least ") +
                     counted(rules[i].min, rules[i]) + ", has " +
                     (counts[i] == 0 ? "none" : std::to_string(counts[i])),
                 exampleOf(rules[i].text, type.attributes.exampleText()));
  }
  return good && faults_->size() == before;
}

bool ElementReader::readChild(const XmlNode& child, const Scope& scope, const XmlNode& parent,
                              const RegisteredType& type, std::vector<int>& counts, Parameters& x) {
  const std::vector<ChildRule>& rules = type.attributes.children();
  const RegisteredType* found = registry_->find(child.tag);
  if (found == nullptr) {
    std::vector<std::string> allowed;
    for (const RegisteredType* t : registry_->types())
      if (std::any_of(rules.begin(), rules.end(), [&](const ChildRule& r) { return fits(r, *t); }))
        allowed.push_back(t->name);
    unknownElement(child, scope, parent, allowed);
    return false;
  }
  const auto rule =
      std::find_if(rules.begin(), rules.end(), [&](const ChildRule& r) { return fits(r, *found); });
  if (rule == rules.end()) {
    std::string takes;
    for (const ChildRule& r : rules)
      takes += (takes.empty() ? "" : ", ") +
               (r.only.empty() ? std::string(kindText(r.kind)) : '<' + r.only + '>');
    faults_->add(scope, child.place, parent,
                 "<" + child.tag + "> is " + kindWithArticle(found->kind) + "; <" + parent.tag +
                     (takes.empty() ? "> has no children" : "> takes: " + takes),
                 found->kind == Kind::system && type.kind == Kind::system
                     ? "put it into <systems>: " + kSideBySide
                     : std::string());
    return false;
  }
  int& count = counts[static_cast<std::size_t>(rule - rules.begin())];
  ++count;
  if (count > rule->max) {  // surplus children are not read
    if (count == rule->max + 1)
      faults_->add(scope, child.place, parent, "takes at most " + counted(rule->max, *rule));
    return false;
  }

  // Names of children live in their parent.
  std::string name = elementName(child, scope, {}, *faults_);
  for (const Parameters::Child& other : x.children)  // at most as many as the rules allow
    if (!name.empty() && other.element->name() == name) {
      Diagnostic d = scope.document->diagnostic(child.attribute("name")->valuePlace, child,
                                                "the name \"" + name + "\" is used already");
      d.notes.push_back({.place = other.element->place(), .text = "first used here"});
      faults_->add(std::move(d));
    }
  auto element = read(child, scope, *found, std::move(name));
  if (!element) return false;
  x.children.push_back({found->kind, std::move(element)});
  return true;
}

}  // namespace dynamy
