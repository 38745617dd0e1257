#include "import/sdf_reader.hpp"

#include <algorithm>
#include <cmath>
#include <dynamy/core/suggestion.hpp>

#include "import/sdf_frames.hpp"
#include "import/sdf_shapes.hpp"

namespace dynamy::app {
namespace {

struct SdfLink {
  const XmlNode* node = nullptr;
  Link link;
  Pose inModel;
  std::string carrier;  ///< name of a link; "" none, "world"
  int index = -1;       ///< in the machine
};

/// One `<model>`.
class SdfModel {
 public:
  /// `placed`: where the model is.
  SdfModel(const XmlNode& node, const Pose& placed, ElementReader& read, SdfShapes& shapes)
      : node_(node), placed_(placed), read_(read), shapes_(shapes), frames_(read) {}
  /// Adds links and loops to the machine.
  void readInto(Machine& machine);

 private:
  void declareFrames();
  void links();
  void joint(const XmlNode& node);
  std::string end(const XmlNode& node, const char* tag);
  std::string frameOf(const XmlNode& joint) const;
  std::string linkOf(const std::string& frame, int depth = 0) const;
  void carry(const XmlNode& node, const std::string& type, const std::string& parent,
             SdfLink& child);
  void close(const XmlNode& node, const std::string& type, const std::string& parent,
             const std::string& child);
  Vec3 axis(const XmlNode& node, const XmlNode& axis, const SdfLink& child);
  MachineJoint single(const XmlNode& node, const XmlNode* axis, const SdfLink& child);
  bool carries(const std::string& link, std::string of) const;
  void order(Machine& machine);
  SdfLink* found(const std::string& name);
  int indexOf(const std::string& name) { return name == "world" ? -1 : found(name)->index; }

