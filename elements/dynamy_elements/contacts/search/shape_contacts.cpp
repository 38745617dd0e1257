// Which shapes can touch each other: groups of equal shapes, and the
// contact rule of each two groups.
#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy_elements/contacts/search/grain.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <map>
#include <set>
#include <tuple>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

constexpr std::int64_t kMostNamedPairs = 64;  ///< with more pairs, single contacts have no signals
/// Count of the numbers that the 40 bits of a contact's number can hold.
constexpr double kMostNumbers = 1099511627776.0;

Diagnostic pairFault(const Shape& a, const Shape& b, std::string text, std::string hint) {
  Diagnostic d;
  d.place = a.place();
  d.element = a.type() + (a.name().empty() ? "" : " name=\"" + a.name() + "\"");
  d.text = std::move(text), d.hint = std::move(hint);
  d.notes.push_back({.place = b.place(), .text = "the other shape: <" + b.type() + ">"});
  return d;
}

std::string between(const Shape& a, const Shape& b) {
  return "between=\"" + a.material() + " " + b.material() + "\"";
}

Diagnostic missingLaw(const Shape& a, const Shape& b, Diagnostic said) {
  Diagnostic d = pairFault(a, b, std::move(said.text), std::move(said.hint));
  d.notes.insert(d.notes.end(), said.notes.begin(), said.notes.end());
  return d;
}

/// The law of two shapes has more rows than their contact offers.
Diagnostic tooManyRows(const Shape& a, const Shape& b, bool contour) {
  return contour ? pairFault(a, b, "the way along a contour is known on half spaces only",
                             "leave contour=\"…\" away, or take a HalfSpace")
                 : pairFault(a, b, "the law has more rows than a contact in a plane offers",
                             "take a law without a spin row, or bodies in space");
}

Diagnostic missingPair(const Shape& a, const Shape& b, bool thin) {
  return pairFault(
      a, b, "contact of a " + a.type() + " with a " + b.type() + " is not available",
      std::string(
          thin ? "points and lines have no thickness and would pass through: take a small "
                 "Sphere or a Capsule"
               : "use balls and half spaces with all, boxes, polyhedra, capsules, "
                 "cylinders, cones, tori, ellipsoids and smooth shapes with each other in space") +
          " (all pairs: doc/shape_pairs.md), or <NoContact " + between(a, b) + "/>");
}

/// Throws ModelError unless all faces of a body of these triangles, three points each, have a
/// normal: none vanishes by underflow, none is lost by overflow.
void requireFaces(const Shape& shape, const std::vector<Vec3>& triangles) {
  bool good = !triangles.empty();
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const double area =
        (triangles[i + 1] - triangles[i]).cross(triangles[i + 2] - triangles[i]).norm();
    good = good && area > 0.0 && std::isfinite(area);
  }
  if (good) return;
  throw ModelError(Diagnostic{
      .place = shape.place(),
      .element = shape.type() + (shape.name().empty() ? "" : " name=\"" + shape.name() + "\""),
      .text = "its faces are too small, too thin or too large for contact",
      .hint = "take sizes of the same order, or give it no material"});
}

/// Rows of a law that depends on the motion of the contact over the body (rolling_contact.hpp).
constexpr int kContourRows = 8;

/// Rows offered to a law: normal, tangents, spin about the normal; in a plane normal and tangent.
/// Laws in space may also request rows for rolling and for the motion along the contour.
int offeredRows(const Vec3& plane) { return plane.isZero(0.0) ? 4 : 2; }

/// Shapes further apart than half their sizes are not reported.
double earlyReach(const TouchingShape& s) {
  // Boxes are searched where their circumscribed balls overlap.
  if (s.kind == Touch::box) return 0.0;
  return std::isfinite(s.thickness) ? 0.5 * s.thickness : 0.0;
}

}  // namespace

/// Working data of connect().
struct ShapeContacts::Search {
  explicit Search(Topology& t) : topology(t), instances(t.shapesWithMaterial()), start(t) {
    for (const PartialMechanicalSystem* s : t.systems()) blocks.push_back(s->blocks());
  }
  const Blocks& blocksOf(std::size_t shape) const {
    return blocks[static_cast<std::size_t>(instances[shape].system)];
  }
  TouchingShape take(std::size_t shape, const Vec3& plane) const {
    const ShapeInstance& s = instances[shape];
    return touchingShape(s, start.frame(s.frame).A_IK.transpose() * plane);
  }
  /// Reports a fault of the shapes i and j once per pair of words a, b. A shape that was made by
  /// its system is reported at the place of that system.
  void fault(std::size_t i, std::size_t j, const std::string& a, const std::string& b,
             Diagnostic d) {
    if (!told.insert(std::minmax(a, b)).second) return;
    const auto placeOf = [&](std::size_t shape) {
      return topology.systems()[static_cast<std::size_t>(instances[shape].system)]->place();
    };
    if (d.place.line <= 0) d.place = placeOf(i);
    if (!d.notes.empty() && d.notes[0].place.line <= 0) d.notes[0].place = placeOf(j);
    faults.add(std::move(d));
  }

