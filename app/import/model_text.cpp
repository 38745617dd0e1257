#include "import/model_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <dynamy/io/xml/xml.hpp>

#include "import/contact_rules.hpp"
#include "import/simplify.hpp"
#include "import/unique_names.hpp"

namespace dynamy::app {
namespace {
namespace fs = std::filesystem;

/// 15 digits, so that 0.1 + 0.2 reads 0.3; less than 1e-15 is rounding of a turn.
std::string number(double x) { return std::abs(x) < 1e-15 ? "0" : fmt::format("{:.15g}", x); }

/// The same of a number that may be small: a mass, an inertia.
std::string smallNumber(double x) { return fmt::format("{:.15g}", x); }

std::string vector(const Vec3& v) {
  return number(v.x()) + ' ' + number(v.y()) + ' ' + number(v.z());
}

std::string attribute(const char* name, const std::string& value) {
  return fmt::format(" {}=\"{}\"", name, escapeXmlValue(value));
}

std::string placed(const Pose& pose) {
  std::string out;
  if (pose.r.norm() >= 1e-15) out += attribute("position", vector(pose.r));
  const Eigen::Vector4d p = quaternionOf(pose.A);
  if (p.tail<3>().norm() < 1e-15) return out;
  return out + attribute("orientation", fmt::format("{} {} {} {}", number(p[0]), number(p[1]),
                                                    number(p[2]), number(p[3])));
}

std::string inertiaText(const Mat3& J) {
  std::string out;
  for (const double x : {J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2)})
    out += (out.empty() ? "" : " ") + smallNumber(std::abs(x) < 1e-15 * J.trace() ? 0.0 : x);
  return out;
}

/// `folder`: of the model. A hull has one convex body.
std::string skinText(const Skin& skin, const Pose& pose, const std::string& material,
                     const fs::path& folder) {
  using Kind = Skin::Kind;
  std::string out;
  switch (skin.kind) {
    case Kind::box:
      out = "Box" + attribute("size", vector(skin.size));
      break;
    case Kind::sphere:
      out = "Sphere" + attribute("radius", number(skin.size.x()));
      break;
    case Kind::capsule:
    case Kind::cylinder:
      out = (skin.kind == Kind::capsule ? "Capsule" : "Cylinder") +
            attribute("radius", number(skin.size.x())) + attribute("length", number(skin.size.y()));
      break;
    case Kind::ellipsoid:
      out = "Ellipsoid" + attribute("semiAxes", vector(skin.size));
      break;
    case Kind::plane:
      out = "HalfSpace";
      break;
    case Kind::hull: {
      std::string points;
      for (const Vec3& p : skin.hulls.front()) points += (points.empty() ? "" : "  ") + vector(p);
      out = "Polyhedron" + attribute("points", points);
      break;
    }
    case Kind::mesh:
      out = "Mesh" + attribute("file", fs::proximate(skin.file, folder).generic_string());
      if (!skin.scale.isOnes(0.0)) out += attribute("scale", vector(skin.scale));
  }
  out += placed(pose);
  if (!material.empty()) out += attribute("material", material);
  if (!skin.colour.empty()) out += attribute("colour", skin.colour);
  return "<" + out + "/>";
}

class ModelWriter {
 public:
  ModelWriter(Machine& machine, std::string source, std::filesystem::path folder)
      : m_(machine),
        source_(std::move(source)),
        folder_(std::move(folder)),
        rules_(contactRules(machine)),
        poses_(startPoses(machine)) {}
  std::string text();

 private:
  std::string named(UniqueNames& names, const std::string& what, const std::string& wanted,
                    const Place& place);
  void nameAll();
  bool stands(int link) const;
  void systems();
  void body(std::size_t i);
  void skins(const std::vector<Skin>& skins, const std::vector<int>& materials, const Vec3& centre);
  void frames(const Link& link, const Vec3& centre);
  void joints();
  void joint(std::size_t i);
  void laws(const MachineJoint& joint, const std::string& name, const std::string& coordinate);
  std::string coordinateText(std::size_t i) const;
  int linkOf(const std::string& joint) const;
  void drives();
  void loops();
  void couplings();
  void contacts();
  std::string ends() const;
  const std::string& nameOf(int link) const { return link < 0 ? world_ : names_[at(link)]; }

