#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/simulation/model.hpp>
#include <dynamy_elements/contacts/box_contact.hpp>
#include <dynamy_elements/contacts/shape_contacts.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <map>
#include <set>

namespace dynamy {
namespace {

using Touch = TouchingShape::Kind;

constexpr int kMostNamedPairs = 64;  ///< beyond, single contacts have no signals

/// Is a contact of these two implemented? Half spaces never meet, points neither.
enum class Meeting { never, implemented, missing };
Meeting meeting(const TouchingShape& a, const TouchingShape& b, bool inPlane) {
  if (a.kind == Touch::halfSpace && b.kind == Touch::halfSpace) return Meeting::never;
  if (a.kind == Touch::none || b.kind == Touch::none) return Meeting::missing;
  if (a.kind == Touch::halfSpace || b.kind == Touch::halfSpace) return Meeting::implemented;
  if (a.kind == Touch::round && b.kind == Touch::round)
    return a.features[0].radius + b.features[0].radius > 0.0 ? Meeting::implemented
                                                             : Meeting::never;
  // Boxes that move in one plane would need polygons; a ball does with a box's section.
  if (a.kind == Touch::corners && b.kind == Touch::corners)
    return a.features.size() == 8 && b.features.size() == 8 ? Meeting::implemented
                                                            : Meeting::missing;
  const TouchingShape& box = a.kind == Touch::corners ? a : b;
  return inPlane == (box.features.size() == 4) ? Meeting::implemented : Meeting::missing;
}

Diagnostic pairFault(const Shape& a, const Shape& b, std::string text, std::string hint) {
  Diagnostic d;
  d.place = a.place();
  d.element = a.type() + (a.name().empty() ? "" : " name=\"" + a.name() + "\"");
  d.text = std::move(text), d.hint = std::move(hint);
  d.notes.push_back({.place = b.place(), .text = "the other shape: <" + b.type() + ">"});
  return d;
}

std::string label(const TouchingShape& s, const Topology& topology) {
  const std::string& system = topology.systems()[static_cast<std::size_t>(s.system)]->name();
  if (!s.shape->name().empty()) return s.shape->name();
  return system.empty() ? "body" + std::to_string(s.system) : system;
}

bool isBallOnBox(const TouchingShape& A, const TouchingShape& B) {
  return A.kind == Touch::corners && B.kind == Touch::round;
}
bool areBoxes(const TouchingShape& A, const TouchingShape& B) {
  return A.kind == Touch::corners && B.kind == Touch::corners;
}

/// Normal, tangents, spin about the normal; in a plane normal and tangent.
int offeredRows(const Vec3& plane) { return plane.isZero(0.0) ? 4 : 2; }

}  // namespace

void ShapeContacts::expectOneRulePerPair() const {
  Diagnostics faults;
  for (const ContactRule* r : rules_) {
    const ContactRule* first = rule(r->materialA(), r->materialB());
    if (first == r) continue;
    faults.add({.place = r->place(),
                .element = r->type(),
                .text = "the materials \"" + r->materialA() + "\" and \"" + r->materialB() +
                        "\" have a rule already",
                .hint = "remove one of the two",
                .notes = {{.place = first->place(), .text = "the first rule"}}});
  }
  faults.throwIfAny();
}

const ContactRule* ShapeContacts::rule(const std::string& a, const std::string& b) const {
  for (const ContactRule* r : rules_)
    if ((r->materialA() == a && r->materialB() == b) ||
        (r->materialA() == b && r->materialB() == a))
      return r;
  return nullptr;
}

/// What connect() looks at for every pair of shapes.
struct ShapeContacts::Search {
  explicit Search(Topology& t) : topology(t), shapes(t.shapesWithMaterial()), start(t) {
    for (const PartialMechanicalSystem* s : t.systems()) blocks.push_back(s->blocks());
  }
  const Blocks& blocksOf(const ShapeInstance& s) const {
    return blocks[static_cast<std::size_t>(s.system)];
  }
  /// Tells a fault once per pair of words.
  void fault(const std::string& a, const std::string& b, Diagnostic d) {
    if (told.insert(std::minmax(a, b)).second) faults.add(std::move(d));
  }

