#include <algorithm>
#include <cmath>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/kernels/given_pair.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
#include <dynamy_elements/contacts/pairs/seen_apart.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>
#include <dynamy_elements/contacts/search/shape_signals.hpp>
#include <set>

namespace dynamy {
namespace {

/// The pairs of the standard shapes, and those that shapes of plug-ins bring.
PairTable kernelsOf(const ShapeSet& shapes) {
  PairTable out;
  addStandardPairs(out);
  std::set<const ShapeFamily*> known{nullptr};
  for (const TouchingShape& s : shapes.inSpace())
    if (known.insert(s.family).second) addFamily(out, *s.family);
  return out;
}

}  // namespace

void ShapeContacts::connect(Topology& topology) {
  laws_->verify();
  std::vector<ShapeInstance> instances = topology.shapesWithMaterial();
  const StartKinematics start(topology);  // of the frames that carry them, too
  shapes_ = ShapeSet(std::move(instances), topology, start);
  kernels_ = kernelsOf(shapes_);
  rules_.find(shapes_, topology, start, *laws_, kernels_);
  near_ = NearPairs(shapes_, rules_);
  sweep_ = ShapeSweep(shapes_, rules_);
}

void ShapeContacts::describe(Description& d) const {
  d.timeless = true;
  describeContacts(d, shapes_, rules_);
}

void ShapeContacts::contacts(const Kinematics& k, ContactSink& sink) const {
  const ContactRequest& request = sink.request();
  if (request.refresh && request.alone) return namedAlone(k, sink);
  if (request.near != nullptr) {
    sink.forNear([&](std::uint64_t id) {
      if (const TouchingPair pair = pairOf(id)) report(pair, Look::ahead, k, sink);
    });
    return;
  }
  near_.place(k, request);
  const auto each = [&](int i, int j) {
    if (const TouchingPair pair = rules_.pair(i, j)) report(pair, Look::ahead, k, sink);
  };
  near_.overHalfSpaces(k, request, each);
  near_.others(k, each);
}

/// Reports the contacts of those pairs only that are requested by key, in the same order as with all
/// others: those with a half space come first.
void ShapeContacts::namedAlone(const Kinematics& k, ContactSink& sink) const {
  const std::uint64_t n = shapes_.size(), features = rules_.features();
  const auto flat = [&](std::size_t i) { return !std::isfinite(shapes_.inSpace()[i].bound); };
  named_.clear();
  for (const ContactKey key : sink.asked(0, n * n * features)) {
    const TouchingPair pair = pairOf(contactNumber(key));
    if (pair && (named_.empty() || named_.back().id != pair.id)) named_.push_back(pair);
  }
  const auto others =
      std::stable_partition(named_.begin(), named_.end(),
                            [&](const TouchingPair& pair) { return flat(pair.i) || flat(pair.j); });
  // Half spaces are called in turn, each with the shapes that it meets.
  std::stable_sort(named_.begin(), others, [&](const TouchingPair& a, const TouchingPair& b) {
    return (flat(a.i) ? a.i : a.j) < (flat(b.i) ? b.i : b.j);
  });
  for (const TouchingPair& pair : named_) report(pair, Look::here, k, sink);
}

/// The pair of the contact number `id`.
TouchingPair ShapeContacts::pairOf(std::uint64_t id) const {
  const std::uint64_t n = shapes_.size(), number = id / rules_.features();
  return rules_.pair(static_cast<int>(number / n), static_cast<int>(number % n));
}

bool ShapeContacts::nearOnPath(const Kinematics& start, const PathReach& reach, int element,
                               NearContacts& out) const {
  near_.onPath(start, reach, [&](int i, int j) {
    if (const TouchingPair pair = rules_.pair(i, j))
      out.add(element, pair.id, pair.id + rules_.features());
  });
  return true;
}

bool ShapeContacts::framesOf(std::uint64_t id, std::vector<FrameHandle>& out) const {
  const TouchingPair pair = pairOf(id);
  if (pair) out.push_back(pair.A->frame), out.push_back(pair.B->frame);
  return bool(pair);
}

void ShapeContacts::report(const TouchingPair& pair, Look look, const Kinematics& k,
                           ContactSink& sink) const {
  const PairRule& rule = *pair.rule;
  const bool few = !rules_.few().empty();
  const PosedPair posed{*pair.A, *pair.B, k.frame(pair.A->frame), k.frame(pair.B->frame),
                        shapes_.plane(rule.plane)};
  const double reach = few || sink.request().refresh ? std::numeric_limits<double>::infinity()
                                                     : near_.reach(pair.i, pair.j);
  PairReport to(posed, rule, pair.id, reach, sink, features_);
  if (!sink.request().follow) {
    // Searches for these pairs take longest, and most of them are apart.
    const bool searched = rule.work > kDearWork;
    const bool apart = searched && rule.plane == 0 && std::isfinite(reach) &&
                       seenApart(posed.a, posed.b, posed.A, posed.B, reach);
    if (apart) return;
    if (searched) sink.searched(rule.work);
    return rule.kernel->contacts(to);
  }
  if (rule.following == Following::pairwise) return rule.kernel->follow(to);
  if (rule.following != Following::gaps) sink.searched(rule.work);
  const bool jumps = rule.following == Following::jumping,
             noted = jumps || (rule.following == Following::searched && !few),
             watches = look == Look::ahead || (jumps && sink.request().absent);
  return noted && watches ? watch(to) : rule.kernel->contacts(to);
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
