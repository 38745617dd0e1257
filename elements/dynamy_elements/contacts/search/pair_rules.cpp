// Groups of equal shapes, and the contact rule of each two groups.
#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/system/shape_pair.hpp>
#include <dynamy_elements/contacts/kernels/grain.hpp>
#include <dynamy_elements/contacts/search/pair_rules.hpp>
#include <set>
#include <tuple>

namespace dynamy {
namespace {

using RuleTouch = TouchingShape::Kind;

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

/// A bore without a length has no ends in space.
bool isEndless(const Shape& s) {
  const ShapeGeometry g = s.geometry();
  return g.type == ShapeType::bore && g.size[1] == 0.0;
}

/// A circle or a bore that lies across the plane of motion has no section there.
bool isAcross(const TouchingShape& at) {
  const ShapeType type = at.shape->geometry().type;
  return at.kind == RuleTouch::none && (type == ShapeType::bore || type == ShapeType::circle);
}

/// "a Box", "an Egg".
std::string withArticle(const std::string& type) {
  const bool vowel =
      !type.empty() && std::string_view("AEIOUaeiou").find(type[0]) != std::string::npos;
  return (vowel ? "an " : "a ") + type;
}

/// "a Funnel touches balls and half spaces": what the family of a plug-in's shape names.
std::string touchedBy(const Shape& s, const ShapeFamily& family) {
  std::string out = withArticle(s.type()) + " touches ";
  for (std::size_t i = 0; i < family.pairs.size(); ++i) {
    const ShapeFamily* other = family.pairs[i].other;
    if (i > 0) out += i + 1 < family.pairs.size() ? ", " : " and ";
    out += other == &ShapeFamily::ball        ? "balls"
           : other == &ShapeFamily::halfSpace ? "half spaces"
                                              : "shapes of the family " + other->name;
  }
  return family.pairs.empty() ? out + "only what names it in a family of its own" : out;
}

/// What to do about a pair of which no plug-in, and no standard shape, has the contact.
std::string otherShapes(const Shape& a, const Shape& b, bool thin, bool inSpace) {
  std::string families;
  for (const Shape* s : {&a, &b}) {
    const ShapeFamily* family = s->ownContact().family;
    if (family == nullptr || (s == &b && family == a.ownContact().family)) continue;
    families += (families.empty() ? "" : ", ") + touchedBy(*s, *family);
  }
  if (!families.empty()) return families + (inSpace ? "" : ", as bodies in space");
  if (thin)
    return "points, lines and circles have no thickness and would pass through: take a small "
           "Sphere or a Capsule";
  if (a.type() == "Mesh" || b.type() == "Mesh")
    return "a Mesh is ground: it touches neither half spaces nor other meshes; for bodies take a "
           "<Polyhedron>, the convex hull of the same file or points";
  return "use balls and half spaces with all, boxes, polyhedra, capsules, "
         "cylinders, cones, tori, ellipsoids and smooth shapes with each other in space";
}

Diagnostic missingPair(const Shape& a, const Shape& b, const TouchingShape& A,
                       const TouchingShape& B, bool inSpace) {
  if (inSpace && (isEndless(a) || isEndless(b)))
    return pairFault(a, b, "a bore in space needs a length", "add length=\"…\" to <Bore>");
  if (!inSpace && (isAcross(A) || isAcross(B)))
    return pairFault(a, b,
                     "contact of " + withArticle(a.type()) + " with " + withArticle(b.type()) +
                         " needs axes along the normal of the plane of motion",
                     "in the plane xz that is euler=\"{pi/2} 0 0\" of both shapes");
  return pairFault(a, b,
                   "contact of " + withArticle(a.type()) + " with " + withArticle(b.type()) +
                       " is not available",
                   otherShapes(a, b, A.isThin() || B.isThin(), inSpace) +
                       " (all pairs: doc/shape_pairs.md), or <NoContact " + between(a, b) + "/>");
}

/// A torus whose tube has no radius has no inside: the other shape needs one whose gap has a sign.
bool circleMayTouch(const TouchingShape& torus, const TouchingShape& other) {
  if (torus.kind != RuleTouch::torus || torus.thickness > 0.0) return true;
  return other.kind == RuleTouch::halfSpace || (other.kind == RuleTouch::ball && other.bound > 0.0);
}

/// Rows of a law that depends on the motion of the contact over the body (rolling_contact.hpp).
constexpr int kContourRows = 8;

/// Rows offered to a law: normal, tangents, spin about the normal; in a plane normal and tangent.
/// Laws in space may also request rows for rolling and for the motion along the contour.
int offeredRows(const Vec3& plane) { return plane.isZero(0.0) ? 4 : 2; }

/// All properties of a shape on which kernels and friction along a grain depend. A contact rule
/// found for two shapes holds for all pairs of shapes with the same traits.
using Traits = std::array<std::uint64_t, 16>;

Traits traits(const TouchingShape& s) {
  const auto number = [](auto n) { return static_cast<std::uint64_t>(n); };
  Traits out{number(s.kind),
             number(s.features.size()),
             number(!s.grain_K.isZero(0.0)),
             number(s.bound == 0.0),
             number(s.thickness == 0.0),
             number(s.polygon_K.size()),
             number(s.kind == RuleTouch::contour && !s.features[0].contour->convex())};
  if (s.surface) {
    out[7] = 1, out[8] = number(s.surface->corners());
    out[9] = number(s.surface->edges()), out[10] = number(s.surface->faces().size());
  }
  if (s.polyhedron) {
    out[11] = 1, out[12] = number(s.polyhedron->corners().size());
    out[13] = number(s.polyhedron->edges().size()), out[14] = number(s.polyhedron->faces().size());
  }
  out[15] = reinterpret_cast<std::uintptr_t>(s.family);
  return out;
}

}  // namespace

/// Working data of PairRules::find().
class RuleSearch {
 public:
  RuleSearch(PairRules& out, ShapeSet& shapes, const Topology& topology,
             const StartKinematics& start)
      : out_(out), shapes_(shapes), topology_(topology), start_(start) {
    for (const PartialMechanicalSystem* s : topology.systems()) blocks_.push_back(s->blocks());
  }
  void group();
  /// Finds the rule of two groups of shapes.
  void addRule(std::size_t a, std::size_t b, PairLaws& laws, const PairTable& kernels);
  void countPairs();
  std::size_t groups() const { return groups_.size(); }
  void throwIfAny() { faults_.throwIfAny(); }

