#include <dynamy/simulation/model/model.hpp>
#include <dynamy_elements/contacts/kernels/follow_pairs.hpp>
#include <dynamy_elements/contacts/kernels/given_pair.hpp>
#include <dynamy_elements/contacts/kernels/standard_pairs.hpp>
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

void ShapeContacts::describe(Description& d) const { describeContacts(d, shapes_, rules_); }

void ShapeContacts::contacts(const Kinematics& k, ContactSink& sink) const {
  const ContactRequest& request = sink.request();
  const bool named = request.refresh && request.alone;
  if (named && request.frozen.size() <= 1) return namedAlone(k, sink);
  near_.place(k, request);
  const auto each = [&](int i, int j) {
    const TouchingPair pair = rules_.pair(i, j);
    // Contacts that are named alone come in the same order as with all others.
    if (!pair || (named && sink.asked(pair.id, pair.id + rules_.features()).empty())) return;
    report(pair, named ? Look::here : Look::ahead, k, sink);
  };
  near_.overHalfSpaces(k, request, each);
  near_.others(k, each);
}

/// Reports the contacts of those pairs only that are requested by key.
void ShapeContacts::namedAlone(const Kinematics& k, ContactSink& sink) const {
  const std::uint64_t n = shapes_.size(), features = rules_.features();
  std::uint64_t last = n * n;
  for (const ContactKey key : sink.asked(0, n * n * features)) {
    const std::uint64_t number = contactNumber(key) / features;
    if (number == last) continue;
    last = number;
    if (const TouchingPair pair =
            rules_.pair(static_cast<int>(number / n), static_cast<int>(number % n)))
      report(pair, Look::here, k, sink);
  }
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
  if (!sink.request().follow) return rule.kernel->contacts(to);
  if (rule.following == Following::pairwise) return rule.kernel->follow(to);
  const bool noted =
      rule.following == Following::jumping || (rule.following == Following::searched && !few);
  return noted && look == Look::ahead ? watch(to) : rule.kernel->contacts(to);
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
