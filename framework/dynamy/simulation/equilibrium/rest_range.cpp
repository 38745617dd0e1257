#include <algorithm>
#include <cmath>
#include <dynamy/simulation/equilibrium/rest_range.hpp>
#include <limits>
#include <optional>

namespace dynamy {
namespace {

/// Forces beyond their bounds by this share of the largest hold nothing: less than is allowed to a
/// single equilibrium, so that ends are accurate.
constexpr double kNoForce = 3e-12;

class Ends {
 public:
  explicit Ends(const std::function<Equilibrium(double)>& at) : at_(at) {}

  std::optional<Equilibrium> rest(double value) {
    try {
      Equilibrium e = at_(value);
      if (e.margin >= -kNoForce) return e;
      why_ = "the laws of the contacts permit no more";
    } catch (const ModelError& error) {
      why_ = error.what();
    }
    return std::nullopt;
  }
  /// The end between `in`, where there is a rest, and `out`.
  double end(double in, double out, std::string& why) {
    Equilibrium last = *rest(in);
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (in + out);
      if (middle == in || middle == out) break;
      if (std::optional<Equilibrium> e = rest(middle))
        in = middle, last = *std::move(e);
      else
        out = middle;
    }
    rest(out);
    why = name(last);
    return in;
  }

 private:
  /// The contact that is nearest to its bound.
  std::string name(const Equilibrium& e) const {
    const auto least = std::min_element(
        e.contacts.begin(), e.contacts.end(),
        [](const CarryingContact& a, const CarryingContact& b) { return a.margin < b.margin; });
    double force = std::numeric_limits<double>::min();
    for (const CarryingContact& c : e.contacts)
      for (const double l : c.lambda) force = std::max(force, std::abs(l));
    if (least == e.contacts.end() || least->margin > 1e-6 * force) return why_;
    const bool open = !least->lambda.empty() && std::abs(least->lambda[0]) < 1e-6 * force;
    return least->name + (open ? " carries nothing" : " is at the bound of its law");
  }
  const std::function<Equilibrium(double)>& at_;
  std::string why_;
};

}  // namespace

std::vector<RestRange> restRanges(double a, double b, int count,
                                  const std::function<Equilibrium(double)>& at) {
  std::vector<RestRange> out;
  Ends ends(at);
  double before = a;
  bool was = false;
  for (int i = 0; i < count; ++i) {
    const double value = a + (b - a) * i / (count - 1);
    const bool is = ends.rest(value).has_value();
    if (is && !was) {
      RestRange r;
      r.from = i == 0 ? value : ends.end(value, before, r.endsFrom);
      out.push_back(r);
    }
    if (was && !is) out.back().to = ends.end(before, value, out.back().endsTo);
    if (is && i == count - 1) out.back().to = value;
    before = value, was = is;
  }
  return out;
}

}  // namespace dynamy