 private:
  /// Members of a group: its first shape, and one of another body or −1.
  struct Members {
    std::size_t first;
    int another = -1;
    std::int64_t count = 1;
  };
  const Blocks& blocksOf(std::size_t shape) const {
    return blocks_[static_cast<std::size_t>(shapes_.instance(shape).system)];
  }
  /// The materials of all shapes.
  std::set<std::string> materials() const {
    std::set<std::string> out;
    for (const Members& m : groups_) out.insert(shapes_.instance(m.first).shape->material());
    return out;
  }
  bool representatives(std::size_t a, std::size_t b, std::size_t& i, std::size_t& j) const;
  void checkRows(const PairRule& rule, const TouchingShape& A, const TouchingShape& B,
                 std::size_t i, std::size_t j);
  /// Reports a fault of the shapes i and j once per pair of words a, b. A shape that was made by
  /// its system is reported at the place of that system.
  void fault(std::size_t i, std::size_t j, const std::string& a, const std::string& b,
             Diagnostic d) {
    if (!told_.insert(std::minmax(a, b)).second) return;
    const auto placeOf = [&](std::size_t shape) {
      return topology_.systems()[static_cast<std::size_t>(shapes_.instance(shape).system)]->place();
    };
    if (d.place.line <= 0) d.place = placeOf(i);
    if (!d.notes.empty() && d.notes[0].place.line <= 0) d.notes[0].place = placeOf(j);
    faults_.add(std::move(d));
  }

