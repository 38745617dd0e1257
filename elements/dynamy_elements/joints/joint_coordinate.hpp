/// Coordinates of joints: an angle, a displacement or a distance between two frames, with rate and
/// bias, for laws, drives, forces and gears that act in them.
///
///   x = start + g − g(0),   ẋ = Wᵀu + χ,   ẍ = Wᵀu̇ + bias         g: a row of joint_row.hpp
///
/// An angle includes whole turns. The frames determine it up to a multiple of 2π only. The element
/// keeps angle, rate and time of the end of the last step in its memory, and it chooses the
/// multiple nearest to
///
///   x⁻ + (t − t⁻) (ẋ⁻ + ẋ)/2                                                       (theory 40.3)
///
/// Rejected: the multiple nearest to x⁻, which is wrong in steps of more than half a turn.
#pragma once
#include <dynamy/system/description.hpp>
#include <dynamy/system/external_force.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <dynamy_elements/joints/joint_row.hpp>

namespace dynamy {

/// One coordinate between frames known by their handles.
class CoordinateRow {
 public:
  CoordinateRow() = default;
  /// Angle of B relative to A about axis_I since the start. reference_I: direction across the axis
  /// that B carries and whose turn is measured; zero: any.
  static CoordinateRow angle(const StartKinematics& k, FrameHandle A, FrameHandle B,
                             const Vec3& axis_I, const Vec3& reference_I, double start);
  /// Displacement of B's point that is at at_I at the start, along direction_I fixed in A.
  static CoordinateRow displacement(const StartKinematics& k, FrameHandle A, FrameHandle B,
                                    const Vec3& at_I, const Vec3& direction_I, double start);
  /// Distance of a point of A from one of B, in axes of the frames.
  static CoordinateRow distance(FrameHandle A, FrameHandle B, const Vec3& pointA,
                                const Vec3& pointB);

  /// Is the value an angle, which the frames determine up to whole turns only?
  bool turns() const { return row_.kind == JointRow::Kind::turn; }
  double start() const { return start_; }
  /// How many numbers are remembered from step to step.
  int memory() const { return turns() ? kMemory : 0; }
  /// Appends the remembered numbers at the start.
  void startMemory(const StartKinematics& k, std::vector<double>& out) const;
  /// x [m or rad]; `memory` as left by remember(), not read unless x is an angle.
  double value(const Kinematics& k, const double* memory) const;
  void remember(const Kinematics& k, double* memory) const;
  double rate(const Kinematics& k) const;
  double bias(const Kinematics& k) const;
  /// The two parts of factor · ẋ.
  void terms(const Kinematics& k, double factor, RateTerm* two) const;
  /// Force F [N or N m] in the coordinate.
  void addForce(const Kinematics& k, double F, ForceSink& sink) const;
  /// Adds the stiffness of a force F with ∂F/∂x = −c, ∂F/∂ẋ = −d.
  void addStiffness(const Kinematics& k, double c, double d, StiffnessSink& sink) const;
  /// Point at which a force in the coordinate acts on B, in I [m].
  Vec3 place(const Kinematics& k) const;

 private:
  static constexpr int kMemory = 3;  // x, ẋ, t
  JointPose pose(const Kinematics& k) const { return {k.frame(A_), k.frame(B_), pointA_, pointB_}; }
  FrameHandle A_, B_;
  Vec3 pointA_ = Vec3::Zero(), pointB_ = Vec3::Zero();
  JointRow row_;
  double start_ = 0.0;
};

/// The coordinate of an element with attributes `between`, `coordinate`, `at`, `axis`, `reference`,
/// `start`. Where the model does not say whether it is an angle or a displacement, the joint between
/// the two bodies decides (joint_freedom.hpp).
class JointCoordinate {
 public:
  static void declare(Attributes& a);
  explicit JointCoordinate(const Parameters& x);
  /// To be called in the element's constructor for attributes whose unit depends on the kind of
  /// coordinate: connect() refuses other units, and degrees without their unit.
  void hasUnits(const Parameters& x, const char* name, Unit ofAngle, Unit ofDisplacement);
  /// To be called once, in the element's connect(); reserves the memory of `owner`. Throws ModelError
  /// if a joint between the two bodies locks the coordinate.
  void connect(Topology& topology, const Element& owner);
  /// To be called in the element's remember().
  void remember(const Kinematics& k, Vec memory) const { row_.remember(k, memory.data()); }
  double value(const Kinematics& k) const { return row_.value(k, k.memory(memory_).data()); }
  double rate(const Kinematics& k) const { return row_.rate(k); }
  const CoordinateRow& row() const { return row_; }
  /// After connect().
  bool isAngle() const { return angle_; }
  /// True: a force in the coordinate leads nothing out of the plane (Element::isMirrored).
  bool isMirrored(const MirrorPlane& plane, const Element& owner) const;
  /// Signals position and rate.
  void describe(Description& d) const;
  /// One contact of one row with γ = sign ẋ + chi, bias = sign ẍ + chiRate beside Wᵀu̇.
  void emit(const Kinematics& k, ContactRows& out, double sign, double chi, double chiRate) const;

 private:
  struct Mixed {
    Attribute attribute;
    ParameterValue value;
    Unit ofAngle, ofDisplacement;
  };
  void checkUnits();
  FramePair frames_;
  bool kindGiven_, angle_, atGiven_;
  Place place_;               // of `coordinate` or `axis` in the file
  std::vector<Mixed> mixed_;  // values whose unit depends on the kind of coordinate
  Vec3 at_ = Vec3::Zero(), axis_, reference_;
  double start_;
  CoordinateRow row_;
  MemoryHandle memory_;
};

}  // namespace dynamy