  const Topology& topology;
  std::vector<ShapeInstance> shapes;
  StartKinematics start;
  std::vector<Blocks> blocks;
  Diagnostics faults;
  std::set<std::pair<std::string, std::string>> told;
  std::map<std::string, int> names;
};

void ShapeContacts::connect(Topology& topology) {
  pairs_.clear();
  expectOneRulePerPair();
  Search search(topology);
  for (std::size_t i = 0; i < search.shapes.size(); ++i)
    for (std::size_t j = i + 1; j < search.shapes.size(); ++j)
      addPair(search.shapes[i], search.shapes[j], search);
  search.faults.throwIfAny();
  noteMovers();
}

void ShapeContacts::addPair(const ShapeInstance& a, const ShapeInstance& b, Search& search) {
  const Blocks &blocksA = search.blocksOf(a), &blocksB = search.blocksOf(b);
  if (a.system == b.system || (blocksA.nu == 0 && blocksB.nu == 0)) return;
  Pair pair;
  pair.plane = commonPlane(blocksA, blocksB);
  const auto shapeOf = [&](const ShapeInstance& s) {
    return touchingShape(s, search.start.frame(s.frame).A_IK.transpose() * pair.plane);
  };
  pair.A = shapeOf(a), pair.B = shapeOf(b);
  const Meeting meets = meeting(pair.A, pair.B, !pair.plane.isZero(0.0));
  if (meets == Meeting::never) return;

  // The law of the two materials.
  const std::string &ma = a.shape->material(), &mb = b.shape->material();
  const std::string both = "between=\"" + ma + " " + mb + "\"";
  const ContactRule* found = rule(ma, mb);
  if (!found) {
    search.fault(ma, mb,
                 pairFault(*a.shape, *b.shape,
                           "no law for contact of the materials \"" + ma + "\" and \"" + mb + "\"",
                           "add <Contact " + both + ">…</Contact>, or <NoContact " + both + "/>"));
    return;
  }
  if (!found->law()) return;
  if (meets == Meeting::missing) {
    search.fault(
        a.shape->type() + ma, b.shape->type() + mb,
        pairFault(
            *a.shape, *b.shape,
            "contact of a " + a.shape->type() + " with a " + b.shape->type() + " is not available",
            "use balls and points on all, boxes on half spaces, boxes in space, or <NoContact " +
                both + "/>"));
    return;
  }
  pair.law = found->law();

  // The half space is A, else the box. One that cuts the plane of motion at an angle needs both
  // tangents.
  if (pair.B.kind == Touch::halfSpace || isBallOnBox(pair.B, pair.A)) std::swap(pair.A, pair.B);
  const bool onHalfSpace = pair.A.kind == Touch::halfSpace;
  if (onHalfSpace && !pair.plane.isZero(0.0)) {
    const Vec3 n = search.start.frame(pair.A.frame).A_IK * pair.A.n_K;
    if (std::abs(n.dot(pair.plane)) > 1e-12) pair.plane.setZero();
  }
  pair.rows = offeredRows(pair.plane);
  // Boxes are looked at where their circumscribed balls meet.
  pair.balls = pair.A.half.norm() + pair.B.half.norm();
  pair.offsets = pair.A.p_K.norm() + pair.B.p_K.norm();
  if (pair.law->dim(pair.rows) > pair.rows)
    search.fault(
        ma, mb,
        pairFault(*a.shape, *b.shape, "the law has more rows than a contact in a plane offers",
                  "take a law without a spin row, or bodies in space"));
  const std::string nameA = label(pair.A, search.topology), nameB = label(pair.B, search.topology);
  pair.name =
      onHalfSpace || isBallOnBox(pair.A, pair.B) ? nameB + "-" + nameA : nameA + "-" + nameB;
  if (const int count = ++search.names[pair.name]; count > 1)
    pair.name += "#" + std::to_string(count);
  pairs_.push_back(std::move(pair));
}

void ShapeContacts::contacts(const Kinematics& k, ContactSink& sink) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const Frame &A = k.frame(pair.A.frame), &B = k.frame(pair.B.frame);
    const std::uint64_t id = i * kMaxFeatures;
    if (pair.A.kind == Touch::halfSpace) {
      const OverHalfSpace over(A, pair.A, B);
      for (std::size_t f = 0; f < pair.B.features.size(); ++f) {
        const RoundFeature& feature = pair.B.features[f];
        emit(pair, id + f, over.gap(feature), k, sink,
             [&] { return over.contact(feature, pair.plane); });
      }
      continue;
    }
    if (areBoxes(pair.A, pair.B)) {
      boxes(pair, id, k, sink);
      continue;
    }
    if (isBallOnBox(pair.A, pair.B)) {
      const RoundFeature& ball = pair.B.features[0];
      // Reported as early as two balls are.
      const double reach = 0.5 * (ball.radius + pair.A.half.minCoeff());
      const ContactPoint at = ballOnBox(A, pair.A, B, ball, pair.plane);
      if (sink.request().refresh || at.g <= reach)
        emit(pair, id, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
      continue;
    }
    // Balls further apart than half the sum of their radii are not reported.
    const RoundFeature &a = pair.A.features[0], &b = pair.B.features[0];
    const double reach = 1.5 * (a.radius + b.radius);
    const Vec3 r = B.r_OS_I + B.A_IK * b.c_K - A.r_OS_I - A.A_IK * a.c_K;
    if (!sink.request().refresh && r.squaredNorm() > reach * reach) continue;
    const ContactPoint at = betweenBalls(A, a, B, b, pair.plane);
    emit(pair, id, at.g, k, sink, [&]() -> const ContactPoint& { return at; });
  }
}