  PairRules& out_;
  ShapeSet& shapes_;
  const Topology& topology_;
  const StartKinematics& start_;
  std::vector<Blocks> blocks_;  ///< per system
  std::vector<Members> groups_;
  Diagnostics faults_;
  std::set<std::pair<std::string, std::string>> told_;
};

/// Half spaces are in groups of their own, and so is what stands still beside bodies that move in
/// planes, as their sections differ. Nothing that stands still is in a group with what moves.
void RuleSearch::group() {
  const std::size_t n = shapes_.size();
  out_.group_.resize(n);
  using Key = std::tuple<std::string, double, double, double, int, Traits, Traits>;
  std::map<Key, int> known;
  bool inPlanes = false;
  for (std::size_t i = 0; i < n; ++i) inPlanes = inPlanes || !blocksOf(i).planeNormal.isZero(0.0);
  constexpr int kMoves = -1, kStands = -2;
  for (std::size_t i = 0; i < n; ++i) {
    const Blocks& blocks = blocksOf(i);
    const Vec3& plane = blocks.planeNormal;
    const TouchingShape &space = shapes_.inSpace()[i],
                        &own = shapes_.in(shapes_.planeNumber(plane, start_))[i];
    const bool stands = blocks.nu == 0,
               alone = (stands && inPlanes) || own.kind == RuleTouch::halfSpace;
    const Key key{shapes_.instance(i).shape->material(),
                  plane.x(),
                  plane.y(),
                  plane.z(),
                  alone    ? static_cast<int>(i)
                  : stands ? kStands
                           : kMoves,
                  traits(own),
                  traits(space)};
    const auto [at, isNew] = known.try_emplace(key, static_cast<int>(groups_.size()));
    out_.group_[i] = at->second;
    if (isNew) {
      groups_.push_back({.first = i});
      continue;
    }
    Members& members = groups_[static_cast<std::size_t>(at->second)];
    ++members.count;
    if (members.another < 0 && shapes_.body(members.first) != shapes_.body(i))
      members.another = static_cast<int>(i);
  }
  out_.groups_ = groups_.size();
  out_.table_.assign(groups_.size() * groups_.size(), -1);
}

/// Finds two shapes that represent the groups: of different bodies, one of which moves.
bool RuleSearch::representatives(std::size_t a, std::size_t b, std::size_t& i,
                                 std::size_t& j) const {
  const Members &first = groups_[a], &second = groups_[b];
  i = first.first, j = second.first;
  if (shapes_.body(i) == shapes_.body(j)) {
    if (second.another >= 0) {
      j = static_cast<std::size_t>(second.another);
    } else if (first.another >= 0) {
      i = static_cast<std::size_t>(first.another);
    } else {
      return false;
    }
  }
  return blocksOf(i).nu > 0 || blocksOf(j).nu > 0;
}

void RuleSearch::addRule(std::size_t a, std::size_t b, PairLaws& laws, const PairTable& kernels) {
  std::size_t i = 0, j = 0;
  if (!representatives(a, b, i, j)) return;
  PairRule made;
  const Vec3 plane = commonPlane(blocksOf(i), blocksOf(j));
  made.plane = shapes_.planeNumber(plane, start_);
  const TouchingShape *A = &shapes_.in(made.plane)[i], *B = &shapes_.in(made.plane)[j];
  if (A->kind < B->kind) std::swap(A, B);
  if (PairTable::neverTouch(*A, *B)) return;
  const bool inSpace = plane.isZero(0.0);
  made.kernel = kernels.find(*A, *B, inSpace ? PairTable::Room::space : PairTable::Room::plane);

  if (!circleMayTouch(*A, *B) || !circleMayTouch(*B, *A)) made.kernel = nullptr;

  // The law of the two materials.
  const Shape &shapeA = *shapes_.instance(i).shape, &shapeB = *shapes_.instance(j).shape;
  const std::string &ma = shapeA.material(), &mb = shapeB.material();
  const PairLaw& found = laws.find(ma, mb);
  if (!found.from)
    return fault(i, j, ma, mb, missingLaw(shapeA, shapeB, laws.missing(ma, mb, materials())));
  if (!found.law) return;
  if (!made.kernel)
    return fault(i, j, shapeA.type() + ma, shapeB.type() + mb,
                 missingPair(shapeA, shapeB, *A, *B, inSpace));
  made.law = found.law;

  // A half space that cuts the plane of motion at an angle needs both tangents.
  if (A->kind == RuleTouch::halfSpace && !inSpace) {
    const Vec3 n = start_.frame(A->frame).A_IK * A->n_K;
    if (std::abs(n.dot(plane)) > 1e-12) made.plane = 0;
  }
  made.rows = offeredRows(shapes_.plane(made.plane));
  checkRows(made, *A, *B, i, j);
  made.grain = !A->grain_K.isZero(0.0) || !B->grain_K.isZero(0.0);
  made.features = made.kernel->features(*A, *B);
  made.followed = made.features - made.kernel->followed(*A, *B);
  made.following = made.kernel->following(*A, *B);
  made.work = made.kernel->work(*A, *B);
  const auto number = static_cast<int>(out_.rules_.size());
  out_.table_[a * groups_.size() + b] = out_.table_[b * groups_.size() + a] = number;
  out_.rules_.push_back(made);
}

/// Reports a law that has more rows than the contact offers, or that needs another grain.
void RuleSearch::checkRows(const PairRule& rule, const TouchingShape& A, const TouchingShape& B,
                           std::size_t i, std::size_t j) {
  const Shape &shapeA = *shapes_.instance(i).shape, &shapeB = *shapes_.instance(j).shape;
  const std::string &ma = shapeA.material(), &mb = shapeB.material();
  const int asked = rule.law->dim(rule.rows);
  const bool inSpace = shapes_.plane(rule.plane).isZero(0.0);
  const bool contour = asked == kContourRows && (A.kind != RuleTouch::halfSpace || B.family);
  if (contour || asked > (inSpace ? kContourRows : rule.rows))
    fault(i, j, ma, mb, tooManyRows(shapeA, shapeB, contour));
  const GrainFault grain = grainFault(A, B, *rule.law, rule.rows);
  if (!grain.text.empty()) fault(i, j, ma, mb, pairFault(shapeA, shapeB, grain.text, grain.hint));
}

/// How many pairs there are and how many contacts each may have.
void RuleSearch::countPairs() {
  for (std::size_t a = 0; a < groups_.size(); ++a)
    for (std::size_t b = a; b < groups_.size(); ++b) {
      if (out_.table_[a * groups_.size() + b] < 0) continue;
      const std::int64_t count = groups_[a].count;
      out_.count_ += a == b ? count * (count - 1) / 2 : count * groups_[b].count;
    }
  for (const PairRule& r : out_.rules_) out_.features_ = std::max(out_.features_, r.features);
  // Pairs of shapes of one body are subtracted; these shapes lie next to each other in the list.
  const std::size_t n = shapes_.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n && shapes_.body(j) == shapes_.body(i); ++j)
      if (out_.of(i, j) >= 0) --out_.count_;
}