  /// Number of a body that is part of a tree, other than those of systems and populations.
  int partNumber(const NamedBody* part) {
    const auto [at, isNew] = parts.try_emplace(part, -2 - static_cast<int>(parts.size()));
    return at->second;
  }

  const Topology& topology;
  std::map<const NamedBody*, int> parts;
  std::vector<ShapeInstance> instances;
  StartKinematics start;
  std::vector<Blocks> blocks;
  /// Members of a group: its first shape, and one of another body or −1.
  struct Members {
    std::size_t first;
    int another = -1;
    std::int64_t count = 1;
  };
  std::vector<Members> groups;
  Diagnostics faults;
  std::set<std::pair<std::string, std::string>> told;
};

void ShapeContacts::connect(Topology& topology) {
  laws_->verify();
  Search search(topology);
  planes_ = {Vec3::Zero()};
  shapes_.assign(1, {});
  const std::size_t n = search.instances.size();
  for (std::size_t i = 0; i < n; ++i) shapes_[0].push_back(search.take(i, Vec3::Zero()));
  makeSurfaces();
  for (std::size_t i = 0; i < n; ++i) planeIndex(search.blocksOf(i).planeNormal, search);
  group(search);
  pairRules_.clear(), pairs_ = 0;
  table_.assign(groups_ * groups_, -1);
  for (std::size_t a = 0; a < groups_; ++a)
    for (std::size_t b = a; b < groups_; ++b) addRule(search, a, b);
  search.faults.throwIfAny();
  countPairs(search);
  balls_.reserve(n), reach_.resize(n);
}

/// Makes the surfaces of polyhedra and meshes, in axes of the frames that carry them. Also makes
/// the polyhedra, and those of boxes if there are bodies that touch boxes as polyhedra; shapes that
/// are equal share one.
void ShapeContacts::makeSurfaces() {
  surfaces_.clear(), polyhedra_.clear();
  const auto faceted = [](const TouchingShape& s) {
    return s.kind == Touch::polyhedron || s.kind == Touch::surface;
  };
  const auto needed = [&](const TouchingShape& s) {
    return faceted(s) || s.kind == Touch::smooth || s.kind == Touch::cylinder ||
           s.kind == Touch::torus || s.kind == Touch::cone || s.isBox(8);
  };
  if (std::none_of(shapes_[0].begin(), shapes_[0].end(), needed)) return;
  std::map<std::vector<double>, const Polyhedron*> known;
  for (TouchingShape& s : shapes_[0]) {
    if (s.kind != Touch::polyhedron && !s.isBox(8)) continue;
    const std::vector<Vec3> triangles =
        s.kind == Touch::box ? boxTriangles(s.half) : s.shape->geometry().points;
    requireFaces(*s.shape, triangles);
    std::vector<double> key;
    for (const Vec3& p : triangles) key.insert(key.end(), p.begin(), p.end());
    const auto [at, isNew] = known.try_emplace(std::move(key), nullptr);
    if (isNew) {
      polyhedra_.push_back(std::make_unique<Polyhedron>(triangles));
      at->second = polyhedra_.back().get();
    }
    s.polyhedron = at->second;
  }
  for (TouchingShape& s : shapes_[0]) {
    if (!faceted(s)) continue;
    const ShapeGeometry g = s.shape->geometry();
    std::vector<Vec3> points;
    for (const Vec3& p : g.points) points.push_back(s.p_K + s.A_KB * p);
    surfaces_.push_back(std::make_unique<Surface>(points, g.type == "Polyhedron"));
    s.surface = surfaces_.back().get();
  }
}

std::size_t ShapeContacts::planeIndex(const Vec3& plane, Search& search) {
  for (std::size_t p = 0; p < planes_.size(); ++p)
    if (planes_[p] == plane) return p;
  planes_.push_back(plane);
  shapes_.emplace_back();
  for (std::size_t i = 0; i < search.instances.size(); ++i)
    shapes_.back().push_back(search.take(i, plane));
  for (TouchingShape& s : shapes_.back()) {
    if (s.kind != Touch::contour) continue;
    std::vector<double> radii;
    for (const Vec3& p : s.shape->geometry().points) radii.push_back(p.norm());
    contours_.push_back(std::make_unique<Contour>(std::move(radii)));
    s.features[0].contour = contours_.back().get();
  }
  return planes_.size() - 1;
}

