/// PathBoxes: where the shapes of an island are during a step, part by part (theory 50.12).
///
/// The path of a shape's middle in a part of the step is taken for the cubic with its places and
/// velocities at the ends: it stays within the hull of the four points of Bézier. The box holds this
/// hull, enlarged, and the ball about the middle that holds the shape.
#pragma once
#include <Eigen/Geometry>
#include <dynamy/system/kinematics.hpp>
#include <dynamy/system/shape.hpp>
#include <span>
#include <vector>

namespace dynamy {

/// A shape that may touch others, by the ball that holds it.
struct MovingShape {
  FrameHandle frame;
  int system = -1;            ///< index of the system that carries it
  Vec3 arm_K = Vec3::Zero();  ///< its middle, from the origin of the frame [m]
  double bound = 0.0;         ///< radius of the ball [m]
};

class PathBoxes {
 public:
  using Box = Eigen::AlignedBox3d;
  /// A path of these shapes (borrowed) begins with the kinematics k.
  void begin(std::span<const MovingShape> shapes, const Kinematics& k);
  /// The next place of the path, which ends a part.
  void pass(const Kinematics& k);
  /// What shapes do in `dt` [s] with their velocities in k: ways over their bounds, or turns [rad].
  static double stretch(std::span<const MovingShape> shapes, const Kinematics& k, double dt);
  /// A path of `h` [s] from k with constant velocities.
  void expect(std::span<const MovingShape> shapes, const Kinematics& k, double h);
  /// No path: nothing meets it.
  void clear() { times_.clear(), all_.setEmpty(); }
  /// First time from `from` on [s] at which a box of one path meets a box of the other; ∞: never.
  double meets(const PathBoxes& other, double from) const;
  /// True: at any time.
  bool meets(const PathBoxes& other) const;

 private:
  struct Place {
    Vec3 r, v;     // of the middle of a shape [m], [m/s]
    double Omega;  // of its frame [rad/s]
  };
  static Place at(const MovingShape& shape, const Kinematics& k);
  void add(std::size_t shape, const Place& a, const Place& b, double dt, double arm);
  std::size_t parts() const { return times_.empty() ? 0 : times_.size() - 1; }
  bool partsMeet(std::size_t k, const PathBoxes& other, std::size_t l) const;
  std::span<const MovingShape> shapes_;
  std::vector<double> times_;  // ends of parts [s]
  std::vector<Place> last_;    // per shape
  std::vector<Box> boxes_;     // shape by shape within a part
  std::vector<Box> whole_;     // per part
  Box all_;
};

}  // namespace dynamy
