/// SweptPath: the poses of every frame in one attempted step. Passing: what a contact element found
/// along the path.
///
///   piece k = 0 … n−1 from pose k to pose k+1:   position linear in time, rate of turn constant
///
/// A scheme evaluates gaps at one or two instants of a step. A body that moves further in a step
/// than it is thick may be in front of a plate at one instant and behind it at the next. The poses
/// between these instants show that it passed through.
#pragma once
#include <dynamy/system/kinematics.hpp>
#include <limits>
#include <span>
#include <vector>

namespace dynamy {

/// A contact that the bodies passed through in a step instead of stopping at it.
struct Passing {
  /// Time from the beginning of the step to the closing of the contact [s].
  double t = std::numeric_limits<double>::infinity();
  double width = 0.0;  ///< time in which the overlap of the bodies stays negligible [s]
  ContactKey contact;
  double work = 0.0;  ///< of the search, in evaluations of one velocity
  explicit operator bool() const { return t < std::numeric_limits<double>::infinity(); }
};

struct SweptPose {
  Vec3 r_OS_I = Vec3::Zero();
  Mat3 A_IK = Mat3::Identity();
};

class SweptPath {
 public:
  /// Starts a path of `frames` frames over the time dt [s]. Gaps below `resolution` [m] count as
  /// zero.
  void begin(double dt, double resolution, std::size_t frames) {
    dt_ = dt, resolution_ = resolution, frames_ = frames;
    poses_.clear();
  }
  /// Adds the poses at the next instant. The instants are equally spaced.
  void add(const Kinematics& k) {
    for (std::size_t f = 0; f < frames_; ++f) {
      const Frame& frame = k.frame({static_cast<int>(f)});
      poses_.push_back({frame.r_OS_I, frame.A_IK});
    }
  }
  double dt() const { return dt_; }
  double resolution() const { return resolution_; }
  int pieces() const { return static_cast<int>(poses_.size() / frames_) - 1; }
  const SweptPose& pose(FrameHandle f, int k) const {
    return poses_[static_cast<std::size_t>(k) * frames_ + static_cast<std::size_t>(f.index)];
  }

 private:
  double dt_ = 0.0, resolution_ = 0.0;
  std::size_t frames_ = 1;
  std::vector<SweptPose> poses_;
};

}  // namespace dynamy
