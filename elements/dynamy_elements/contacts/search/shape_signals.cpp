#include <algorithm>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy_elements/contacts/search/shape_signals.hpp>

namespace dynamy {
namespace {

constexpr std::uint64_t kMostNamedFeatures = 32;

struct Overlaps {
  double mean = 0.0, deepest = 0.0;  ///< [m]
};

Overlaps overlaps(const SignalView& v) {
  Overlaps out;
  const ContactSet& c = *v.contacts;
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < c.g.size(); ++i)
    if (c.candidateElement[i] == v.element && c.g[i] < 0.0)
      sum -= c.g[i], ++count, out.deepest = std::max(out.deepest, -c.g[i]);
  if (count > 0) out.mean = sum / count;
  return out;
}

/// Force on the shapes of ground number `ground`, along `axis` [N].
double load(const SignalView& v, const ShapeSet& shapes, const PairRules& rules, int ground,
            int axis) {
  const ContactSet& c = *v.contacts;
  if (!(v.dt > 0.0) || v.Lambda.size() != c.rows()) return 0.0;
  const std::uint64_t n = shapes.size();
  double sum = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (c.element[at] != v.element) continue;
    const std::uint64_t number = contactNumber(c.key[at]) / rules.features();
    const auto a = static_cast<std::size_t>(number / n), b = static_cast<std::size_t>(number % n);
    if (shapes.ground(a) != ground && shapes.ground(b) != ground) continue;
    const std::size_t mine = shapes.ground(a) == ground ? a : b;
    const TouchingPair pair = rules.pair(static_cast<int>(a), static_cast<int>(b));
    const double* Lambda = v.Lambda.data() + c.row0[at];
    double onB = Lambda[0] * c.places.normal[at][axis];
    if (c.dim(i) > 1) onB += Lambda[1] * c.places.t1[at][axis];
    if (c.dim(i) > 2) onB += Lambda[2] * c.places.t2[at][axis];
    sum += pair.B == &shapes.in(pair.rule->plane)[mine] ? onB : -onB;
  }
  return sum / v.dt;
}

/// Numbers of the signals of contact f. For polygons they include the followed pairs of the corner
/// f with each side of the other polygon.
ContactNumbers numbers(const TouchingPair& pair, std::uint64_t f) {
  const FollowedPartners more = pair.rule->kernel->partners(*pair.A, *pair.B, f);
  if (more.count == 0) return {pair.id + f, 0, 0};
  return {pair.id + f, pair.id + pair.rule->followed + more.first, more.count};
}

}  // namespace

/// Adds the signals of two shapes with several contacts: sums of their normal forces and percussions.
void describePair(Description& d, std::uint64_t first, std::uint64_t end,
                  const std::string& prefix) {
  const auto sum = [first, end](const SignalView& v, const ContactSet& c, const ConstVec& Lambda) {
    double out = 0.0;
    for (int i = 0; i < c.size() && Lambda.size() == c.rows(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const std::uint64_t id = contactNumber(c.key[at]);
      if (c.element[at] == v.element && id >= first && id < end) out += Lambda[c.row0[at]];
    }
    return out;
  };
  d.signal(prefix + "Lambda_N", Unit::impulse, "sum of the normal percussions of the step",
           [=](const SignalView& v) {
             return sum(v, v.stepContacts ? *v.stepContacts : *v.contacts,
                        v.stepContacts ? v.stepLambda : v.Lambda);
           });
  d.signal(prefix + "lambda_N", Unit::force, "sum of the normal forces", [=](const SignalView& v) {
    return v.dt > 0.0 ? sum(v, *v.contacts, v.Lambda) / v.dt : 0.0;
  });
}

void describeContacts(Description& d, const ShapeSet& shapes, const PairRules& rules) {
  d.signal("contacts.count", Unit::none, "closed contacts between shapes", [](const SignalView& v) {
    return static_cast<double>(
        std::count(v.contacts->element.begin(), v.contacts->element.end(), v.element));
  });
  d.signal("contacts.meanOverlap", Unit::length, "mean of all pairs that overlap",
           [](const SignalView& v) { return overlaps(v).mean; });
  d.signal("contacts.deepestOverlap", Unit::length, "of all pairs",
           [](const SignalView& v) { return overlaps(v).deepest; });
  const char* const axes[3] = {".Fx", ".Fy", ".Fz"};
  for (std::size_t g = 0; g < shapes.grounds().size(); ++g)
    for (int k = 0; k < 3; ++k)
      d.signal(shapes.grounds()[g] + axes[k], Unit::force,
               "of all contacts on the shapes of this ground",
               [&shapes, &rules, g, k](const SignalView& v) {
                 return load(v, shapes, rules, static_cast<int>(g), k);
               });
  for (const auto& [i, j] : rules.few()) {
    const TouchingPair pair = rules.pair(i, j);
    const int geometric = pair.rule->plane == 0 ? 3 : 2;
    // Of some pairs all contacts are followed one by one.
    const std::uint64_t named = pair.rule->followed > 0 ? pair.rule->followed : pair.rule->features;
    const PairKernel& kernel = *pair.rule->kernel;
    if (pair.rule->features > 1 && !kernel.featureName(*pair.A, *pair.B, 0).empty())
      describePair(d, pair.id, pair.id + pair.rule->features, rules.pairName(pair.id) + ".");
    if (named > kMostNamedFeatures) continue;  // only their number is a signal
    for (std::uint64_t f = 0; f < named; ++f)
      describeContact(d, numbers(pair, f), geometric, *pair.rule->law,
                      rules.contactName(pair.id + f) + ".");
  }
}

}  // namespace dynamy