  Machine& m_;
  std::string source_;
  std::filesystem::path folder_;
  ContactRules rules_;
  std::vector<Pose> poses_;
  std::vector<std::string> names_, jointNames_;
  std::string world_;
  std::string systems_, forces_, elements_, signals_;
};

std::string ModelWriter::named(UniqueNames& names, const std::string& what,
                               const std::string& wanted, const Place& place) {
  std::string name = names.take(wanted);
  if (name != wanted && !wanted.empty())
    m_.notes.push_back({place, what + " " + wanted, "is named \"" + name + "\" in the model"});
  return name;
}

void ModelWriter::nameAll() {
  UniqueNames systems, elements;
  // A link of this name without mass that stands still is the world.
  for (std::size_t i = 0; i < m_.links.size(); ++i)
    names_.push_back(named(systems, "link", m_.links[i].name, m_.links[i].place));
  const auto found = std::find(names_.begin(), names_.end(), "world");
  const bool is = found != names_.end() && stands(static_cast<int>(found - names_.begin()));
  world_ = is ? "world" : systems.take("world");
  // Elements and systems share one scope of names.
  for (const Link& link : m_.links) {
    jointNames_.emplace_back();
    for (const MachineJoint& joint : link.joints)
      jointNames_.back() = named(systems, "joint", joint.name, joint.place);
  }
  for (LoopJoint& loop : m_.loops) loop.name = named(systems, "joint", loop.name, loop.place);
  for (Coupling& c : m_.couplings) c.name = systems.take(c.name);
}

/// Is the link rigidly connected with the world?
bool ModelWriter::stands(int link) const {
  for (; link >= 0; link = m_.links[at(link)].parent)
    if (!m_.links[at(link)].rigid()) return false;
  return true;
}

void ModelWriter::skins(const std::vector<Skin>& skins, const std::vector<int>& materials,
                        const Vec3& centre) {
  const auto write = [&](Skin skin, const std::string& material) {
    const Pose pose{skin.pose.r - centre, skin.pose.A};
    const auto hulls = std::move(skin.hulls);
    for (std::size_t k = 0; k < std::max<std::size_t>(hulls.size(), 1); ++k) {
      if (!hulls.empty()) skin.hulls = {hulls[k]};
      systems_ += "      " + skinText(skin, pose, material, folder_.empty() ? "." : folder_) + "\n";
    }
  };
  const bool shown =
      std::any_of(skins.begin(), skins.end(), [](const Skin& s) { return !s.hidden; });
  for (std::size_t k = 0; k < skins.size(); ++k) {
    Skin skin = skins[k];
    const bool hidden = skin.hidden && shown, touches = materials[k] >= 0;
    if (hidden && !touches) continue;
    // A hull touches, the mesh that it stands for is seen.
    const bool twice = !hidden && skin.kind == Skin::Kind::hull && !skin.file.empty();
    if (hidden || twice) skin.colour = "transparent";
    if (touches || !twice) write(skin, touches ? rules_.materials[at(materials[k])].name : "");
    if (!twice) continue;
    skin.kind = Skin::Kind::mesh, skin.colour = skins[k].colour, skin.hulls.clear();
    write(skin, "");
  }
}

void ModelWriter::frames(const Link& link, const Vec3& centre) {
  UniqueNames names;
  systems_ += "      <Frame" + attribute("name", names.take("origin")) +
              placed({-centre, Mat3::Identity()}) + "/>\n";
  for (const auto& [name, pose] : link.frames)
    systems_ += "      <Frame" + attribute("name", named(names, "frame", name, link.place)) +
                placed({pose.r - centre, pose.A}) + "/>\n";
}

void ModelWriter::body(std::size_t i) {
  const Link& link = m_.links[i];
  const bool ground = stands(static_cast<int>(i));
  const Vec3 centre = ground ? Vec3(Vec3::Zero()) : link.inertia.centre;
  const std::string type = ground ? "Ground" : "RigidBody";
  systems_ += "    <" + type + attribute("name", names_[i]) +
              placed({poses_[i].point(centre), poses_[i].A});
  if (!ground)
    systems_ += attribute("mass", smallNumber(link.inertia.mass)) +
                attribute("inertia", inertiaText(link.inertia.J));
  systems_ += ">\n";
  frames(link, centre);
  skins(link.skins, rules_.ofSkin[i], centre);
  systems_ += "    </" + type + ">\n";
}

void ModelWriter::systems() {
  const bool listed = std::find(names_.begin(), names_.end(), world_) != names_.end();
  bool needed = !m_.ground.empty();
  for (const Link& link : m_.links) needed = needed || (link.parent < 0 && !link.joints.empty());
  for (const LoopJoint& loop : m_.loops) needed = needed || loop.A < 0 || loop.B < 0;
  if (needed && !listed) {
    systems_ += "    <Ground" + attribute("name", world_) + ">\n";
    skins(m_.ground, rules_.ofGround, Vec3::Zero());
    systems_ += "    </Ground>\n";
  }
  for (std::size_t i = 0; i < m_.links.size(); ++i) body(i);
}

/// The attributes of elements that act in the coordinate of the joint of link i.
std::string ModelWriter::coordinateText(std::size_t i) const {
  const Link& link = m_.links[i];
  const MachineJoint& joint = link.joints.front();
  const bool turn = joint.kind == MachineJoint::Kind::turn;
  return attribute("between", nameOf(link.parent) + " " + names_[i]) +
         attribute("coordinate", turn ? "angle" : "displacement") +
         attribute("at", vector(poses_[i].point(joint.at))) +
         attribute("axis", vector(poses_[i].A * joint.axis)) +
         (joint.start != 0.0 ? attribute("start", number(joint.start)) : "");
}

void ModelWriter::laws(const MachineJoint& joint, const std::string& name,
                       const std::string& coordinate) {
  if (joint.lower || joint.upper) {
    elements_ += "    <JointStop" + attribute("name", name + "_stop") + coordinate;
    if (joint.lower) elements_ += attribute("lower", number(*joint.lower));
    if (joint.upper) elements_ += attribute("upper", number(*joint.upper));
    elements_ += "/>\n";
  }
  if (joint.stiffness == 0.0 && joint.damping == 0.0) return;
  forces_ += "    <JointSpring" + attribute("name", name + "_spring") + coordinate +
             attribute("stiffness", number(joint.stiffness));
  if (joint.damping != 0.0) forces_ += attribute("damping", number(joint.damping));
  if (joint.stiffness != 0.0) forces_ += attribute("rest", number(joint.rest));
  forces_ += "/>\n";
}

void ModelWriter::joint(std::size_t i) {
  using Kind = MachineJoint::Kind;
  const Link& link = m_.links[i];
  const std::string between = attribute("between", nameOf(link.parent) + " " + names_[i]);
  if (link.joints.empty()) {
    if (link.free || stands(static_cast<int>(i))) return;
    elements_ += "    <Fixed" + between + "/>\n";
    return;
  }
  const MachineJoint& joint = link.joints.front();
  const std::string& name = jointNames_[i];
  const std::string point = attribute("at", vector(poses_[i].point(joint.at)));
  if (joint.kind == Kind::ball) {
    elements_ += "    <Spherical" + attribute("name", name) + between + point + "/>\n";
    if (joint.damping > 0.0)
      forces_ += "    <Bushing" + attribute("name", name + "_damper") + between + point +
                 attribute("turnDamping", vector(Vec3::Constant(joint.damping))) + "/>\n";
    return;
  }
  const bool turn = joint.kind == Kind::turn;
  const std::string axis = attribute("axis", vector(poses_[i].A * joint.axis));
  const std::string type = turn ? "Revolute" : "Prismatic";
  elements_ += "    <" + type + attribute("name", name) + between + point + axis;
  if (joint.start != 0.0) elements_ += attribute("start", number(joint.start));
  if (joint.inertia > 0.0) elements_ += attribute("rotor", smallNumber(joint.inertia));
  elements_ += joint.friction > 0.0 ? fmt::format("><GivenFriction force=\"{}\"/></{}>\n",
                                                  number(joint.friction), type)
                                    : std::string("/>\n");
  signals_ += (signals_.empty() ? "" : " ") + name + (turn ? ".angle" : ".displacement");
  laws(joint, name, coordinateText(i));
}

void ModelWriter::loops() {
  using Kind = LoopJoint::Kind;
  for (const LoopJoint& loop : m_.loops) {
    const Pose pose = loop.B < 0 ? Pose() : poses_[at(loop.B)];
    const char* type = loop.kind == Kind::turn    ? "Revolute"
                       : loop.kind == Kind::slide ? "Prismatic"
                       : loop.kind == Kind::ball  ? "Spherical"
                                                  : "Fixed";
    elements_ += fmt::format("    <{}", type) + attribute("name", loop.name) +
                 attribute("between", nameOf(loop.A) + " " + nameOf(loop.B)) +
                 attribute("at", vector(pose.point(loop.at)));
    if (loop.kind == Kind::turn || loop.kind == Kind::slide)
      elements_ += attribute("axis", vector(pose.A * loop.axis));
    elements_ += "/>\n";
  }
}

int ModelWriter::linkOf(const std::string& joint) const {
  for (std::size_t i = 0; i < m_.links.size(); ++i)
    if (!m_.links[i].joints.empty() && m_.links[i].joints.front().name == joint)
      return static_cast<int>(i);
  return -1;
}

/// "clamp(x, low, high)", or x if there are no bounds.
std::string within(const std::string& x, double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high)) return x;
  return "clamp(" + x + ", " + number(low) + ", " + number(high) + ")";
}

