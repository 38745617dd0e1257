/// PathReach: where the frames may get to on a path (theory 50.3).
///
/// Each frame has a box, in I, that holds its origin all the way, and a bound of its turning. A box
/// and not a ball: bodies that fly past each other at a distance leave most directions free.
#pragma once
#include <Eigen/Geometry>
#include <dynamy/system/kinematics.hpp>
#include <vector>

namespace dynamy {

class PathReach {
 public:
  using Box = Eigen::AlignedBox3d;
  /// A path of `time` [s] that is not known yet, with constant accelerations: from the places and
  /// velocities `start` to the velocities `later`. `margin`: added on all sides [m].
  void expect(const Kinematics& start, const Kinematics& later, double time, double margin);
  /// A path that is known at some of its places: the first one.
  void begin(const Kinematics& k, double margin);
  /// The next place, `dt` [s] later. To be called before finish().
  void pass(const Kinematics& k, double dt);
  /// After the last place: allows for what the path does between its places.
  void finish();
  /// True: nothing gets further than in `other`, which has the same start.
  bool within(const PathReach& other) const;

  // Of frames f that are not absent:
  /// Bound of the way of a point at the distance `arm` [m] from the origin of frame f [m].
  double way(FrameHandle f, double arm) const {
    const Way& w = of(f);
    return margin_ + w.low.cwiseMin(-w.high).norm() + turned(w, arm);
  }
  /// Box of the places [m] of a point that starts at r, with the lever arm `arm` [m] about the
  /// origin of frame f.
  Box places(FrameHandle f, const Vec3& r, double arm) const {
    const Way& w = of(f);
    const Vec3 beyond = Vec3::Constant(margin_ + turned(w, arm));
    return {r + w.low - beyond, r + w.high + beyond};
  }

 private:
  /// The way of a frame. Bounds of the displacement of its origin since the start [m].
  struct Way {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    double angle = 0.0;            // most that it turns [rad]
    Vec3 start = Vec3::Zero();     // where the path began [m],
    Vec3 r = Vec3::Zero(), v = r;  // displacement [m] and velocity [m/s] at the last place
    double Omega = 0.0;            // largest of all places [rad/s]
  };
  const Way& of(FrameHandle f) const {
    return ways_[static_cast<std::size_t>(own_ != nullptr ? own_->of(f) : f.index)];
  }
  static double turned(const Way& w, double arm) {
    return w.angle > 0.0 ? std::min(w.angle, 2.0) * arm : 0.0;
  }
  template <class F>
  void each(const Kinematics& k, F&& f);
  std::vector<Way> ways_;            // as Kinematics::frames(),
  const OwnNumbers* own_ = nullptr;  // and their numbers()
  double time_ = 0.0, margin_ = 0.0;
};

}  // namespace dynamy