/// Finds bodies and groups of all shapes. Shapes that do not move are in groups of their own, as
/// their planes differ.
void ShapeContacts::group(Search& search) {
  const std::size_t n = search.instances.size();
  body_.resize(n), group_.resize(n), early_.resize(n), names_.resize(n);
  ground_.assign(n, -1), grounds_.clear();
  flats_.clear();
  thinnest_ = std::numeric_limits<double>::infinity();
  using Key = std::tuple<std::string, double, double, double, int, Traits, Traits>;
  std::map<Key, int> known;
  std::map<std::string, int> names;
  for (std::size_t i = 0; i < n; ++i) {
    const ShapeInstance& s = search.instances[i];
    const Blocks& blocks = search.blocksOf(i);
    const TouchingShape &inSpace = shapes_[0][i],
                        &own = shapes_[planeIndex(blocks.planeNormal, search)][i];
    const bool moves = blocks.nu > 0;
    // A body is a system, one body of a population, or a part of a tree.
    const int systems = static_cast<int>(search.blocks.size());
    const NamedBody* part = search.topology.body(
        s.system,
        search.topology.requestedFrames()[static_cast<std::size_t>(s.frame.index)].second);
    body_[i] = part                   ? search.partNumber(part)
               : blocks.capacity == 1 ? s.system
                                      : systems + search.start.frame(s.frame).block;
    const bool alone = !moves || own.kind == Touch::halfSpace;
    const Key key{s.shape->material(),    blocks.planeNormal.x(),           blocks.planeNormal.y(),
                  blocks.planeNormal.z(), alone ? static_cast<int>(i) : -1, traits(own),
                  traits(inSpace)};
    const auto [at, isNew] = known.try_emplace(key, static_cast<int>(search.groups.size()));
    group_[i] = at->second;
    if (isNew) {
      search.groups.push_back({.first = i});
    } else {
      Search::Members& members = search.groups[static_cast<std::size_t>(at->second)];
      ++members.count;
      if (members.another < 0 && body_[members.first] != body_[i])
        members.another = static_cast<int>(i);
    }
    early_[i] = std::max(earlyReach(inSpace), earlyReach(own));
    thinnest_ = std::min(thinnest_, std::min(inSpace.thickness, own.thickness));
    if (inSpace.kind == Touch::halfSpace) flats_.push_back(static_cast<int>(i));
    // The shape's name, else that of its system.
    const std::string& system =
        part ? part->name : search.topology.systems()[static_cast<std::size_t>(s.system)]->name();
    std::string& name = names_[i];
    name = s.shape->name();
    if (name.empty()) name = system.empty() ? "body" + std::to_string(s.system) : system;
    if (!moves && !system.empty()) {
      const auto named = std::find(grounds_.begin(), grounds_.end(), system);
      ground_[i] = static_cast<int>(named - grounds_.begin());
      if (named == grounds_.end()) grounds_.push_back(system);
    }
    if (const int count = ++names[name]; count > 1) name += "#" + std::to_string(count);
  }
  groups_ = search.groups.size();
}

void ShapeContacts::addRule(Search& search, std::size_t a, std::size_t b) {
  // Two shapes that represent the groups: of different bodies, one of which moves.
  const Search::Members &first = search.groups[a], &second = search.groups[b];
  std::size_t i = first.first, j = second.first;
  if (body_[i] == body_[j]) {
    if (second.another >= 0) {
      j = static_cast<std::size_t>(second.another);
    } else if (first.another >= 0) {
      i = static_cast<std::size_t>(first.another);
    } else {
      return;
    }
  }
  const Blocks &blocksA = search.blocksOf(i), &blocksB = search.blocksOf(j);
  if (blocksA.nu == 0 && blocksB.nu == 0) return;
  PairRule made;
  const Vec3 plane = commonPlane(blocksA, blocksB);
  made.plane = planeIndex(plane, search);
  const auto inOrder = [&](std::size_t p) {
    const TouchingShape *A = &shapes_[p][i], *B = &shapes_[p][j];
    if (A->kind < B->kind) std::swap(A, B);
    return std::pair(A, B);
  };
  auto [A, B] = inOrder(made.plane);
  made.meets = meeting(*A, *B, !plane.isZero(0.0));
  if (made.meets == Meeting::never) return;

  // The law of the two materials.
  const Shape &shapeA = *search.instances[i].shape, &shapeB = *search.instances[j].shape;
  const std::string &ma = shapeA.material(), &mb = shapeB.material();
  const PairLaw& found = laws_->find(ma, mb);
  if (!found.from)
    return search.fault(i, j, ma, mb, missingLaw(shapeA, shapeB, laws_->missing(ma, mb)));
  if (!found.law) return;
  if (made.meets == Meeting::missing)
    return search.fault(i, j, shapeA.type() + ma, shapeB.type() + mb,
                        missingPair(shapeA, shapeB, A->isThin() || B->isThin()));
  made.law = found.law;

  // A half space that cuts the plane of motion at an angle needs both tangents.
  if (made.meets == Meeting::overHalfSpace && !plane.isZero(0.0)) {
    const Vec3 n = search.start.frame(A->frame).A_IK * A->n_K;
    if (std::abs(n.dot(plane)) > 1e-12) made.plane = 0;
  }
  made.rows = offeredRows(planes_[made.plane]);
  const int asked = made.law->dim(made.rows);
  const bool contour = asked == kContourRows && made.meets != Meeting::overHalfSpace;
  if (contour || asked > (planes_[made.plane].isZero(0.0) ? kContourRows : made.rows))
    search.fault(i, j, ma, mb, tooManyRows(shapeA, shapeB, contour));
  const GrainFault grain = grainFault(*A, *B, made.meets, *made.law, made.rows);
  if (!grain.text.empty())
    search.fault(i, j, ma, mb, pairFault(shapeA, shapeB, grain.text, grain.hint));
  made.grain = !A->grain_K.isZero(0.0) || !B->grain_K.isZero(0.0);
  made.features = featuresOf(made.meets, *A, *B);
  made.followed = made.features - followedOf(made.meets, *A, *B);
  table_[a * groups_ + b] = table_[b * groups_ + a] = static_cast<int>(pairRules_.size());
  pairRules_.push_back(made);
}

