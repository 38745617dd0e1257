/// What bodies and joints report, so that a mechanism can become a tree of joints in minimal
/// coordinates (theory 39). All values are those at the start, in axes of the world.
#pragma once
#include <array>
#include <dynamy/core/types.hpp>
#include <vector>

namespace dynamy {

/// A rigid body that joints can carry.
struct RigidPart {
  bool fixed = false;             ///< stands still for good: a root of trees; no mass is needed
  double m = 0.0;                 ///< mass [kg]
  Vec3 r_BS_K = Vec3::Zero();     ///< centre of mass from the origin of frame 0 [m]
  Mat3 J_S_K = Mat3::Identity();  ///< inertia about the centre of mass, axes of frame 0 [kg m²]
};

/// How a rigid body has moved since the start.
struct RigidMotion {
  Vec3 r_OS_I = Vec3::Zero();  ///< its centre of mass [m]
  std::array<double, 4> p{1.0, 0.0, 0.0,
                          0.0};  ///< unit quaternion of its rotation since the start, in the world
  double angle = 0.0;            ///< in a plane: angle of rotation, counted over turns [rad]
  Vec3 v_S_I = Vec3::Zero();     ///< [m/s]
  Vec3 Omega_I = Vec3::Zero();   ///< [rad/s]
};

/// A system that is one rigid body, or stands still, so that joints of a tree can carry it. All
/// frames of the system are fixed on the body.
class RigidSystem {
 public:
  /// The data that a tree of joints needs.
  virtual RigidPart rigidPart() const = 0;
  /// q and u of the system alone, all entries, from its motion since the start; for its signals.
  virtual void ownState(const RigidMotion& motion, Vec q, Vec u) const = 0;

 protected:
  ~RigidSystem() = default;
};

/// One simple motion that a joint leaves free.
struct FreeMotion {
  enum class Kind : std::uint8_t {
    turn,   ///< about an axis: angle [rad]
    slide,  ///< along an axis: displacement [m]
    screw,  ///< both: angle [rad], displacement = pitch · angle
    ball    ///< about a point: quaternion, angular velocity in axes of the turned side
  } kind = Kind::turn;
  Vec3 axis_I = Vec3::UnitZ();  ///< unit vector at the start; of no meaning for a ball
  double pitch = 0.0;           ///< screw: displacement per radian [m]
  double rotor = 0.0;           ///< turn, slide: inertia of the coordinate alone [kg m² or kg]
};

/// Motion of B relative to A that a joint leaves free: simple motions one after the other, all at
/// one point.
struct JointMotion {
  int systemA = -1, systemB = -1;  ///< indices of the systems it connects
  Vec3 at_I = Vec3::Zero();        ///< the point [m]
  std::vector<FreeMotion> free;    ///< empty: A and B are rigidly connected
};

}  // namespace dynamy
