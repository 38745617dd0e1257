/// Separation of a round body from a point for the directions of an arc, and its local maxima.
#pragma once
#include <cmath>
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <numbers>

namespace dynamy {

/// f(θ) = −h_B(−n) − n·o for n = cos θ n_0 + sin θ m + lift: the directions across an edge, across
/// the axis of another body, or across the side of a cone, with o its tip. On a great circle
/// f'' + f ≤ 0 except where n is normal to B's side or along its axis. On other circles f may have
/// several maxima between these places.
struct DiscArc {
  const DiscBody& B;
  Vec3 n0, m;                ///< m ⟂ n_0, of the same length; that is 1 without lift
  Vec3 way;                  ///< from o to the middle of B [m]
  Vec3 lift = Vec3::Zero();  ///< orthogonal to both; |n| = 1

  Vec3 n(double angle) const { return std::cos(angle) * n0 + std::sin(angle) * m + lift; }

  /// Calls take(n, f) for all n inside of 0 … end [rad] where f may be largest.
  template <class Take>
  void tops(double end, Take&& take) const {
    // f is searched piece by piece, between the places where it has a kink.
    const double u = n0.dot(B.a), w = m.dot(B.a);
    double places[6] = {0.0};
    int pieces = 1;
    const auto kinks = [&](double first, double period) {
      for (int turn = -2; turn < 3; ++turn) {
        const double at = first + turn * period;
        if (!(at > 0.0 && at < end && pieces < 5)) continue;
        // In ascending order.
        int k = pieces++;
        for (; k > 1 && places[k - 1] > at; --k) places[k] = places[k - 1];
        places[k] = at;
      }
    };
    const double pi = std::numbers::pi, axis = std::atan2(w, u), most = std::hypot(u, w);
    kinks(axis, pi);
    // −n is normal to the side: n·a = −sin β.
    if (const double side = -B.sine() - lift.dot(B.a); most > std::abs(side)) {
      const double beside = std::acos(side / most);
      kinks(axis + beside, 2.0 * pi), kinks(axis - beside, 2.0 * pi);
    }
    places[pieces] = end;
    const int parts = lift.isZero(0.0) ? 1 : kParts;
    for (int p = 0; p < pieces; ++p) {
      if (p > 0) take(n(places[p]), f(n(places[p])));
      const double l = places[p] + kBeside, r = places[p + 1] - kBeside, width = (r - l) / parts;
      for (int k = 0; k < (l < r ? parts : 0); ++k)
        if (const double at = top(l + k * width, l + (k + 1) * width); at >= 0.0)
          take(n(at), f(n(at)));
    }
  }

 private:
  /// Most steps of a search, which halves the arc at least every second step.
  static constexpr int kSteps = 100;
  /// Parts of a piece that are searched one by one where f may have several maxima.
  static constexpr int kParts = 8;
  /// Distance from the ends of a piece at which slopes are computed [rad].
  static constexpr double kBeside = 1e-9;

  /// Part of h_B(−v) that stems from the height of B's outermost rim along −v; `u` = v·a.
  double up(int rim, double u) const {
    if (B.tip) return (rim == 1 ? -B.half : B.half) * u;
    return B.half * std::abs(u);
  }
  double f(const Vec3& v) const {
    const int rim = B.rimAlong(-v);
    return v.dot(way) - up(rim, v.dot(B.a)) - B.radius(rim) * B.acrossAxis(v).norm() - B.r;
  }
  double slope(double angle) const {
    const Vec3 v = n(angle), w = -std::sin(angle) * n0 + std::cos(angle) * m;
    const double u = v.dot(B.a), du = w.dot(B.a), s = B.acrossAxis(v).norm();
    const int which = B.rimAlong(-v);
    const double rim = s > 0.0 ? B.radius(which) * u * du / s : 0.0;
    const double height = B.tip ? up(which, 1.0) : std::copysign(B.half, u);
    return w.dot(way) - height * du + rim;
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
