/// Separation of a round body from a point for the directions of an arc, and its local maxima.
#pragma once
#include <algorithm>
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

  /// Calls take(n, f) for all n inside of 0 … end [rad] where f may be largest and above `least`.
  template <class Take>
  void tops(double end, double least, Take&& take) const {
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
    for (int p = 0; p < pieces; ++p) {
      if (p > 0) take(n(places[p]), f(n(places[p])));
      const double l = places[p] + kBeside, r = places[p + 1] - kBeside;
      const int parts =
          lift.isZero(0.0) ? std::max(1, static_cast<int>(std::ceil((r - l) / kLongest))) : kParts;
      const double width = (r - l) / parts;
      if (!(l < r)) continue;
      Place from = place(l);
      for (int k = 1; k <= parts; ++k) {
        const Place to = place(l + k * width);
        topsIn(from, to, least, kHalvings, [&](double at) { take(n(at), f(n(at))); });
        from = to;
      }
    }
  }
  /// Calls take(n) for a top near this angle [rad], if there is one.
  template <class Take>
  void topNear(double angle, Take&& take) const {
    for (double w = kNear; w < kFar; w *= 4.0) {
      const double l = angle - w, r = angle + w, sl = slope(l), sr = slope(r);
      if (sl > 0.0 && sr < 0.0) return take(n(top(l, sl, r, sr)));
    }
  }

 private:
  /// Half width of the first arc around an angle that topNear() looks at, and of the last one [rad].
  static constexpr double kNear = 0.01, kFar = 1.0;
  /// Most steps of a search, which halves the arc at least every second step.
  static constexpr int kSteps = 100;
  /// Parts of a piece that are searched one by one where f may have several maxima.
  static constexpr int kParts = 8;
  /// Longest part of a piece of a great circle [rad], and how often it is halved in search of a
  /// hidden top. f'' + f ≤ 0 allows a minimum behind a maximum of f < 0; of f ≥ 0 it is π/2 away.
  static constexpr double kLongest = std::numbers::pi / 4.0;
  static constexpr int kHalvings = 4;
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
  struct Place {
    double at, f, slope;
  };
  Place place(double angle) const { return {angle, f(n(angle)), slope(angle)}; }
  /// Bound of f on the way w from a place with this f and slope: it solves f'' + f = 0.
  static double atMost(double f, double slope, double w) {
    const double peak = std::atan2(slope, f);
    return peak > 0.0 && peak < w ? std::hypot(f, slope)
                                  : std::max(f, f * std::cos(w) + slope * std::sin(w));
  }
  /// Calls found(θ) for the tops between two places. With slopes of other signs a top may hide beside
  /// a minimum: f'' ≤ −f, so that a slope needs the way s / max(−f) from zero. f lies above the
  /// solution of f'' + f = 0 through both ends.
  template <class Found>
  void topsIn(const Place& l, const Place& r, double least, int halvings,
              const Found& found) const {
    if (l.slope > 0.0 && r.slope < 0.0) return found(top(l.at, l.slope, r.at, r.slope));
    const double w = r.at - l.at, deepest = -std::min(l.f, r.f) / std::cos(0.5 * w);
    if (halvings == 0 || std::max(-l.slope, 0.0) + std::max(r.slope, 0.0) >= deepest * w ||
        std::min(atMost(l.f, l.slope, w), atMost(r.f, -r.slope, w)) <= least)
      return;
    const Place mid = place(l.at + 0.5 * w);
    topsIn(l, mid, least, halvings - 1, found), topsIn(mid, r, least, halvings - 1, found);
  }
  /// Where the slope falls through zero between l and r, with slopes sl > 0 > sr.
  double top(double l, double sl, double r, double sr) const {
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
