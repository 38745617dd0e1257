#include <algorithm>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/trees/compose_trees.hpp>
#include <dynamy_elements/trees/tree_choice.hpp>
#include <dynamy_elements/trees/tree_system.hpp>
#include <map>
#include <numeric>
#include <optional>

namespace dynamy {
namespace {

/// Velocities that joints do not allow count from this value on [m/s,
/// rad/s]; less is rounding of the file.
constexpr double kLost = 1e-9;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::string title(const Element& e) {
  return e.name().empty() ? "a " + e.type() : "\"" + e.name() + "\"";
}

/// Name and place of an element, for reports.
std::string placed(const Element& e) {
  const std::string where = e.place().line > 0 ? " (" + e.place().format() + ")" : "";
  return (e.name().empty() ? e.type() : e.name()) + where;
}

struct Edge {
  NonSmoothElement* joint;
  JointMotion motion;
  int freedom() const {
    int n = 0;
    for (const FreeMotion& m : motion.free) n += m.kind == FreeMotion::Kind::ball ? 3 : 1;
    return n;
  }
  bool rotor() const {
    return std::any_of(motion.free.begin(), motion.free.end(),
                       [](const FreeMotion& m) { return m.rotor > 0.0; });
  }
};

/// The motions of a joint for A moving relative to B: in reversed order, with opposite axes.
std::vector<FreeMotion> reversed(std::vector<FreeMotion> free) {
  std::reverse(free.begin(), free.end());
  for (FreeMotion& m : free) m.axis_I = -m.axis_I;
  return free;
}

/// Adds a body without a joint to others: it moves freely in the plane with normal n, in space if
/// n = 0. Returns its index.
int carryLoose(TreeSystem& tree, TreeSystem::System system, const Vec3& n) {
  using Free = FreeMotion::Kind;
  Eigen::VectorXd q(system->blocks().nq), u(system->blocks().nu);
  system->initialState(view(q), view(u));
  const RigidPart part = system->abilities().rigid->rigidPart();
  Frame f;
  std::vector<double> jacobians(static_cast<std::size_t>(6 * u.size()));
  new (&f.J_S_I) Mat3X(jacobians.data(), 3, u.size());
  new (&f.J_R_I) Mat3X(jacobians.data() + 3 * u.size(), 3, u.size());
  system->frame(0.0, view(std::as_const(q)), view(std::as_const(u)), 0, f);
  std::vector<FreeMotion> free;
  if (n.isZero(0.0)) {
    for (int i = 0; i < 3; ++i) free.push_back({Free::slide, Vec3::Unit(i)});
    free.push_back({Free::ball});
  } else {
    Vec3 e1, e2;
    tangents(n, e1, e2);
    free = {{Free::slide, e1}, {Free::slide, e2}, {Free::turn, n}};
  }
  return tree.carry(std::move(system), -1, f.r_OS_I + f.A_IK * part.r_BS_K, free);
}

class Composer {
 public:
  explicit Composer(Model& model) : model_(model) {
    if (model.simulation.coordinates == JointCoordinates::automatic) choice_.emplace(model);
    for (const auto& s : model.systems()) {
      const RigidSystem* rigid = s->abilities().rigid;
      rigid_.push_back(rigid != nullptr);
      fixed_.push_back(rigid && rigid->rigidPart().fixed);
    }
  }
  void compose();

 private:
  void findEdges();
  std::string whyNot(const JointMotion& m) const;
  struct Branch {
    std::vector<int> bodies;   // systems; each after its parent
    std::vector<int> parents;  // of all bodies but the first, by their places in `bodies`
    std::vector<int> edges;
    bool loose = true;
  };
  Branch branchOf(int first) const;
  std::string lostDigits(const Branch& branch) const;
  void takeChosen();
  void span();
  void dropUnwanted();
  void connectEdges();
  void countSavings();
  void buildTrees();
  void grow(TreeSystem& tree, int from, int index);
  std::unique_ptr<TreeSystem> begin(int first) const;
  void finish(std::unique_ptr<TreeSystem> tree, const std::string& on);
  void noteStart(const TreeSystem::StartChange& start);
  const PartialMechanicalSystem& system(int i) const { return *model_.systems()[at(i)]; }
  int group(int i) {
    while (parent_[at(i)] != i) i = parent_[at(i)];
    return i;
  }
  void note(std::string text) { model_.composed.notes.push_back(std::move(text)); }
  void noteConstraint(const Element& joint, const std::string& why);