/// How many pairs there are and how many contacts each may have; lists them if they are few.
void ShapeContacts::countPairs(const Search& search) {
  const std::size_t n = body_.size();
  pairs_ = 0, features_ = 1;
  for (std::size_t a = 0; a < groups_; ++a)
    for (std::size_t b = a; b < groups_; ++b) {
      if (table_[a * groups_ + b] < 0) continue;
      const std::int64_t count = search.groups[a].count;
      pairs_ += a == b ? count * (count - 1) / 2 : count * search.groups[b].count;
    }
  for (const PairRule& r : pairRules_) features_ = std::max(features_, r.features);
  // Pairs of shapes of one body are subtracted; these shapes lie next to each other in the list.
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n && body_[j] == body_[i]; ++j)
      if (table_[entry(i, j)] >= 0) --pairs_;
  namedPairs_.clear();
  if (pairs_ <= kMostNamedPairs)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        if (pairOf(static_cast<int>(i), static_cast<int>(j)))
          namedPairs_.emplace_back(static_cast<int>(i), static_cast<int>(j));
  const auto all = static_cast<double>(n);
  if (static_cast<double>(features_) * all * all > kMostNumbers)
    throw ModelError("there are too many shapes to number their contacts: " + std::to_string(n) +
                         " shapes with up to " + std::to_string(features_) + " contacts of two",
                     "give shapes that nothing touches no material");
}

ShapeContacts::Pair ShapeContacts::pairOf(int i, int j) const {
  if (i > j) std::swap(i, j);
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  const int made = table_[entry(a, b)];
  if (made < 0 || body_[a] == body_[b]) return {};
  Pair out;
  out.rule = &pairRules_[static_cast<std::size_t>(made)];
  out.A = &shapes_[out.rule->plane][a], out.B = &shapes_[out.rule->plane][b];
  if (out.A->kind < out.B->kind) std::swap(out.A, out.B);
  out.id = (a * body_.size() + b) * features_, out.i = a, out.j = b;
  return out;
}

std::string ShapeContacts::contactName(std::uint64_t id) const {
  const std::uint64_t pairNumber = id / features_, n = body_.size();
  if (pairNumber >= n * n) return {};  // number read from a file
  const auto i = static_cast<int>(pairNumber / n), j = static_cast<int>(pairNumber % n);
  const Pair pair = pairOf(i, j);
  if (!pair) return {};
  // The name begins with the shape that rests on the other one.
  std::string a = names_[static_cast<std::size_t>(i)], b = names_[static_cast<std::size_t>(j)];
  const bool swapped = pair.A != &shapes_[pair.rule->plane][static_cast<std::size_t>(i)];
  if (swapped != (pair.A->kind != pair.B->kind)) std::swap(a, b);
  const std::string feature = featureName(pair.rule->meets, *pair.A, *pair.B, id % features_);
  return a + "-" + b + (feature.empty() ? "" : "." + feature);
}

void addShapeContacts(Model& model) {
  bool any = false;
  for (const auto& system : model.systems()) {
    Description d;
    system->describe(d);
    for (const PlacedShape& placed : d.shapes) any = any || !placed.shape->material().empty();
  }
  if (!any) return;
  model.add(std::make_unique<ShapeContacts>(model.pairLaws()));
}

}  // namespace dynamy