void ModelWriter::drives() {
  UniqueNames inputs;
  for (const Drive& d : m_.drives) {
    const int i = linkOf(d.joint);
    if (i < 0) continue;
    std::string wanted = d.name;
    for (char& c : wanted)
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    while (std::find(names_.begin(), names_.end(), wanted) != names_.end() ||
           std::find(jointNames_.begin(), jointNames_.end(), wanted) != jointNames_.end())
      wanted += "_input";
    const std::string name = inputs.take(wanted);
    if (name != d.name)
      m_.notes.push_back({d.place, "drive " + d.name, "its input is named \"" + name + "\""});
    forces_ += "    <Input" + attribute("name", name) +
               (d.input != 0.0 ? attribute("value", number(d.input)) : "") + "/>\n";
    const auto term = [](double factor, const std::string& of) {
      return factor == 0.0
                 ? ""
                 : fmt::format(" {} {}*{}", factor < 0 ? '-' : '+', number(std::abs(factor)), of);
    };
    const std::string force =
        number(d.gain) + "*" + within("{" + name + ".out}", d.lowInput, d.highInput) +
        term(d.bias[0], "1") + term(d.bias[1] * d.gear, "x") + term(d.bias[2] * d.gear, "v");
    const std::string bounded = within(force, d.lowForce, d.highForce);
    forces_ += "    <JointForce" + attribute("name", name + "_force") + coordinateText(at(i)) +
               attribute("force", d.gear == 1.0 ? bounded : number(d.gear) + "*(" + bounded + ")") +
               "/>\n";
  }
}