  Model& model_;
  std::optional<TreeChoice> choice_;  // none: every joint that can is a coordinate
  std::vector<bool> rigid_, fixed_;
  std::vector<Edge> edges_;                 // edges of the trees, in the order of the model
  std::vector<int> parent_;                 // parent of each system in the union of groups
  std::vector<std::vector<int>> edgesOf_;   // per system
  std::vector<TreeSystem::System> bodies_;  // taken out, by index of the system
  std::vector<std::unique_ptr<TreeSystem>> trees_;
  std::vector<std::string> joints_;  // of the bodies of the tree being built, with their places
  struct Constraints {
    std::size_t note;
    std::vector<std::string> titles;
  };
  std::map<std::string, Constraints> constraints_;  // by the reason why they are no coordinates
  bool any_ = false;
};

/// One note tells all joints that stay constraints for one reason.
void Composer::noteConstraint(const Element& joint, const std::string& why) {
  std::vector<std::string>& notes = model_.composed.notes;
  const auto [it, isNew] = constraints_.try_emplace(why, Constraints{notes.size(), {}});
  if (isNew) notes.emplace_back();
  std::vector<std::string>& titles = it->second.titles;
  titles.push_back(title(joint));
  std::string text = titles[0];
  if (titles.size() > 2)
    text += ", " + titles[1] + " and " + std::to_string(titles.size() - 2) + " more";
  else if (titles.size() == 2)
    text += " and " + titles[1];
  notes[it->second.note] =
      text + (titles.size() > 1 ? " stay constraints: " : " stays a constraint: ") + why;
}

std::string Composer::whyNot(const JointMotion& m) const {
  for (const int i : {m.systemA, m.systemB})
    if (!rigid_[at(i)]) {
      const bool moves = system(i).blocks().nu > 0;
      return title(system(i)) + (moves ? " is not one rigid body" : " moves as told");
    }
  const Vec3 a = system(m.systemA).blocks().planeNormal, b = system(m.systemB).blocks().planeNormal;
  if (!fixed_[at(m.systemA)] && !fixed_[at(m.systemB)] && a != b)
    return "its bodies do not move in the same plane";
  return {};
}

void Composer::findEdges() {
  std::vector<const PartialMechanicalSystem*> systems;
  for (const auto& s : model_.systems()) systems.push_back(s.get());
  Topology topology(systems);
  for (const auto& contact : model_.contacts()) {
    Edge edge{contact.get(), {}};
    try {
      if (!contact->jointMotion(topology, edge.motion)) continue;
    } catch (const ModelError&) {
      continue;  // connect() reports it with all other faults
    }
    any_ = true;
    if (const std::string why = whyNot(edge.motion); !why.empty())
      noteConstraint(*contact, why);
    else
      edges_.push_back(std::move(edge));
  }
  model_.composed.joints = static_cast<int>(edges_.size());
}

/// Where the program chooses: drops the joints that are no coordinates by themselves. If none is to
/// be one, those stay that have rotors, and joints of their mechanisms.
void Composer::takeChosen() {
  if (edges_.empty()) return;
  if (choice_->reason().empty()) {
    std::erase_if(edges_, [&](const Edge& e) {
      const std::string why = choice_->whyNot(*e.joint);
      if (why.empty() || e.rotor()) return false;
      noteConstraint(*e.joint, why);
      return true;
    });
    return;
  }
  note("joints stay constraints: " + choice_->reason() +
       " (coordinates=\"minimal\" makes them coordinates all the same)");
  std::vector<bool> turns(rigid_.size());
  for (bool more = true; more;) {
    more = false;
    for (const Edge& e : edges_) {
      const auto a = at(e.motion.systemA), b = at(e.motion.systemB);
      if (!e.rotor() && !turns[a] && !turns[b]) continue;
      for (const auto i : {a, b})
        if (!fixed_[i] && !turns[i]) turns[i] = more = true;
    }
  }
  std::erase_if(edges_, [&](const Edge& e) {
    return !turns[at(e.motion.systemA)] && !turns[at(e.motion.systemB)];
  });
}

/// Keeps the edges of a spanning tree, first those with a rotor, which can be coordinates only. All
/// systems at rest are one node.
void Composer::span() {
  parent_.resize(rigid_.size());
  std::iota(parent_.begin(), parent_.end(), 0);
  const auto ground = std::find(fixed_.begin(), fixed_.end(), true) - fixed_.begin();
  for (std::size_t i = 0; i < fixed_.size(); ++i)
    if (fixed_[i]) parent_[i] = static_cast<int>(ground);
  std::vector<std::size_t> order(edges_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const bool rotorA = edges_[a].rotor(), rotorB = edges_[b].rotor();
    return rotorA != rotorB ? rotorA : edges_[a].freedom() < edges_[b].freedom();
  });
  std::vector<bool> kept(edges_.size());
  for (const std::size_t e : order) {
    const int a = group(edges_[e].motion.systemA), b = group(edges_[e].motion.systemB);
    kept[e] = a != b;
    if (a != b) parent_[at(std::max(a, b))] = std::min(a, b);
  }
  std::vector<Edge> tree;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (kept[e])
      tree.push_back(std::move(edges_[e]));
    else
      note(title(*edges_[e].joint) + " closes a loop: it stays a constraint");
  }
  edges_ = std::move(tree);
}

