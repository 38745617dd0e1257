#include "import/mjcf_constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <dynamy/core/suggestion.hpp>

namespace dynamy::app {

const MjcfPlace* MjcfConstraints::found(const XmlNode& node, const char* attribute,
                                        const Places& among) {
  static const MjcfPlace kWorld;
  const XmlAttribute* given = node.attribute(attribute);
  if (!given || given->value == "world") return &kWorld;
  const auto at = among.find(given->value);
  if (at != among.end()) return &at->second;
  std::vector<std::string> known;
  for (const auto& [name, place] : among) known.push_back(name);
  read_.fault(node, given->valuePlace,
              fmt::format("there is no {} \"{}\"", attribute, given->value),
              didYouMean(nearest(given->value, known)));
  return nullptr;
}

void MjcfConstraints::contacts(const XmlNode& node) {
  read_.readOnly(node, {}, {"exclude"},
                 {{"pair", "pairs of geoms of their own are not taken over"}});
  for (const XmlNode* c : childrenOf(node, "exclude")) {
    read_.required(*c, "body1"), read_.required(*c, "body2");
    const MjcfPlace *a = found(*c, "body1", bodies_), *b = found(*c, "body2", bodies_);
    if (a && b) machine_.apart.emplace_back(a->link, b->link);
  }
}

/// connect and weld: a ball joint and a rigid one.
void MjcfConstraints::hold(const XmlNode& node) {
  LoopJoint loop;
  loop.kind = node.tag == "connect" ? LoopJoint::Kind::ball : LoopJoint::Kind::fixed;
  loop.name = valueOf(node, "name", node.tag), loop.place = node.place;
  read_.readOnly(node, {"name", "class", "body1", "body2", "anchor", "site1", "site2", "active"},
                 {},
                 {{"relpose", "bodies are held as they stand at the start"},
                  {"torquescale", "the joint is rigid"},
                  {"solref", "the joint is rigid"},
                  {"solimp", "the joint is rigid"}});
  const bool ofSites = node.attribute("site1") != nullptr;
  const MjcfPlace* a = found(node, ofSites ? "site1" : "body1", ofSites ? sites_ : bodies_);
  const MjcfPlace* b = found(node, ofSites ? "site2" : "body2", ofSites ? sites_ : bodies_);
  if (!a || !b) return;
  // The anchor lies in the first body, which is therefore the side that carries the point.
  loop.A = b->link, loop.B = a->link;
  loop.at = ofSites ? a->pose.r : read_.vector(node, "anchor", Vec3::Zero());
  machine_.loops.push_back(loop);
}

/// joint1 = a polynomial of joint2: its linear term.
void MjcfConstraints::couple(const XmlNode& node) {
  std::vector<double> p = read_.numbers(node, "polycoef");
  if (p.empty()) p = {0.0, 1.0};
  p.resize(std::max<std::size_t>(p.size(), 2));
  const std::string first = read_.required(node, "joint1"), second = valueOf(node, "joint2", "");
  if (second.empty() || std::any_of(p.begin() + 2, p.end(), [](double x) { return x != 0.0; })) {
    read_.note(node, "only joints in proportion to each other can be coupled: is left out");
    return;
  }
  machine_.couplings.push_back(
      {valueOf(node, "name", first + "_coupling"), second, first, p[1], node.place});
}

void MjcfConstraints::equalities(const XmlNode& node) {
  for (const XmlNode& c : node.children) {
    if (valueOf(c, "active", "true") == "false")
      read_.note(c, "is not active: left out");
    else if (c.tag == "connect" || c.tag == "weld")
      hold(c);
    else if (c.tag == "joint")
      couple(c);
    else
      read_.note(c, "is not taken over");
  }
}

}  // namespace dynamy::app
