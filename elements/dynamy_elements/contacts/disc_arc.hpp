/// How far a round body is from a point along the directions of an arc, and where it is furthest.
#pragma once
#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/disc_body.hpp>
#include <numbers>

namespace dynamy {

/// f(θ) = −h_B(−n) − n·o on n = cos θ n_0 + sin θ m: the directions across an edge, or across the
/// axis of another body. f'' + f ≤ 0 but where n is across B's axis or along it.
struct DiscArc {
  const DiscBody& B;
  Vec3 n0, m;  ///< unit, m ⟂ n_0
  Vec3 way;    ///< from o to the middle of B [m]

  Vec3 n(double angle) const { return std::cos(angle) * n0 + std::sin(angle) * m; }

  /// Calls take(n, f) for all n where f may be largest inside of 0 … end [rad].
  template <class Take>
  void tops(double end, Take&& take) const {
    // Between the places where f has a kink.
    const double u = n0.dot(B.a), w = m.dot(B.a);
    double places[6] = {0.0};
    int pieces = 1;
    for (const double kink : {std::atan2(-u, w), std::atan2(w, u)})
      for (int turn = -1; turn < 3; ++turn) {
        const double at = kink + turn * std::numbers::pi;
        if (at > 0.0 && at < end && pieces < 5) places[pieces++] = at;
      }
    std::sort(places, places + pieces);
    places[pieces] = end;
    for (int p = 0; p < pieces; ++p) {
      if (p > 0) take(n(places[p]), f(n(places[p])));
      const double l = places[p] + kBeside, r = places[p + 1] - kBeside;
      if (const double at = l < r ? top(l, r) : -1.0; at >= 0.0) take(n(at), f(n(at)));
    }
  }

 private:
  /// Steps of a search: it halves the arc at least every second time.
  static constexpr int kSteps = 100;
  /// Beside the ends of a piece slopes are taken [rad].
  static constexpr double kBeside = 1e-9;

  double f(const Vec3& v) const {
    return v.dot(way) - B.half * std::abs(v.dot(B.a)) - B.rho * B.acrossAxis(v).norm() - B.r;
  }
  double slope(double angle) const {
    const Vec3 v = n(angle), w = -std::sin(angle) * n0 + std::cos(angle) * m;
    const double u = v.dot(B.a), du = w.dot(B.a), s = B.acrossAxis(v).norm();
    const double rim = s > 0.0 ? B.rho * u * du / s : 0.0;
    return w.dot(way) - std::copysign(B.half, u) * du + rim;
  }
  /// Where the slope falls through zero between l and r; −1: nowhere.
  double top(double l, double r) const {
    double sl = slope(l), sr = slope(r);
    if (!(sl > 0.0 && sr < 0.0)) return -1.0;
    for (int i = 0; i < kSteps && r - l > 1e-14; ++i) {
      // False position and halving in turn.
      const double at = i % 2 == 0 ? l + (r - l) * sl / (sl - sr) : 0.5 * (l + r);
      const double s = slope(at);
      if (s == 0.0) return at;
      (s > 0.0 ? l : r) = at, (s > 0.0 ? sl : sr) = s;
    }
    return 0.5 * (l + r);
  }
};

}  // namespace dynamy