void Composer::connectEdges() {
  edgesOf_.assign(rigid_.size(), {});
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const int i : {edges_[e].motion.systemA, edges_[e].motion.systemB})
      edgesOf_[at(i)].push_back(static_cast<int>(e));
}

/// Where the program chooses: drops the branches that are better made of bodies. A branch is what
/// hangs together without anything at rest.
void Composer::dropUnwanted() {
  std::vector<bool> seen(rigid_.size()), drop(edges_.size());
  for (std::size_t first = 0; first < rigid_.size(); ++first) {
    if (fixed_[first] || seen[first] || edgesOf_[first].empty()) continue;
    const Branch branch = branchOf(static_cast<int>(first));
    bool rotor = false;
    int velocities = branch.loose ? system(static_cast<int>(first)).blocks().nu : 0;
    for (const int i : branch.bodies) seen[at(i)] = true;
    for (const int e : branch.edges) {
      rotor = rotor || edges_[at(e)].rotor();
      for (const FreeMotion& free : edges_[at(e)].motion.free)
        velocities += free.kind == FreeMotion::Kind::ball ? 3 : 1;
    }
    std::string why = choice_->whyNot(branch.bodies, branch.loose, velocities);
    if (why.empty()) why = lostDigits(branch);
    if (why.empty() || rotor) continue;
    for (const int e : branch.edges) {
      drop[at(e)] = true;
      noteConstraint(*edges_[at(e)].joint, why);
    }
  }
  std::vector<Edge> kept;
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (!drop[e]) kept.push_back(std::move(edges_[e]));
  edges_ = std::move(kept);
}

/// The branch of a body. Its bodies are in breadth-first order from something at rest, or from
/// `first` if it is loose.
Composer::Branch Composer::branchOf(int first) const {
  std::vector<int> all{first}, roots;
  std::vector<bool> found(rigid_.size());
  found[at(first)] = true;
  const auto other = [&](int e, int i) {
    const JointMotion& m = edges_[at(e)].motion;
    return m.systemA == i ? m.systemB : m.systemA;
  };
  for (std::size_t next = 0; next < all.size(); ++next)
    for (const int e : edgesOf_[at(all[next])]) {
      const int i = other(e, all[next]);
      if (fixed_[at(i)]) roots.push_back(all[next]);
      if (fixed_[at(i)] || found[at(i)]) continue;
      found[at(i)] = true, all.push_back(i);
    }
  Branch out;
  out.loose = roots.empty();
  out.bodies = {out.loose ? first : roots.front()};
  std::fill(found.begin(), found.end(), false);
  found[at(out.bodies.front())] = true;
  for (std::size_t next = 0; next < out.bodies.size(); ++next) {
    const int i = out.bodies[next];
    for (const int e : edgesOf_[at(i)]) {
      const int j = other(e, i);
      if (!fixed_[at(j)] && found[at(j)]) continue;
      out.edges.push_back(e);
      if (fixed_[at(j)]) continue;
      found[at(j)] = true, out.bodies.push_back(j), out.parents.push_back(static_cast<int>(next));
    }
  }
  return out;
}

/// Names the first body that carries so much that its mass is lost in the sum; empty: none does.
std::string Composer::lostDigits(const Branch& branch) const {
  const auto mass = [&](std::size_t k) {
    return system(branch.bodies[k]).abilities().rigid->rigidPart().m;
  };
  std::vector<double> carried(branch.bodies.size(), 0.0);
  for (std::size_t k = branch.bodies.size(); k-- > 1;)
    carried[at(branch.parents[k - 1])] += mass(k) + carried[k];
  for (std::size_t k = 0; k < carried.size(); ++k)
    if (TreeChoice::losesDigits(mass(k), carried[k]))
      return title(system(branch.bodies[k])) + " carries much more than its own mass";
  return {};
}

void Composer::countSavings() {
  Composition& out = model_.composed;
  out.coordinates = static_cast<int>(edges_.size());
  for (const Edge& e : edges_) {
    const int body = fixed_[at(e.motion.systemA)] ? e.motion.systemB : e.motion.systemA;
    out.rowsSaved += (system(body).blocks().planeNormal.isZero(0.0) ? 6 : 3) - e.freedom();
  }
}

std::unique_ptr<TreeSystem> Composer::begin(int first) const {
  const PartialMechanicalSystem& body = *bodies_[at(first)];
  Parameters x;
  x.type = "Tree", x.place = body.place();
  return std::make_unique<TreeSystem>(x, body.blocks().planeNormal);
}

