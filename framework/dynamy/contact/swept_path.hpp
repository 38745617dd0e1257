/// SweptPath: where every frame was in one attempted step, and what a contact element found along it.
///
///   piece k = 0 … n−1 from pose k to pose k+1:   position linear in time, rate of turn constant
///
/// A scheme sees gaps at one or two instants of a step. A body that goes further in a step than it
/// is thick may be in front of a plate at one of them and behind it at the next; the poses between
/// tell.
#pragma once
#include <dynamy/system/kinematics.hpp>
#include <limits>
#include <span>
#include <vector>

namespace dynamy {

/// A contact that the step went through instead of stopping at it.
struct Passing {
  double t = std::numeric_limits<double>::infinity();  ///< its closing, from the step's begin [s]
  double width = 0.0;  ///< time in which the bodies overlap by no more than matters [s]
  ContactKey contact;
  explicit operator bool() const { return t < std::numeric_limits<double>::infinity(); }
};

struct SweptPose {
  Vec3 r_OS_I = Vec3::Zero();
  Mat3 A_IK = Mat3::Identity();
};

class SweptPath {
 public:
  /// Starts a path through `frames` frames in time dt [s]; gaps below `resolution` [m] are zero.
  void begin(double dt, double resolution, std::size_t frames) {
    dt_ = dt, resolution_ = resolution, frames_ = frames;
    poses_.clear();
  }
  /// The next instant; all are equally far apart.
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