/// Two hinges on one carrier can be coupled by a gear.
void ModelWriter::couplings() {
  for (const Coupling& c : m_.couplings) {
    const int a = linkOf(c.jointA), b = linkOf(c.jointB);
    const auto hinge = [this](int i) {
      return m_.links[at(i)].joints.front().kind == MachineJoint::Kind::turn;
    };
    if (a < 0 || b < 0 || !hinge(a) || !hinge(b) || c.ratio == 0.0 ||
        m_.links[at(a)].parent != m_.links[at(b)].parent) {
      m_.notes.push_back({c.place, "coupling of " + c.jointA + " and " + c.jointB,
                          "is left out: only two hinges on one link can be coupled, by a Gear"});
      continue;
    }
    const auto axis = [this](int i) {
      return Vec3(poses_[at(i)].A * m_.links[at(i)].joints.front().axis);
    };
    elements_ += "    <Gear" + attribute("name", c.name) +
                 attribute("between", names_[at(a)] + " " + names_[at(b)]) +
                 attribute("carrier", nameOf(m_.links[at(a)].parent)) +
                 attribute("ratio", number(1.0 / c.ratio)) + attribute("axisA", vector(axis(a))) +
                 attribute("axisB", vector(axis(b))) + "/>\n";
  }
}

void ModelWriter::contacts() {
  for (const auto& [i, j] : rules_.apart)
    elements_ +=
        "    <NoContact" +
        attribute("between", rules_.materials[at(i)].name + " " + rules_.materials[at(j)].name) +
        "/>\n";
  for (const MachineMaterial& material : rules_.materials)
    elements_ += "    <Material" + attribute("name", material.name) +
                 attribute("mu", number(material.mu)) + "/>\n";
  if (!rules_.materials.empty()) elements_ += "    <Contacts mixing=\"max\"/>\n";
}