/// Adds all systems after `from`, which the tree carries as `index`, in breadth-first order.
void Composer::grow(TreeSystem& tree, int from, int index) {
  std::vector<std::pair<int, int>> queue{{from, index}};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const auto [system, carried] = queue[next];
    for (const int e : edgesOf_[at(system)]) {
      const JointMotion& m = edges_[at(e)].motion;
      const bool forward = m.systemA == system;
      const int other = forward ? m.systemB : m.systemA;
      if (!bodies_[at(other)]) continue;  // the system from which it was reached
      queue.emplace_back(other, tree.carry(std::move(bodies_[at(other)]), carried, m.at_I,
                                           forward ? m.free : reversed(m.free)));
      joints_.push_back(placed(*edges_[at(e)].joint));
      edges_[at(e)].joint->becomeCoordinate();
    }
  }
}

void Composer::finish(std::unique_ptr<TreeSystem> tree, const std::string& on) {
  noteStart(tree->finish());
  joints_.clear();
  model_.composed.velocitiesAfter += tree->blocks().nu;
  note("tree of " + std::to_string(tree->bodies()) + (tree->bodies() == 1 ? " body" : " bodies") +
       " on " + on + ": q " + std::to_string(tree->blocks().nq) + ", u " +
       std::to_string(tree->blocks().nu));
  trees_.push_back(std::move(tree));
}

void Composer::noteStart(const TreeSystem::StartChange& start) {
  Composition::Start& all = model_.composed.start;
  all.kineticBefore += start.kineticBefore, all.kineticAfter += start.kineticAfter;
  for (std::size_t k = 0; k < start.off.size(); ++k) {
    if (!(start.off[k] > kLost)) continue;
    ++all.joints;
    if (start.off[k] > all.off) all.off = start.off[k], all.joint = joints_[k];
  }
}

void Composer::buildTrees() {
  // Only bodies with joints leave the model.
  std::vector<int> taken;
  for (std::size_t i = 0; i < edgesOf_.size(); ++i)
    if (!edgesOf_[i].empty() && !fixed_[i]) taken.push_back(static_cast<int>(i));
  std::vector<std::string> titles;
  for (const auto& s : model_.systems()) titles.push_back(title(*s));
  bodies_.resize(rigid_.size());
  std::vector<TreeSystem::System> out = model_.takeSystems(taken);
  for (std::size_t k = 0; k < taken.size(); ++k) {
    model_.composed.velocitiesBefore += out[k]->blocks().nu;
    bodies_[at(taken[k])] = std::move(out[k]);
  }

  for (Edge& e : edges_) {
    const JointMotion& m = e.motion;
    const bool onA = fixed_[at(m.systemA)], onB = fixed_[at(m.systemB)];
    if (!onA && !onB) continue;
    const int first = onA ? m.systemB : m.systemA;
    auto tree = begin(first);
    const int index =
        tree->carry(std::move(bodies_[at(first)]), -1, m.at_I, onA ? m.free : reversed(m.free));
    joints_.push_back(placed(*e.joint));
    e.joint->becomeCoordinate();
    grow(*tree, first, index);
    finish(std::move(tree), titles[at(onA ? m.systemA : m.systemB)]);
  }
  for (const int first : taken) {
    if (!bodies_[at(first)]) continue;
    auto tree = begin(first);
    const Vec3 n = bodies_[at(first)]->blocks().planeNormal;
    const int index = carryLoose(*tree, std::move(bodies_[at(first)]), n);
    joints_.push_back(placed(*edges_[at(edgesOf_[at(first)].front())].joint));
    grow(*tree, first, index);
    finish(std::move(tree), "nothing");
  }
  for (auto& tree : trees_) model_.add(Kind::system, std::move(tree));
}

void Composer::compose() {
  findEdges();
  if (choice_) takeChosen();
  if (edges_.empty() && choice_) return;
  if (edges_.empty()) {
    Diagnostic d;
    d.place = model_.simulation.coordinatesPlace;
    d.element = "simulation";
    d.text = "no joint of the model makes a tree: minimal coordinates have nothing to act on";
    d.hint = any_ ? model_.composed.notes.front()
                  : "joints between rigid bodies do, e.g. Revolute, Spherical, Prismatic or Fixed";
    throw ModelError(d);
  }
  span();
  connectEdges();
  if (choice_) dropUnwanted(), connectEdges();
  countSavings();
  buildTrees();
}

}  // namespace

void composeTrees(Model& model) {
  if (model.simulation.coordinates != JointCoordinates::absolute) Composer(model).compose();
}

}  // namespace dynamy
