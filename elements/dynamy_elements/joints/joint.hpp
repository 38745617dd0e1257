/// Joint: bilateral constraints between two frames, made of the rows of joint_row.hpp; W, χ and the
/// bias are exact, also away from g = 0.
///
/// Rows of different units are different contacts of the element (0 points, 1 angles, 2 friction in
/// the free directions, 3 coupled rows), so that a solver can scale each of them by itself.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <dynamy_elements/joints/joint_rows.hpp>
#include <memory>

namespace dynamy {

/// Throws the ModelError of joints that bodies in one plane cannot have.
[[noreturn]] void refusePlane(const std::string& hint);

class Joint : public NonSmoothElement {
 public:
  explicit Joint(const Parameters& x);
  void connect(Topology& topology) final;
  void contacts(const Kinematics& k, ContactSink& sink) const final;
  void describe(Description& d) const override;
  bool jointForces(const Kinematics& k, std::uint64_t id, const double* Lambda,
                   JointForces& out) const final;
  bool jointMotion(Topology& topology, JointMotion& out) final;
  void becomeCoordinate() final;
  /// True: all free motions turn about the normal or slide along the plane.
  bool keepsPlane(const MirrorPlane& plane) final;

  /// Position errors of all rows, without friction [m, –]. For tests and projections.
  std::vector<double> errors(const Kinematics& k) const;

 protected:
  static void declareJoint(Attributes& a);
  static void declareAxis(Attributes& a, const std::string& text);
  static void declareFriction(Attributes& a, const std::string& text);
  /// Attribute `start`, for joints of one free motion.
  static void declareStart(Attributes& a, Unit unit, const std::string& text);
  /// Attribute `rotor`, for joints whose one free motion it belongs to.
  static void declareRotor(Attributes& a, Unit unit);
  /// Adds the rows of the concrete joint.
  virtual void build(JointRows& rows) const = 0;
  /// The motions that the joint leaves free, one after the other; false (default): it has none that
  /// a tree could take as coordinates.
  virtual bool freeMotions(const JointStart& /*start*/, std::vector<FreeMotion>& /*out*/) const {
    return false;
  }

 private:
  JointPose pose(const Kinematics& k) const {
    return {k.frame(frames_.A), k.frame(frames_.B), rows_.pointA, rows_.pointB};
  }
  /// Requests the frames and builds the rows.
  void bind(Topology& topology);
  void emit(const JointPose& p, std::uint64_t id, const std::vector<JointRow>& rows,
            const SetValuedForceLaw& law, ContactSink& sink) const;
  void describeSignal(const JointSignal& c, Description& d) const;
  FramePair frames_;
  Vec3 at_ = Vec3::Zero(), axis_ = Vec3::Zero();
  bool atGiven_ = false;
  double start_ = 0.0;   // value of the free motion at the start [rad or m]
  double rotor_ = 0.0;   // inertia of the coordinate alone [kg m² or kg]
  bool ofTree_ = false;  // the joint belongs to a tree: without bilateral rows
  JointRows rows_;
  Bilateral bilateral_;
  std::unique_ptr<SetValuedForceLaw> friction_;
};

}  // namespace dynamy
