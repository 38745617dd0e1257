// Signals of the contacts between shapes: each contact if they are few,
// sums of many, loads on the ground.
#include <algorithm>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>

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

}  // namespace

/// Force on the shapes of ground number `ground`, along `axis` [N].
double ShapeContacts::load(const SignalView& v, int ground, int axis) const {
  const ContactSet& c = *v.contacts;
  if (!(v.dt > 0.0) || v.Lambda.size() != c.rows()) return 0.0;
  const std::uint64_t n = body_.size();
  double sum = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (c.element[at] != v.element) continue;
    const std::uint64_t number = contactNumber(c.key[at]) / features_;
    const auto a = static_cast<std::size_t>(number / n), b = static_cast<std::size_t>(number % n);
    if (ground_[a] != ground && ground_[b] != ground) continue;
    const std::size_t mine = ground_[a] == ground ? a : b;
    const Pair pair = pairOf(static_cast<int>(a), static_cast<int>(b));
    const double* Lambda = v.Lambda.data() + c.row0[at];
    double onB = Lambda[0] * c.normal[at][axis];
    if (c.dim(i) > 1) onB += Lambda[1] * c.t1[at][axis];
    if (c.dim(i) > 2) onB += Lambda[2] * c.t2[at][axis];
    sum += pair.B == &shapes_[pair.rule->plane][mine] ? onB : -onB;
  }
  return sum / v.dt;
}

/// Numbers of the signals of contact f. For polygons they include the followed pairs of the corner
/// f with each side of the other polygon.
ContactNumbers ShapeContacts::numbers(const Pair& pair, std::uint64_t f) {
  if (pair.rule->meets != Meeting::polygons) return {pair.id + f, 0, 0};
  const std::uint64_t a = pair.A->polygon_K.size(), b = pair.B->polygon_K.size(),
                      first = pair.id + pair.rule->followed;
  return f < b ? ContactNumbers{pair.id + f, first + f * a, a}
               : ContactNumbers{pair.id + f, first + a * b + (f - b) * b, b};
}

void ShapeContacts::describe(Description& d) const {
  d.signal("contacts.count", Unit::none, "closed contacts between shapes", [](const SignalView& v) {
    return static_cast<double>(
        std::count(v.contacts->element.begin(), v.contacts->element.end(), v.element));
  });
  d.signal("contacts.meanOverlap", Unit::length, "mean of all pairs that overlap",
           [](const SignalView& v) { return overlaps(v).mean; });
  d.signal("contacts.deepestOverlap", Unit::length, "of all pairs",
           [](const SignalView& v) { return overlaps(v).deepest; });
  const char* const axes[3] = {".Fx", ".Fy", ".Fz"};
  for (std::size_t g = 0; g < grounds_.size(); ++g)
    for (int k = 0; k < 3; ++k)
      d.signal(grounds_[g] + axes[k], Unit::force, "of all contacts on the shapes of this ground",
               [this, g, k](const SignalView& v) { return load(v, static_cast<int>(g), k); });
  for (const auto& [i, j] : namedPairs_) {
    const Pair pair = pairOf(i, j);
    const int geometric = pair.rule->plane == 0 ? 3 : 2;
    if (pair.rule->followed > kMostNamedFeatures) continue;  // only their number is a signal
    for (std::uint64_t f = 0; f < pair.rule->followed; ++f)
      describeContact(d, numbers(pair, f), geometric, *pair.rule->law,
                      contactName(pair.id + f) + ".");
  }
}

}  // namespace dynamy