void ShapeContacts::boxes(const Pair& pair, std::uint64_t id, const Kinematics& k,
                          ContactSink& sink) const {
  const Frame &A = k.frame(pair.A.frame), &B = k.frame(pair.B.frame);
  // First the frames, whose origins are not far from the centres, then the centres.
  const double balls = pair.balls + sink.request().gTol, far = balls + pair.offsets;
  const Vec3 d = B.r_OS_I - A.r_OS_I;
  if (d.squaredNorm() > far * far) return;
  const Vec3 r = d + B.A_IK * pair.B.p_K - A.A_IK * pair.A.p_K;
  if (r.squaredNorm() > balls * balls) return;
  std::array<BoxContact, kMostBoxContacts> found;
  const int n =
      betweenBoxes(placedBox(A, pair.A), placedBox(B, pair.B), sink.request().bias, found);
  for (int c = 0; c < n; ++c) {
    const BoxContact& contact = found[static_cast<std::size_t>(c)];
    emit(pair, id + static_cast<std::uint64_t>(contact.id), contact.at.g, k, sink,
         [&]() -> const ContactPoint& { return contact.at; });
  }
}

template <class At>
void ShapeContacts::emit(const Pair& pair, std::uint64_t id, double g, const Kinematics& k,
                         ContactSink& sink, At&& closed) const {
  ContactRows rows = sink.add(id, g, *pair.law, pair.rows);
  if (!rows) return;
  const ContactPoint& at = closed();
  const Frame &A = k.frame(pair.A.frame), &B = k.frame(pair.B.frame);
  const Vec3 rhoA = at.P - A.r_OS_I, rhoB = at.P - B.r_OS_I;
  pointContact(rows, A, rhoA, B, rhoB, at.d[0], at.d[1], at.d[2]);
  if (!rows.wantsBias()) return;
  // The point of contact moves with Ṗ, not with a body.
  const Vec3 v_BA = B.velocity(rhoB) - A.velocity(rhoA);
  const Vec3 a_BA = B.bias_S_I + B.bias_R_I.cross(rhoB) + B.Omega_I.cross(at.Pdot - B.v_S_I) -
                    A.bias_S_I - A.bias_R_I.cross(rhoA) - A.Omega_I.cross(at.Pdot - A.v_S_I);
  for (int r = 0; r < rows.dim() && r < 3; ++r)
    rows.bias(r) = at.ddot[r].dot(v_BA) + at.d[r].dot(a_BA);
  if (rows.dim() > 3)  // the spin about the normal
    rows.bias(3) = at.ddot[0].dot(B.Omega_I - A.Omega_I) + at.d[0].dot(B.bias_R_I - A.bias_R_I);
}

namespace {

std::string boxFeature(std::uint64_t id) {
  if (id < 8) return "B.corner" + std::to_string(id);
  if (id < 16) return "A.corner" + std::to_string(id - 8);
  return "edges" + std::to_string((id - 16) / 12) + "-" + std::to_string((id - 16) % 12);
}

}  // namespace

std::string ShapeContacts::contactName(std::uint64_t id) const {
  const Pair& pair = pairs_[static_cast<std::size_t>(id / kMaxFeatures)];
  if (areBoxes(pair.A, pair.B)) return pair.name + '.' + boxFeature(id % kMaxFeatures);
  const bool single = pair.A.kind != Touch::halfSpace || pair.B.features.size() == 1;
  return single ? pair.name : pair.name + ".corner" + std::to_string(id % kMaxFeatures);
}

void ShapeContacts::describe(Description& d) const {
  d.signal("contacts.count", Unit::none, "closed contacts between shapes", [](const SignalView& v) {
    return static_cast<double>(
        std::count(v.contacts->element.begin(), v.contacts->element.end(), v.element));
  });
  if (pairs() > kMostNamedPairs) return;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const int geometric = pair.plane.isZero(0.0) ? 3 : 2;
    if (areBoxes(pair.A, pair.B)) continue;  // 160 possible contacts: by their count alone
    const bool single = pair.A.kind != Touch::halfSpace || pair.B.features.size() == 1;
    const std::size_t features = single ? 1 : pair.B.features.size();
    for (std::size_t f = 0; f < features; ++f) {
      const std::uint64_t id = i * kMaxFeatures + f;
      describeContact(d, id, geometric, *pair.law, contactName(id) + ".");
    }
  }
}

void addShapeContacts(Model& model) {
  bool any = false;
  for (const auto& system : model.systems()) {
    Description d;
    system->describe(d);
    for (const PlacedShape& placed : d.shapes) any = any || !placed.shape->material().empty();
  }
  if (!any) return;
  std::vector<const ContactRule*> rules;
  for (const auto& rule : model.rules()) rules.push_back(rule.get());
  model.add(std::make_unique<ShapeContacts>(std::move(rules)));
}

}  // namespace dynamy
