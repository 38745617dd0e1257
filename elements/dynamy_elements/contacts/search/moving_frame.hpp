/// MovingFrame: one frame on one piece of the path of a step, moving straight and turning at a
/// constant rate.
#pragma once
#include <cmath>
#include <dynamy/contact/swept_path.hpp>

namespace dynamy {

inline Vec3 rotationVector(const Mat3& A) {
  const Eigen::AngleAxisd turn(A);
  return turn.angle() * turn.axis();
}

/// One frame on one piece of the path.
struct FramePiece {
  const SweptPose *a, *b;
  Vec3 theta_K;  ///< rotation vector from a to b
  FramePiece(const SweptPath& path, const std::vector<Vec3>& turns, FrameHandle f, int k)
      : a(&path.pose(f, k)),
        b(&path.pose(f, k + 1)),
        theta_K(turns[static_cast<std::size_t>(f.index * path.pieces() + k)]) {}
  Vec3 way() const { return b->r_OS_I - a->r_OS_I; }
};

/// The frame at s ∈ [0, 1] along the piece:
/// A_IK exp(sθ̃) = A_IK + sin(sθ) A_IK k̃ + (1 − cos(sθ)) A_IK k̃².
class MovingFrame {
 public:
  explicit MovingFrame(const FramePiece& piece)
      : from_(piece.a), way_(piece.way()), angle_(piece.theta_K.norm()) {
    if (angle_ == 0.0) return;
    const Vec3 k = piece.theta_K / angle_;
    Mat3 cross;
    cross << 0.0, -k.z(), k.y(), k.z(), 0.0, -k.x(), -k.y(), k.x(), 0.0;
    once_ = from_->A_IK * cross, twice_ = once_ * cross;
  }
  void at(double s, Frame& out) const {
    out.r_OS_I = from_->r_OS_I + s * way_;
    out.A_IK = from_->A_IK;
    if (angle_ > 0.0)
      out.A_IK += std::sin(s * angle_) * once_ + (1.0 - std::cos(s * angle_)) * twice_;
  }

 private:
  const SweptPose* from_;
  Vec3 way_;
  double angle_;
  Mat3 once_, twice_;
};

}  // namespace dynamy
