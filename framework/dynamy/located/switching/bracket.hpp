/// Refinement of a bracket, at whose ends a monitor is positive and negative, to its root.
#pragma once
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace dynamy {

/// Part of the step at whose ends a monitor is positive and negative.
struct Bracket {
  double a, fa, b, fb;
  static constexpr int kMostRefinements = 160;
  /// Of the fall over a bracket: a larger value is no root, even if it seems close to one by the
  /// last slope, which may be that over a jump.
  static constexpr double kSmallValue = 1e-2;

  /// Shrinks the bracket to `width`, or until a value is within ±zero. `value(t, v)` computes the
  /// monitor, and returns false where that is impossible; then so does this. `slope`: per step.
  template <class Value>
  bool refine(double width, double zero, Value&& value, double& root, double& slope) {
    // [alefeld_potra_shi1995]: both ends converge, with the final order 1.65 per evaluation.
    if (!(fa > 0.0 && fb < 0.0)) {  // one end is zero up to rounding
      slope = (fb - fa) / (b - a);
      root = fa > 0.0 ? b : a;
      return true;
    }
    bool known = true;
    double last = a, fLast = fa;
    slope = (fb - fa) / (b - a);
    const double small = kSmallValue * (fa - fb);
    const auto f = [&](double t) {
      double v = 0.0;
      known = known && value(t, v);
      if (t != last && v != fLast) slope = (v - fLast) / (t - last);
      last = t, fLast = v;
      const double near = std::max(zero, 0.5 * width * std::abs(slope));
      if (!known || std::abs(v) <= std::min(near, small)) {
        a = b = slope < 0.0 ? t - v / slope : t, fa = fb = 0.0;
        return 0.0;  // close enough, though one end of the bracket may be far away
      }
      (v > 0.0 ? a : b) = t, (v > 0.0 ? fa : fb) = v;
      return v;
    };
    const auto near = [&](double l, double r) { return r - l <= width; };
    std::uintmax_t most = kMostRefinements;
    if (!near(a, b))
      boost::math::tools::toms748_solve(f, double(a), double(b), double(fa), double(fb), near,
                                        most);
    root = b > a ? (a * fb - b * fa) / (fb - fa) : a;
    return known;
  }
};

}  // namespace dynamy
