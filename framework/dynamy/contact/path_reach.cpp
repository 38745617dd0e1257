#include <algorithm>
#include <dynamy/contact/path_reach.hpp>

namespace dynamy {
namespace {

/// Factors on what is predicted, and on a path that is known at some places.
constexpr double kAhead = 1.5, kBetween = 1.2;
/// Part of the longest way in one direction that is allowed for in the other two.
constexpr double kAside = 0.1;

}  // namespace

template <class F>
void PathReach::each(const Kinematics& k, F&& f) {
  for (std::size_t i = 0; i < ways_.size(); ++i)
    if (const Frame& frame = k.frames()[i]; !frame.absent) f(ways_[i], frame);
}

void PathReach::expect(const Kinematics& start, const Kinematics& later, double time,
                       double margin) {
  begin(start, margin);
  each(later, [&](Way& w, const Frame& f) {
    const Vec3 end = 0.5 * time * (w.v + f.v_S_I);
    w.low = end.cwiseMin(0.0), w.high = end.cwiseMax(0.0);
    for (int k = 0; k < 3; ++k) {
      // r = v t + a t²/2 with a = (v' − v)/T turns back where v = −a t.
      if (!(w.v[k] * f.v_S_I[k] < 0.0)) continue;
      const double turn = 0.5 * time * w.v[k] * w.v[k] / (w.v[k] - f.v_S_I[k]);
      w.low[k] = std::min(w.low[k], turn), w.high[k] = std::max(w.high[k], turn);
    }
    const double aside = kAside * std::max(-w.low.minCoeff(), w.high.maxCoeff());
    w.low = kAhead * w.low - Vec3::Constant(aside),
    w.high = kAhead * w.high + Vec3::Constant(aside);
    w.angle = kAhead * time * std::max(w.Omega, f.Omega_I.norm());
  });
}

void PathReach::begin(const Kinematics& k, double margin) {
  time_ = 0.0, margin_ = margin;
  ways_.assign(k.frames().size(), {});
  own_ = k.numbers();
  each(k, [](Way& w, const Frame& f) {
    w.start = f.r_OS_I, w.v = f.v_S_I, w.Omega = f.Omega_I.norm();
  });
}

/// A cubic with these places and velocities at its ends stays within the hull of the four points of
/// Bézier.
void PathReach::pass(const Kinematics& k, double dt) {
  time_ += dt;
  each(k, [&](Way& w, const Frame& f) {
    const Vec3 r = f.r_OS_I - w.start, near = w.r + dt / 3.0 * w.v, far = r - dt / 3.0 * f.v_S_I;
    w.low = w.low.cwiseMin(near).cwiseMin(far).cwiseMin(r);
    w.high = w.high.cwiseMax(near).cwiseMax(far).cwiseMax(r);
    w.r = r, w.v = f.v_S_I, w.Omega = std::max(w.Omega, f.Omega_I.norm());
  });
}

void PathReach::finish() {
  for (Way& w : ways_) {
    w.low *= kBetween, w.high *= kBetween;
    w.angle = kBetween * time_ * w.Omega;
  }
}

bool PathReach::within(const PathReach& other) const {
  return std::equal(ways_.begin(), ways_.end(), other.ways_.begin(), other.ways_.end(),
                    [](const Way& a, const Way& b) {
                      return (a.low.array() >= b.low.array()).all() &&
                             (a.high.array() <= b.high.array()).all() && a.angle <= b.angle;
                    });
}

}  // namespace dynamy
