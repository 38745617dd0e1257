/// Two frames given by name, as for springs and joints, and the kinematics of frames at the start.
#pragma once
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/kinematics.hpp>
#include <string>

namespace dynamy {

/// Kinematics at the initial state and t = 0, of all frames requested so far, or of `frames` alone: a
/// thousand joints that each looked at all frames took the cube of their number in time.
class StartKinematics {
 public:
  explicit StartKinematics(const Topology& topology);
  StartKinematics(const Topology& topology, const std::vector<FrameHandle>& frames);
  const Frame& frame(FrameHandle f) const { return kinematics_.frame(f); }
  const Kinematics& kinematics() const { return kinematics_; }

 private:
  void place(const Topology& topology);
  Eigen::VectorXd q_, u_;
  Kinematics kinematics_;
};

/// Attribute `between="a b"`: frames A and B.
class FramePair {
 public:
  static void declare(Attributes& a);
  /// Throws ModelError unless there are two names.
  explicit FramePair(const Parameters& x);
  void connect(Topology& topology, const Element& asking);
  /// Finds A and B, which may be on one body or both stand still; planeNormal stays zero.
  void find(Topology& topology, const Element& asking);
  /// For elements that do nothing of their own: notes the systems of A and B, finds no frames.
  void belong(Topology& topology, const Element& asking) const;

  FrameHandle A, B;
  /// Normal of the plane in which both systems move; zero if one moves in space or the planes
  /// differ. A system without velocities (ground) is in every plane.
  Vec3 planeNormal = Vec3::Zero();

 private:
  std::string a_, b_;
};

/// Throws ModelError if the frame belongs to a system without velocities, on which a force has no
/// effect. `name`: of the frame, as the model writes it.
void requireMoving(const Topology& topology, FrameHandle frame, const std::string& name);

/// Blocks of the system that carries a requested frame.
Blocks blocksOf(const Topology& topology, FrameHandle frame);

/// Normal of the plane in which two systems move; zero if there is none.
Vec3 commonPlane(const Blocks& a, const Blocks& b);

}  // namespace dynamy