void PairRules::find(ShapeSet& shapes, const Topology& topology, const StartKinematics& start,
                     PairLaws& laws, const PairTable& kernels) {
  *this = PairRules();
  shapes_ = &shapes;
  RuleSearch search(*this, shapes, topology, start);
  search.group();
  for (std::size_t a = 0; a < groups_; ++a)
    for (std::size_t b = a; b < groups_; ++b) search.addRule(a, b, laws, kernels);
  search.throwIfAny();
  search.countPairs();
  listFew();
  checkNumbers();
}

void PairRules::listFew() {
  if (count_ > kMostNamedPairs) return;
  const int n = static_cast<int>(shapes_->size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      if (pair(i, j)) few_.emplace_back(i, j);
}

void PairRules::checkNumbers() const {
  const auto all = static_cast<double>(shapes_->size());
  if (static_cast<double>(features_) * all * all > kMostNumbers)
    throw ModelError(
        "there are too many shapes to number their contacts: " + std::to_string(shapes_->size()) +
            " shapes with up to " + std::to_string(features_) + " contacts of two",
        "give shapes that nothing touches no material");
}

TouchingPair PairRules::pair(int i, int j) const {
  if (i > j) std::swap(i, j);
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  const int made = of(a, b);
  if (made < 0 || shapes_->body(a) == shapes_->body(b)) return {};
  TouchingPair out;
  out.rule = &rules_[static_cast<std::size_t>(made)];
  const std::vector<TouchingShape>& shapes = shapes_->in(out.rule->plane);
  out.A = &shapes[a], out.B = &shapes[b];
  if (out.A->kind < out.B->kind) std::swap(out.A, out.B);
  out.id = (a * shapes_->size() + b) * features_, out.i = a, out.j = b;
  return out;
}

std::string PairRules::contactName(std::uint64_t id) const {
  std::string pair;
  const TouchingPair found = named(id, pair);
  if (!found) return {};
  const std::string feature = found.rule->kernel->featureName(*found.A, *found.B, id % features_);
  return pair + (feature.empty() ? "" : "." + feature);
}

std::string PairRules::pairName(std::uint64_t id) const {
  std::string pair;
  named(id, pair);
  return pair;
}

/// The pair of contact `id`, and its name.
TouchingPair PairRules::named(std::uint64_t id, std::string& name) const {
  const std::uint64_t pairNumber = id / features_, n = shapes_->size();
  if (pairNumber >= n * n) return {};  // number read from a file
  const std::size_t i = pairNumber / n, j = pairNumber % n;
  const TouchingPair found = pair(static_cast<int>(i), static_cast<int>(j));
  if (!found) return {};
  // The name begins with the shape that rests on the other one.
  std::string a = shapes_->name(i), b = shapes_->name(j);
  const bool swapped = found.A != &shapes_->in(found.rule->plane)[i];
  if (swapped != (found.A->kind != found.B->kind)) std::swap(a, b);
  name = a + "-" + b;
  return found;
}

}  // namespace dynamy