std::string ModelWriter::ends() const {
  const bool tree = std::any_of(m_.links.begin(), m_.links.end(),
                                [](const Link& l) { return !l.joints.empty(); }) ||
                    elements_.find("<Fixed") != std::string::npos;
  std::string out = "  <simulation until=\"5\" tolerance=\"1e-6\"";
  out += tree ? " coordinates=\"minimal\"/>\n" : "/>\n";
  out += "  <record" + (signals_.empty() ? "" : attribute("signals", signals_)) +
         " every=\"10ms\" frames=\"60Hz\"/>\n";
  return out;
}

std::string section(const char* name, const std::string& content) {
  return content.empty() ? "" : fmt::format("  <{0}>\n{1}  </{0}>\n", name, content);
}

/// A comment must not contain "--".
std::string comment(std::string text) {
  for (std::size_t i = text.find("--"); i != std::string::npos; i = text.find("--", i))
    text.replace(i, 2, "- -");
  return text;
}

std::string ModelWriter::text() {
  nameAll();
  systems();
  for (std::size_t i = 0; i < m_.links.size(); ++i) joint(i);
  loops();
  drives();
  couplings();
  contacts();
  std::string notes;
  std::stable_sort(m_.notes.begin(), m_.notes.end(), [](const ImportNote& a, const ImportNote& b) {
    return a.place.line < b.place.line;
  });
  for (ImportNote note : m_.notes) {
    note.place.file = source_;
    notes += "       " + noteText(note) + "\n";
  }
  if (!notes.empty())
    notes = "  <!-- Not or not literally taken over:\n" + comment(notes) + "  -->\n";
  const bool moves = systems_.find("<RigidBody") != std::string::npos;
  std::string gravity =
      m_.gravity.isZero(0.0) || !moves
          ? ""
          : "    <Gravity" + attribute("acceleration", vector(m_.gravity)) + "/>\n";
  return "<dynamy version=\"1\">\n  <doc>" + escapeXmlText(m_.name + ", from " + source_) +
         "</doc>\n" + notes + section("systems", systems_) + section("forces", gravity + forces_) +
         section("elements", elements_) + ends() + "</dynamy>\n";
}

}  // namespace

std::string noteText(const ImportNote& note) {
  const std::string place = note.place.format();
  return (place.empty() ? "" : place + ": ") + note.element + ": " + note.text;
}

std::string modelText(Machine& machine, const std::string& source,
                      const std::filesystem::path& folder) {
  return ModelWriter(machine, source, folder).text();
}

}  // namespace dynamy::app
