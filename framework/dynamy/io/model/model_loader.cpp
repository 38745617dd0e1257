#include <algorithm>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/model/settings_reader.hpp>
#include <dynamy/law/pair_laws.hpp>
#include <dynamy/simulation/equilibrium/equilibrium.hpp>
#include <dynamy/simulation/model/initial_values.hpp>
#include <dynamy/system/partial_mechanical_system.hpp>
#include <fstream>
#include <set>
#include <sstream>

namespace dynamy {
namespace {

/// An element of the model whose place is allowed for its type.
struct Placed {
  const ModelItem* item;
  const RegisteredType* type;
  std::string name;
};

/// Declares the names of an element that could not be placed, so that references to it give no
/// second error. The value of a misspelt attribute "name" counts, too.
void declareSilently(const XmlNode& node, const Scope& scope, NameTable& names) {
  Faults silent;
  const std::string name = elementName(node, scope, scope.prefix, silent);
  if (!name.empty()) names.declare(name, Kind::system, node, scope, silent);
  if (node.attribute("name") != nullptr) return;
  static const std::vector<std::string> kName{"name"};
  for (const XmlAttribute& a : node.attributes)
    if (!nearest(a.name, kName).empty())
      names.declare(scope.prefix + a.value + scope.suffix, Kind::system, node, scope, silent);
}

/// Finds types and names of all elements before any of them is created, because references may
/// point forward.
std::vector<Placed> placeElements(const ModelSource& source, ElementReader& reader,
                                  NameTable& names, Faults& faults) {
  std::vector<Placed> out;
  for (const ModelItem& item : source.elements()) {
    // The section is the parent in messages.
    XmlNode section;
    section.tag = item.section;
    const Word& word = *source.vocabulary().find(item.section);
    const RegisteredType* type = reader.typeIn(word, *item.node, *item.scope, section);
    if (type == nullptr) {
      declareSilently(*item.node, *item.scope, names);
      continue;
    }
    // Materials are shared by all files; a body may have the name of its material.
    const bool rule = type->kind == Kind::rule;
    std::string name = elementName(*item.node, *item.scope, rule ? "" : item.scope->prefix, faults);
    if (!name.empty() && !rule) names.declare(name, type->kind, *item.node, *item.scope, faults);
    if (item.node->attribute("name") == nullptr && type->kind == Kind::system)
      declareSilently(*item.node, *item.scope, names);
    out.push_back({&item, type, std::move(name)});
  }
  return out;
}

/// A rule with these values, as if it were written at `node`; null if the rule refuses the values,
/// too.
template <class Rule>
std::unique_ptr<Element> standInOf(const XmlNode& node, const std::string& name,
                                   const std::vector<GivenValue>& values) {
  try {
    Parameters x = Parameters::of<Rule>(node.tag, name, values);
    x.place = node.place;
    return std::make_unique<Rule>(x);
  } catch (const ModelError&) {  // reported already, with its place
    return nullptr;
  }
}

/// A substitute for a rule that could not be read: it marks the materials of the rule as covered.
/// Messages name the original element.
std::unique_ptr<Element> standIn(const XmlNode& node) {
  const XmlAttribute* name = node.attribute("name");
  if (node.tag == "Material" && name != nullptr)
    return standInOf<Material>(node, name->value, {{"mu", 1.0}});
  if (node.tag == "Contacts") return standInOf<MixingRule>(node, "", {{"mixing", "min"}});
  const XmlAttribute* between = node.attribute("between");
  if (between == nullptr || xmlWords(between->value).size() != 2) return nullptr;
  return standInOf<NoContactRule>(node, "", {{"between", between->value}});
}

/// The names of `between` in order; none if the element does not have the attribute.
std::vector<std::string> namesBetween(const XmlNode& node) {
  const XmlAttribute* between = node.attribute("between");
  if (between == nullptr) return {};
  std::vector<std::string> names;
  for (const XmlWord& word : xmlWords(between->value)) names.emplace_back(word.text);
  std::sort(names.begin(), names.end());
  return names;
}

using Parts = std::vector<std::pair<Kind, std::unique_ptr<Element>>>;

/// Adds a rule for each element that could not be read. False if one of them may have been a rule
/// for unknown materials: then pairs without a law must not give further errors.
bool addStandIns(const ModelSource& source, const Registry& registry,
                 const std::set<const ModelItem*>& good, Parts& parts) {
  bool all = true;
  std::set<std::vector<std::string>> covered;
  for (const ModelItem* item : good)
    if (const RegisteredType* type = registry.find(item->node->tag);
        type != nullptr && type->kind == Kind::rule)
      covered.insert(namesBetween(*item->node));
  for (const ModelItem& item : source.elements()) {
    if (good.contains(&item)) continue;
    const RegisteredType* type = registry.find(item.node->tag);
    // The two names of a joint are no materials.
    const bool mayBeRule = type == nullptr || type->kind == Kind::rule;
    if (type == nullptr && covered.contains(namesBetween(*item.node))) continue;
    if (auto rule = mayBeRule ? standIn(*item.node) : nullptr)
      parts.emplace_back(Kind::rule, std::move(rule));
    else if (item.section == "elements" && mayBeRule)
      all = false;
  }
  return all;
}

/// False if a section, an included file or a plug-in is missing: it may hold the missing rules.
bool allElementsAreKnown(const Faults& faults) {
  return std::all_of(faults.items().begin(), faults.items().end(), [](const Diagnostic& d) {
    return d.element.starts_with("parameter") || d.element.starts_with("set") ||
           d.text.starts_with("the file includes itself");
  });
}

/// Adds errors of the model as a whole. Errors without an element get the place of the root.
void addOfModel(Faults& faults, const ModelError& error, const XmlDocument& document) {
  for (Diagnostic d : error.diagnostics()) {
    if (d.place.line <= 0) d.place = document.root().place;
    faults.add(std::move(d));
  }
}

/// Models with more frames than this are not built just to find further faults.
constexpr long kMostFrames = 100'000;

bool isHuge(const Parts& parts) {
  long frames = 0;
  for (const auto& [kind, element] : parts)
    if (kind == Kind::system)
      frames += static_cast<const PartialMechanicalSystem&>(*element).frames();
  return frames > kMostFrames;
}

/// Reports pairs of materials that no rule covers, even if other faults prevent the model from
/// being built. Moves systems and rules out of `parts`.
void findUncoveredPairs(Parts& parts, const Registry& registry, const XmlDocument& document,
                        Faults& faults) {
  Model partial;
  for (auto& [kind, element] : parts)
    if (kind == Kind::system || kind == Kind::rule) partial.add(kind, std::move(element));
  for (const Registry::Completion& completion : registry.completions())
    partial.addCompletion(completion);
  try {
    partial.build();
  } catch (const ModelError& e) {
    std::vector<Diagnostic> found = e.diagnostics();
    for (Diagnostic& d : found)
      std::erase_if(d.notes, [](const auto& note) { return note.text.starts_with(kNoShapeHas); });
    addOfModel(faults, ModelError(std::move(found)), document);
  }
}

std::string documentation(const XmlNode& root) {
  std::string out;
  for (const XmlNode& node : root.children)
    if (node.tag == "doc") out += (out.empty() ? "" : "\n") + node.text;
  return out;
}

/// Where the program chose coordinates of joints: throws ModelError unless all that is needed exists
/// in them.
void requireNeeded(const Model& model, const LoadOptions& options) {
  if ((model.composed.coordinates == 0 && model.composed.flat == 0) ||
      model.simulation.coordinates != JointCoordinates::automatic)
    return;
  const auto refuse = [&](const std::string& name, const std::string& what) {
    if (options.parameters == nullptr || !options.parameters->contains(name))
      throw ModelError('"' + name + "\" is no " + what +
                       " of a mechanism in coordinates of its joints");
  };
  for (const std::string& name : options.signals)
    if (model.signal(name) == nullptr) refuse(name, "signal");
  if (options.numbers.empty()) return;
  const std::vector<std::string> known = namesOfState(model);
  for (const std::string& name : options.numbers)
    if (std::find(known.begin(), known.end(), name) == known.end()) refuse(name, "coordinate");
}

/// Throws ModelError with all faults of the model as a whole.
void build(Model& model, const SettingsReader& settings, const LoadOptions& options,
           const XmlDocument& document, Faults& faults) {
  try {
    model.build();
  } catch (const ModelError& e) {
    addOfModel(faults, e, document);
    faults.throwIfAny();
  }
  settings.verifySignals();
  faults.throwIfAny();
  requireNeeded(model, options);
}

template <class Read>
Model load(Registry& registry, PluginLoader& plugins, const LoadOptions& options, const Read& read);

/// Lets runs of the model start at its equilibrium.
template <class Read>
void seekStart(Model& model, Registry& registry, PluginLoader& plugins, const LoadOptions& options,
               const Read& read, Faults& faults) {
  // The search runs a model of its own, so that no scheme remembers it.
  LoadOptions again = options;
  again.seek = false, again.files = nullptr, again.parameters = nullptr, again.orbit = nullptr;
  Model other = load(registry, plugins, again, read);
  try {
    model.simulation.from =
        std::make_shared<const State>(equilibrium(other, other.initialState()).at);
  } catch (const ModelError& e) {
    Diagnostic d = e.diagnostics().front();
    d.place = model.simulation.place, d.element = "simulation start=\"equilibrium\"";
    faults.add(std::move(d));
    faults.throwIfAny();
  }
}

/// The model with all joints as constraints: what the program chose is no reason to refuse it.
/// `why`: the errors that it has with coordinates of joints.
template <class Read>
Model loadWithJoints(const ModelError& why, Registry& registry, PluginLoader& plugins,
                     LoadOptions options, const Read& read) {
  options.coordinates = JointCoordinates::absolute;
  Model out = load(registry, plugins, options, read);
  out.composed.notes.push_back("bodies keep their own coordinates, since elements need them: " +
                               why.diagnostics().front().text);
  return out;
}

template <class Read>
Model load(Registry& registry, PluginLoader& plugins, const LoadOptions& options,
           const Read& read) {
  Faults faults;
  ModelSource source(registry, plugins, options.set, faults);
  source.noteInto(options.files, options.parameters);
  read(source);
  const bool whole = allElementsAreKnown(faults);

  // Elements, in the order of the file.
  Model model;
  NameTable names;
  ElementReader reader(registry, names, source, plugins, faults);
  Parts parts;
  std::set<const ModelItem*> good;
  for (const Placed& p : placeElements(source, reader, names, faults)) {
    auto element = reader.read(*p.item->node, *p.item->scope, *p.type, p.name);
    if (!element) continue;
    parts.emplace_back(p.type->kind, std::move(element));
    good.insert(p.item);
  }
  SettingsReader settings(model, source, reader, faults, options.orbit, options.until);
  for (const ModelItem& item : source.settings()) settings.read(item);

  SimulationSettings& simulation = model.simulation;
  if (options.coordinates)
    simulation.coordinates = *options.coordinates;
  else if (simulation.coordinatesPlace.line == 0)
    simulation.coordinates = JointCoordinates::automatic;

  simulation.reduce = options.reduce && simulation.start == Start::given &&
                      simulation.coordinates == JointCoordinates::automatic;

  // The model stores its title, text and file.
  model.file.name = source.document().name();
  model.doc = documentation(source.document().root());
  model.title = source.title().empty() ? std::filesystem::path(model.file.name).stem().string()
                                       : source.title();
  for (const Registry::Completion& completion : registry.completions())
    model.addCompletion(completion);
  if (faults.size() > 0 && whole && addStandIns(source, registry, good, parts) && !isHuge(parts))
    findUncoveredPairs(parts, registry, source.document(), faults);
  faults.throwIfAny();
  for (auto& [kind, element] : parts) model.add(kind, std::move(element));
  if (options.prepare) options.prepare(model);
  if (!options.build) return model;
  try {
    build(model, settings, options, source.document(), faults);
  } catch (const ModelError& e) {
    const Composition& made = model.composed;
    if (simulation.coordinates != JointCoordinates::automatic ||
        (made.coordinates == 0 && made.flat == 0))
      throw;
    return loadWithJoints(e, registry, plugins, options, read);
  }
  if (model.simulation.start == Start::equilibrium && options.seek)
    seekStart(model, registry, plugins, options, read, faults);
  return model;
}

}  // namespace

Model loadModel(const std::filesystem::path& file, Registry& registry, PluginLoader& plugins,
                const LoadOptions& options) {
  Model model = load(registry, plugins, options, [&](ModelSource& s) { s.read(file); });
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  model.file.text = text.str();
  return model;
}

Model loadModelText(std::string text, const std::string& name, Registry& registry,
                    PluginLoader& plugins, const LoadOptions& options,
                    const std::filesystem::path& folder) {
  Model model =
      load(registry, plugins, options, [&](ModelSource& s) { s.parse(text, name, folder); });
  model.file.text = std::move(text);
  return model;
}

}  // namespace dynamy