  struct Loop {
    LoopJoint joint;
    std::string A, B;
  };
  const XmlNode& node_;
  Pose placed_;
  ElementReader& read_;
  SdfShapes& shapes_;
  SdfFrames frames_;
  std::vector<SdfLink> links_;
  std::vector<Loop> loops_;
};

SdfLink* SdfModel::found(const std::string& name) {
  const auto at = std::find_if(links_.begin(), links_.end(),
                               [&](const SdfLink& l) { return l.link.name == name; });
  return at == links_.end() ? nullptr : &*at;
}

/// The child of this tag and name, nullptr if there is none.
const XmlNode* namedChild(const XmlNode& node, const char* tag, const std::string& name) {
  for (const XmlNode* c : childrenOf(node, tag))
    if (valueOf(*c, "name", "") == name) return c;
  return nullptr;
}

/// Old files give joints the names of links. The frame of such a joint has an ending.
std::string SdfModel::frameOf(const XmlNode& joint) const {
  const std::string name = valueOf(joint, "name", "");
  return namedChild(node_, "link", name) != nullptr ? name + "_joint" : name;
}

/// The link that a frame is attached to; "" if there is none.
std::string SdfModel::linkOf(const std::string& frame, int depth) const {
  constexpr int kDeepest = 64;
  if (namedChild(node_, "link", frame) != nullptr) return frame;
  if (depth > kDeepest) return {};
  if (frame.empty() || frame == "__model__") {
    const XmlNode* first = childOf(node_, "link");
    return valueOf(node_, "canonical_link", first != nullptr ? valueOf(*first, "name", "") : "");
  }
  if (const XmlNode* own = namedChild(node_, "frame", frame))
    return linkOf(valueOf(*own, "attached_to", ""), depth + 1);
  if (const XmlNode* own = namedChild(node_, "joint", frame))
    if (const XmlNode* child = childOf(*own, "child")) return linkOf(child->text, depth + 1);
  return {};
}

void SdfModel::declareFrames() {
  for (const XmlNode& c : node_.children) {
    const std::string name = valueOf(c, "name", "");
    if (c.tag == "link") frames_.add(c, name, "");
    if (c.tag == "frame") frames_.add(c, name, valueOf(c, "attached_to", ""));
    if (c.tag != "joint") continue;
    const XmlNode* child = childOf(c, "child");
    const std::string of = child != nullptr ? child->text : "";
    const std::string own = frameOf(c);
    if (own != name) read_.note(c, "a link has its name, too: its frame is \"" + own + '"');
    frames_.add(c, own, of == "world" ? "" : of);
  }
}

void SdfModel::links() {
  for (const XmlNode* node : childrenOf(node_, "link")) {
    SdfLink made;
    made.node = node;
    made.link.name = read_.required(*node, "name"), made.link.place = node->place;
    made.inModel = frames_.inModel(*node, made.link.name);
    read_.readOnly(*node, {"name"}, {"pose", "inertial", "collision", "visual"},
                   {{"gravity", "gravity acts on all bodies"},
                    {"enable_wind", "there is no wind"},
                    {"kinematic", "bodies move by forces"},
                    {"velocity_decay", "bodies have no drag of their own"},
                    {"self_collide", "say it of the model"},
                    {"sensor", "signals of the model are those of its bodies and joints"},
                    {"light", "is for pictures of another program"}});
    if (const XmlNode* own = childOf(*node, "inertial"))
      made.link.inertia = shapes_.inertia(*own);
    else
      made.link.inertia.mass = 1.0, made.link.inertia.J = Mat3::Identity();  // of the format
    made.link.skins = shapes_.skins(*node);
    links_.push_back(std::move(made));
  }
  if (links_.empty()) read_.fault(node_, "the model has no <link>");
}

/// Name of the link at one end of a joint; "" with an error.
std::string SdfModel::end(const XmlNode& node, const char* tag) {
  const XmlNode* own = childOf(node, tag);
  if (own == nullptr) {
    read_.fault(node, std::string("<") + tag + "> is missing");
    return {};
  }
  if (own->text == "world") return own->text;
  if (std::string link = linkOf(own->text); found(link) != nullptr) return link;
  std::vector<std::string> known;
  for (const SdfLink& link : links_) known.push_back(link.link.name);
  read_.fault(*own, "there is no link \"" + own->text + '"', didYouMean(nearest(own->text, known)));
  return {};
}

/// Direction of an `<axis>` in the model.
Vec3 SdfModel::axis(const XmlNode& node, const XmlNode& axis, const SdfLink& child) {
  const XmlNode* xyz = childOf(axis, "xyz");
  const auto v = xyz != nullptr ? read_.numbersOf(*xyz, 3) : std::vector<double>();
  Vec3 direction = v.empty() ? Vec3(Vec3::UnitZ()) : Vec3(v[0], v[1], v[2]);
  if (direction.norm() < 1e-9) {
    read_.fault(axis, "the axis is zero");
    direction = Vec3::UnitZ();
  }
  direction.normalize();
  const XmlNode* ofModel = childOf(axis, "use_parent_model_frame");
  if (ofModel != nullptr && (ofModel->text == "1" || ofModel->text == "true")) return direction;
  const std::string in = xyz != nullptr ? valueOf(*xyz, "expressed_in", "") : "";
  const std::string own = frameOf(node);
  return frames_.inModel(axis, in.empty() ? (frames_.has(own) ? own : child.link.name) : in).A *
         direction;
}

MachineJoint SdfModel::single(const XmlNode& node, const XmlNode* own, const SdfLink& child) {
  constexpr double kNone = 1e15;  // the format writes no limit as 1e16
  MachineJoint out;
  out.name = valueOf(node, "name", "joint"), out.place = node.place;
  const Pose inLink = child.inModel.inverse() * frames_.inModel(node, frameOf(node));
  out.at = inLink.r;
  if (own == nullptr) return out;
  out.axis = child.inModel.A.transpose() * axis(node, *own, child);
  const auto value = [&](const XmlNode* of, const char* name, double otherwise) {
    const XmlNode* entry = of != nullptr ? childOf(*of, name) : nullptr;
    return entry != nullptr ? read_.numberOf(*entry) : otherwise;
  };
  const XmlNode *limit = childOf(*own, "limit"), *dynamics = childOf(*own, "dynamics");
  const double lower = value(limit, "lower", -kNone), upper = value(limit, "upper", kNone);
  if (lower > upper) read_.fault(*limit, "lower is above upper");
  if (lower > -kNone) out.lower = lower;
  if (upper < kNone) out.upper = upper;
  out.damping = value(dynamics, "damping", 0.0), out.friction = value(dynamics, "friction", 0.0);
  out.stiffness = value(dynamics, "spring_stiffness", 0.0);
  out.rest = value(dynamics, "spring_reference", 0.0);
  if (limit != nullptr)
    read_.readOnly(*limit, {}, {"lower", "upper"},
                   {{"effort", "limits a drive; the model has none"},
                    {"velocity", "limits a drive; the model has none"},
                    {"stiffness", "stops are rigid"},
                    {"dissipation", "stops are rigid"}});
  return out;
}

void SdfModel::carry(const XmlNode& node, const std::string& type, const std::string& parent,
                     SdfLink& child) {
  child.carrier = parent;
  if (type == "fixed") return;
  MachineJoint first = single(node, childOf(node, "axis"), child);
  if (type == "prismatic") first.kind = MachineJoint::Kind::slide;
  if (type == "ball") first.kind = MachineJoint::Kind::ball;
  const bool two = type == "universal" || type == "revolute2";
  if (two) first.name += "_1";
  child.link.joints.push_back(first);
  if (!two) return;
  MachineJoint second = single(node, childOf(node, "axis2"), child);
  second.name += "_2";
  child.link.joints.push_back(second);
}

/// A joint whose child is carried already closes a loop.
void SdfModel::close(const XmlNode& node, const std::string& type, const std::string& parent,
                     const std::string& child) {
  using Kind = LoopJoint::Kind;
  if (type == "universal" || type == "revolute2") {
    read_.note(node, "a joint with two axes that closes a loop is left out");
    return;
  }
  const SdfLink world;
  const SdfLink& B = child == "world" ? world : *found(child);
  const MachineJoint of = single(node, childOf(node, "axis"), B);
  Loop loop{{}, parent, child};
  loop.joint.name = of.name, loop.joint.place = node.place;
  loop.joint.at = of.at, loop.joint.axis = of.axis;
  loop.joint.kind = type == "prismatic" ? Kind::slide
                    : type == "ball"    ? Kind::ball
                    : type == "fixed"   ? Kind::fixed
                                        : Kind::turn;
  if (of.lower || of.upper || of.damping != 0.0 || of.friction != 0.0 || of.stiffness != 0.0)
    read_.note(node,
               "limits, damping, friction and springs of a joint that closes a loop are left "
               "out: put them at another joint of the loop");
  loops_.push_back(loop);
}

/// Does `link` carry `of`, directly or over others?
bool SdfModel::carries(const std::string& link, std::string of) const {
  while (!of.empty() && of != "world") {
    if (of == link) return true;
    const auto at = std::find_if(links_.begin(), links_.end(),
                                 [&](const SdfLink& l) { return l.link.name == of; });
    of = at->carrier;
  }
  return false;
}

void SdfModel::joint(const XmlNode& node) {
  std::string type = valueOf(node, "type", "");
  if (type == "screw" || type == "gearbox") {
    read_.note(node, "joints of type " + type + " are left out");
    return;
  }
  type = read_.word(
      node, "type", read_.required(node, "type"),
      {"revolute", "continuous", "prismatic", "fixed", "ball", "universal", "revolute2"});
  const std::string parent = end(node, "parent"), child = end(node, "child");
  if (parent.empty() || child.empty()) return;
  read_.readOnly(node, {"name", "type"}, {"parent", "child", "pose", "axis", "axis2"},
                 {{"physics", "is for another program"},
                  {"sensor", "signals of the model are those of its bodies and joints"}});
  SdfLink* carried = found(child);
  if (carried != nullptr && carried->carrier.empty() && !carries(child, parent))
    carry(node, type, parent, *carried);
  else
    close(node, type, parent, child);
}

/// Adds the links to the machine, parents before children, in the order of the file.
void SdfModel::order(Machine& machine) {
  const XmlNode* fixed = childOf(node_, "static");
  const bool stands = fixed != nullptr && (fixed->text == "true" || fixed->text == "1");
  for (std::size_t done = 0; done < links_.size();)
    for (SdfLink& l : links_) {
      const bool root = l.carrier.empty() || l.carrier == "world";
      const SdfLink* carrier = root ? nullptr : found(l.carrier);
      if (l.index >= 0 || (carrier != nullptr && carrier->index < 0)) continue;
      l.index = static_cast<int>(machine.links.size()), ++done;
      l.link.parent = carrier != nullptr ? carrier->index : -1;
      l.link.pose =
          carrier != nullptr ? carrier->inModel.inverse() * l.inModel : placed_ * l.inModel;
      l.link.free = l.carrier.empty() && !stands;
      if (stands) l.link.joints.clear();
      for (const XmlNode* f : childrenOf(node_, "frame"))
        if (valueOf(*f, "attached_to", "") == l.link.name)
          l.link.frames.emplace_back(
              valueOf(*f, "name", ""),
              l.inModel.inverse() * frames_.inModel(*f, valueOf(*f, "name", "")));
      machine.links.push_back(l.link);
    }
  const XmlNode* self = childOf(node_, "self_collide");
  const bool touches = self != nullptr && (self->text == "true" || self->text == "1");
  for (const SdfLink& a : links_)
    for (const SdfLink& b : links_)
      if (!touches && a.index < b.index) machine.apart.emplace_back(a.index, b.index);
}

void SdfModel::readInto(Machine& machine) {
  read_.readOnly(node_, {"name", "canonical_link"},
                 {"link", "joint", "frame", "pose", "static", "self_collide"},
                 {{"model", "models in models are not taken over"},
                  {"include", "files in files are not taken over: expand them first"},
                  {"plugin", "is for another program"},
                  {"allow_auto_disable", "bodies do not sleep"}});
  declareFrames();
  links();
  for (const XmlNode* node : childrenOf(node_, "joint")) joint(*node);
  order(machine);
  for (Loop& loop : loops_) {
    loop.joint.A = indexOf(loop.A), loop.joint.B = indexOf(loop.B);
    if (loop.joint.B < 0)
      loop.joint.at = placed_.point(loop.joint.at), loop.joint.axis = placed_.A * loop.joint.axis;
    machine.loops.push_back(loop.joint);
  }
}

}  // namespace

Machine readSdf(const XmlDocument& document, const ImportOptions& options) {
  Machine machine;
  ElementReader read(document, machine);
  SdfShapes shapes(read, options);
  const XmlNode& root = document.root();
  machine.name = "machine";
  machine.parentContact = false;
  machine.staticContact = true;
  struct Placed {
    const XmlNode* node;
    Pose pose;
  };
  std::vector<Placed> models;
  // Models stand in frames of their world, and in each other's.
  const auto place = [&](const XmlNode& parent) {
    SdfFrames frames(read);
    for (const char* tag : {"model", "frame"})
      for (const XmlNode* node : childrenOf(parent, tag))
        frames.add(*node, valueOf(*node, "name", ""),
                   tag == std::string("frame") ? valueOf(*node, "attached_to", "") : "");
    for (const XmlNode* model : childrenOf(parent, "model"))
      models.push_back({model, frames.inModel(*model, valueOf(*model, "name", ""))});
  };
  place(root);
  read.readOnly(root, {"version"}, {"model", "world"});
  for (const XmlNode* world : childrenOf(root, "world")) {
    machine.name = valueOf(*world, "name", machine.name);
    if (const XmlNode* g = childOf(*world, "gravity"))
      if (const auto v = read.numbersOf(*g, 3); !v.empty())
        machine.gravity = Vec3(v[0], v[1], v[2]);
    place(*world);
    read.readOnly(*world, {"name"}, {"model", "frame", "gravity"},
                  {{"include", "files in files are not taken over: expand them first"},
                   {"light", "is for pictures of another program"},
                   {"scene", "is for pictures of another program"},
                   {"physics", "steps and solvers are those of dynamY"},
                   {"plugin", "is for another program"}});
  }
  if (models.empty()) read.fault(root, "there is no <model>");
  if (models.size() == 1) machine.name = valueOf(*models.front().node, "name", machine.name);
  for (const Placed& model : models)
    SdfModel(*model.node, model.pose, read, shapes).readInto(machine);
  read.throwIfAny();
  return machine;
}

}  // namespace dynamy::app
