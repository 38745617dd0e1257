#include "run/model_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <dynamy/io/model/braces.hpp>
#include <dynamy/io/xml/xml.hpp>
#include <dynamy/law/pair_laws.hpp>
#include <numbers>
#include <set>
#include <sstream>

namespace dynamy::app {
namespace {

constexpr int kMostNames = 5;

std::string lineOf(const Place& place) { return Place(place.file, place.line).format(); }

/// The materials of all shapes.
std::set<std::string> materialsOf(const Model& model) {
  std::set<std::string> out;
  for (const Description& d : model.descriptions())
    for (const PlacedShape& p : d.shapes)
      if (!p.shape->material().empty()) out.insert(p.shape->material());
  return out;
}

/// A newcomer may name bodies in the place of their materials, or forget the shape of the ground.
std::string whyIdle(const Model& model, const MaterialRule& rule) {
  const std::set<std::string> carried = materialsOf(model);
  std::string missing;
  for (const std::string& name : model.pairLaws().namesOf(rule)) {
    for (const auto& system : model.systems())
      if (system->name() == name)
        return '"' + name + "\" is a system; between=\"…\" names the materials of shapes";
    if (!carried.contains(name))
      missing += (missing.empty() ? std::string(kNoShapeHas) : " or ") + '"' + name + '"';
  }
  return missing.empty() ? "no shapes that can touch ask for it" : missing;
}

/// Shapes without a material take part in no contact, and bodies fall through each other.
std::string idleRules(const Model& model) {
  std::string out;
  for (const MaterialRule* rule : model.pairLaws().idle())
    out += fmt::format(" note: <{}{}> ({}) never acts: {}\n", rule->type(),
                       rule->name().empty() ? "" : " name=\"" + rule->name() + '"',
                       lineOf(rule->place()), whyIdle(model, *rule));
  return out;
}

/// A part that is included may bring a field of its own.
std::string severalGravities(const Model& model) {
  std::string places;
  int count = 0;
  for (const auto& force : model.forces()) {
    if (force->type() != "Gravity") continue;
    ++count;
    if (const std::string place = lineOf(force->place()); !place.empty())
      places += (places.empty() ? "" : ", ") + place;
  }
  if (count < 2) return {};
  return fmt::format(" note: {} <Gravity>{} act together: their accelerations add up\n", count,
                     places.empty() ? "" : " (" + places + ")");
}

std::string longStep(const Model& model) {
  const SimulationSettings& s = model.simulation;
  if (model.scheme().choosesSteps() || !(s.step > s.until)) return {};
  return fmt::format(
      " note: the step, {:g} s, is longer than the run: one step of {:g} s is taken\n", s.step,
      s.until);
}

/// Calls f(node) for all elements below `node`, and for it.
template <class F>
void forAll(const XmlNode& node, const F& f) {
  f(node);
  for (const XmlNode& child : node.children) forAll(child, f);
}

/// Numbers of a value without formulas; none if there are others than numbers in it.
std::vector<double> numbersOf(const XmlAttribute* a) {
  std::vector<double> out;
  if (a == nullptr) return out;
  for (const XmlWord& word : xmlWords(a->value)) {
    const std::string text(word.text);
    char* end = nullptr;
    out.push_back(std::strtod(text.c_str(), &end));
    if (*end != '\0') return {};
  }
  return out;
}

/// Parameters of the file that no value in it uses.
std::string unusedParameters(const XmlNode& root) {
  std::set<std::string> used;
  std::vector<std::string> words;
  forAll(root, [&](const XmlNode& node) {
    if (node.tag == "doc") return;
    for (const XmlAttribute& a : node.attributes)
      if (a.name != "name" || (node.tag != "parameter" && node.tag != "set"))
        namesIn(a.value, words);
    namesIn(node.text, words);
  });
  used.insert(words.begin(), words.end());
  std::string out;
  for (const XmlNode& node : root.children)
    if (const XmlAttribute* name = node.tag == "parameter" ? node.attribute("name") : nullptr;
        name != nullptr && !used.contains(name->value))
      out += fmt::format(
          " note: the parameter \"{}\" ({}) is not used: a value refers to it by {{{}}}\n",
          name->value, lineOf(node.place), name->value);
  return out;
}

/// "0 0 0 1" is no turn for programs whose quaternions end with the real part.
std::string realPartLast(const XmlNode& root) {
  std::string out;
  forAll(root, [&](const XmlNode& node) {
    const XmlAttribute* a = node.attribute("orientation");
    if (numbersOf(a) == std::vector<double>{0.0, 0.0, 0.0, 1.0})
      out += fmt::format(
          " note: orientation=\"{}\" ({}) turns by 180° about z, since the real part comes first; "
          "\"1 0 0 0\" does not turn\n",
          a->value, lineOf(a->valuePlace));
  });
  return out;
}

/// "45" is an angle of seven turns, since plain numbers are radians.
std::string manyTurns(const XmlNode& root) {
  std::string out;
  forAll(root, [&](const XmlNode& node) {
    for (const char* name : {"angle", "euler"}) {
      const XmlAttribute* a = node.attribute(name);
      double largest = 0.0;
      for (const double x : numbersOf(a)) largest = std::max(largest, std::abs(x));
      if (largest > 2.0 * std::numbers::pi)
        out += fmt::format(
            " note: {}=\"{}\" ({}): {:g} is in radians, {:.3g} turns; degrees are written "
            "{:g}deg\n",
            name, a->value, lineOf(a->valuePlace), largest, largest / (2.0 * std::numbers::pi),
            largest);
    }
  });
  return out;
}

/// A field of gravity that pulls bodies away from a plane of the ground.
std::string upwardGravity(const XmlNode& root) {
  const XmlNode *gravity = nullptr, *plane = nullptr;
  std::vector<double> pull;
  forAll(root, [&](const XmlNode& node) {
    if (node.tag != "Gravity") return;
    std::vector<double> g = numbersOf(node.attribute("acceleration"));
    if (node.attribute("acceleration") == nullptr) g = {0.0, 0.0, -9.81};  // its default
    if (g.size() == 3) gravity = &node, pull = g;
  });
  if (gravity == nullptr) return {};
  forAll(root, [&](const XmlNode& node) {
    if (node.tag != "Ground" || node.attribute("orientation") || node.attribute("euler")) return;
    for (const XmlNode& shape : node.children) {
      if (shape.tag != "HalfSpace" || shape.attribute("orientation")) continue;
      std::vector<double> n = numbersOf(shape.attribute("normal"));
      if (shape.attribute("normal") == nullptr) n = {0.0, 0.0, 1.0};
      if (n.size() != 3) continue;
      const double along = pull[0] * n[0] + pull[1] * n[1] + pull[2] * n[2];
      const double sizes = std::hypot(pull[0], pull[1], pull[2]) * std::hypot(n[0], n[1], n[2]);
      if (along > 0.99 * sizes) plane = &shape;
    }
  });
  if (plane == nullptr) return {};
  // Gravity downward along z is as most models have it: then the plane is upside down.
  if (pull[2] < 0.0 && pull[0] == 0.0 && pull[1] == 0.0)
    return fmt::format(
        " note: <Gravity> ({}) pulls bodies away from <HalfSpace> ({}): its normal points out of "
        "the "
        "ground to where the bodies are, normal=\"0 0 1\"\n",
        lineOf(gravity->place), lineOf(plane->place));
  return fmt::format(
      " note: <Gravity> ({}) pulls bodies away from <HalfSpace> ({}): its acceleration points to "
      "where they fall, \"0 0 -9.81\"\n",
      lineOf(gravity->place), lineOf(plane->place));
}

/// True: the element is a body, or ground that does not move.
bool movesByForcesAlone(const XmlNode& node) {
  static const std::set<std::string, std::less<>> kBodies{"RigidBody", "PlanarBody", "PointMass",
                                                          "doc"};
  const bool rests = node.tag == "Ground" && node.attribute("motion") == nullptr &&
                     node.attribute("rotation") == nullptr;
  return rests || kBodies.contains(node.tag);
}

/// No force acts and nothing drives: a newcomer may expect gravity by itself.
std::string nothingMoves(const Model& model, const XmlNode& root) {
  static const std::set<std::string, std::less<>> kOnlyHold{"Contact", "Contacts", "Material",
                                                            "NoContact", "doc"};
  const State x = model.initialState();
  bool rests = model.forces().empty() && x.u.size() > 0 && x.u.isZero(0.0);
  for (const XmlNode& section : root.children) {
    rests = rests && section.tag != "include" && section.tag != "plugin";
    for (const XmlNode& node : section.children) {
      if (section.tag == "elements") rests = rests && kOnlyHold.contains(node.tag);
      if (section.tag == "systems") rests = rests && movesByForcesAlone(node);
    }
  }
  return rests ? " note: nothing moves: no force acts, and all bodies begin at rest; <Gravity/> in "
                 "<forces> lets them fall\n"
               : std::string();
}

/// Bodies and ground with shapes, of which at most one has a material, and nothing else that could hold them.
std::string noMaterials(const Model& model, const XmlNode& root) {
  std::ptrdiff_t shaped = 0, touchable = 0;
  for (const Description& d : model.descriptions()) {
    shaped += d.shapes.empty() ? 0 : 1;
    touchable += std::any_of(d.shapes.begin(), d.shapes.end(),
                             [](const PlacedShape& p) { return !p.shape->material().empty(); });
  }
  const bool falls =
      std::all_of(root.children.begin(), root.children.end(), [](const XmlNode& section) {
        const std::vector<XmlNode>& nodes = section.children;
        if (section.tag == "include" || section.tag == "plugin" || section.tag == "replicate")
          return false;
        if (section.tag == "elements") return nodes.empty();
        if (section.tag == "systems")
          return std::all_of(nodes.begin(), nodes.end(), movesByForcesAlone);
        return section.tag != "forces" ||
               std::all_of(nodes.begin(), nodes.end(),
                           [](const XmlNode& node) { return node.tag == "Gravity"; });
      });
  if (!falls || shaped < 2 || touchable > 1) return {};
  return fmt::format(
      " note: {} a material: bodies pass through each other and through the ground\n",
      touchable == 0 ? "no shape has" : "only one body or ground has a shape with");
}

/// The two bodies of an attribute between="A.frame B"; of copies the name without its index. Empty: it has
/// others.
std::pair<std::string, std::string> bodiesBetween(const XmlNode& node) {
  const XmlAttribute* a = node.attribute("between");
  if (a == nullptr) return {};
  std::istringstream words(a->value);
  std::string first, second, more;
  if (!(words >> first >> second) || words >> more) return {};
  for (std::string* name : {&first, &second})
    name->resize(std::min(name->size(), name->find_first_of(".[{")));
  return {first, second};
}

/// True: the element acts in the coordinate of a joint.
bool actsAtJoint(const XmlNode& node) {
  static const std::set<std::string, std::less<>> kAtJoint{
      "JointMotor",    "JointDrive", "JointStop",   "JointSpring",
      "JointFriction", "JointForce", "PdController"};
  return kAtJoint.contains(node.tag);
}

/// Calls f(element) for all elements of all sections, also those of replicates.
template <class F>
void forElements(const XmlNode& node, const F& f) {
  for (const XmlNode& child : node.children) f(child), forElements(child, f);
}

/// Bodies that joints hold; `all`: also those between which motors, stops and springs act.
std::set<std::string> joinedBodies(const XmlNode& root, bool all) {
  std::set<std::string> out;
  forElements(root, [&](const XmlNode& node) {
    const auto [first, second] = bodiesBetween(node);
    if (node.tag == "Contact" || node.tag == "NoContact" || (!all && actsAtJoint(node))) return;
    out.insert({first, second});
  });
  return out;
}

std::string withoutIndex(const std::string& name) { return name.substr(0, name.find('[')); }

/// Free bodies whose shapes have no material, beside others that have one: they pass through everything.
std::string untouched(const Model& model, const XmlNode& root) {
  const bool asked = !model.pairLaws().found().empty() || !model.pairLaws().idle().empty();
  if (!asked || materialsOf(model).empty()) return {};
  const std::set<std::string> held = joinedBodies(root, true);
  std::string names;
  int count = 0;
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    const std::vector<PlacedShape>& shapes = model.descriptions()[i].shapes;
    const std::string& name = model.systems()[i]->name();
    const auto passes = [](const PlacedShape& p) { return p.shape->material().empty(); };
    const bool still = model.topology().system(static_cast<int>(i)).nu == 0;
    if (still || shapes.empty() || held.contains(withoutIndex(name))) continue;
    if (!std::all_of(shapes.begin(), shapes.end(), passes)) continue;
    if (++count <= kMostNames) names += (names.empty() ? "\"" : ", \"") + name + '"';
  }
  if (count == 0) return {};
  return fmt::format(" note: {}{} touch{} nothing: the shapes have no material\n", names,
                     count > kMostNames ? ", …" : "", count == 1 ? "es" : "");
}

/// Motors, stops and springs of a joint between two bodies, one of which moves and is held by no joint. What
/// is included may hold it.
std::string jointsForgotten(const Model& model, const XmlNode& root) {
  bool includes = false;
  forElements(root, [&](const XmlNode& node) { includes = includes || node.tag == "include"; });
  if (includes) return {};
  const std::set<std::string> held = joinedBodies(root, false);
  const auto isFree = [&](const std::string& name) {
    for (std::size_t i = 0; i < model.systems().size(); ++i)
      if (withoutIndex(model.systems()[i]->name()) == name)
        return model.topology().system(static_cast<int>(i)).nu > 0 && !held.contains(name);
    return false;
  };
  std::string out;
  forElements(root, [&](const XmlNode& node) {
    const auto [first, second] = bodiesBetween(node);
    if (!actsAtJoint(node) || !(isFree(first) || isFree(second))) return;
    out += fmt::format(" note: <{}> ({}) acts between \"{}\" and \"{}\", which no joint connects\n",
                       node.tag, lineOf(node.place), first, second);
  });
  return out;
}

/// Rows further apart than the run is long.
std::string longSampling(const Model& model) {
  if (!(model.record.every > model.simulation.until)) return {};
  return fmt::format(" note: a row is recorded every {:g} s, and the run ends at t = {:g} s\n",
                     model.record.every, model.simulation.until);
}

/// A run whose end is that of the declaration.
std::string unsaidEnd(const Model& model, const XmlNode& root) {
  const double until = SimulationSettings().until;
  for (const XmlNode& node : root.children)
    if (node.tag == "simulation" && node.attribute("until") == nullptr &&
        model.simulation.until == until)
      return fmt::format(" note: <simulation> ({}) says no end: until=\"{:g}\" is taken [s]\n",
                         lineOf(node.place), until);
  return {};
}

/// What the text of the file says without effect, or otherwise than it may be meant.
std::string ofText(const Model& model) {
  if (model.file.text.empty()) return {};
  const XmlDocument document = XmlDocument::parse(model.file.text, model.file.name);
  const XmlNode& root = document.root();
  return unusedParameters(root) + realPartLast(root) + manyTurns(root) + upwardGravity(root) +
         nothingMoves(model, root) + noMaterials(model, root) + untouched(model, root) +
         jointsForgotten(model, root) + unsaidEnd(model, root);
}

}  // namespace

std::string modelNotes(const Model& model) {
  return idleRules(model) + severalGravities(model) + longStep(model) + longSampling(model) +
         ofText(model);
}

}  // namespace dynamy::app
