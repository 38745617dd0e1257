/// FirstBelow: the first place at which a gap along a path falls below a limit (theory 37.2).
///
///   |g(s) − g(r)| ≤ L |s − r|        nothing is below in [a, b] if ½ (g(a) + g(b) − L (b − a)) is not
///   g convex on every part           golden sections; secants through three of its points bound g
///                                    from below, and most searches end with the first of them
///
/// [a, b] is halved while the first bound does not decide, down to one part. Searching the parts of
/// the path one after the other was rejected, since nearly all of them are far from anything: for a
/// body that spins among thirty others these were 60 of 64 evaluations.
#pragma once
#include <algorithm>

namespace dynamy {

struct FirstBelow {
  double limit = 0.0;
  double L = 0.0;     ///< Lipschitz constant of g
  double part = 1.0;  ///< length of a part on which g is convex
  double flat = 0.0;  ///< a minimum is narrowed down to this length

  /// `at`: place where g is below the limit, −1: none. `from`, `value`: begin of the part that
  /// contains this place, and g at that begin.
  struct Place {
    double at = -1.0, from = 0.0, value = 0.0;
    explicit operator bool() const { return at >= 0.0; }
  };

  /// The first place in [a, b], which is 2^k parts long; ga, gb: g at a and b.
  template <class Gap>
  Place in(Gap& gap, double a, double ga, double b, double gb) const {
    if (0.5 * (ga + gb - L * (b - a)) >= limit) return {};
    if (b - a <= 1.5 * part) {
      const double at = gb < limit ? b : lowest(gap, a, ga, b, gb);
      return {at, a, ga};
    }
    const double m = 0.5 * (a + b), gm = gap(m);
    const Place before = in(gap, a, ga, m, gm);
    return before ? before : in(gap, m, gm, b, gb);
  }

 private:
  static constexpr double kGolden = 0.6180339887498949;

  /// Lower bound of a convex g on [a, b] from its values at a < c < d < b: outside of two points g
  /// lies above the line through them.
  static double secants(double a, double ga, double c, double gc, double d, double gd, double b,
                        double gb) {
    const double middle = (gd - gc) / (d - c), left = (gc - ga) / (c - a),
                 right = (gb - gd) / (b - d);
    const double atA = gc - std::max(0.0, middle) * (c - a),
                 atB = gd + std::min(0.0, middle) * (b - d);
    // Between c and d, g lies above both lines that come from outside;
    // these are lowest where they meet.
    double inside = std::min(gc, gd);
    if (left < 0.0 && right > 0.0) {
      const double meet = (gc - gd + right * (d - c)) / (right - left);
      inside = gc + left * std::clamp(meet, 0.0, d - c);
    }
    return std::min({atA, atB, inside});
  }

  /// A place in (a, b) where the convex g is below the limit; −1: nowhere.
  template <class Gap>
  double lowest(Gap& gap, double a, double ga, double b, double gb) const {
    double c = b - kGolden * (b - a), d = a + kGolden * (b - a), gc = gap(c), gd = gap(d);
    while (b - a > flat) {
      if (!(c > a && d < b && c < d)) break;  // limit of rounding, for a path of 1e16 thicknesses
      if (gc < limit) return c;
      if (gd < limit) return d;
      if (secants(a, ga, c, gc, d, gd, b, gb) >= limit) return -1.0;
      if (gc < gd) {
        b = d, gb = gd, d = c, gd = gc, c = b - kGolden * (b - a), gc = gap(c);
      } else {
        a = c, ga = gc, c = d, gc = gd, d = a + kGolden * (b - a), gd = gap(d);
      }
    }
    return -1.0;
  }
};

}  // namespace dynamy
