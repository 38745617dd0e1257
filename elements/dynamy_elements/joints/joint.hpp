/// Joint: bilateral constraints between two frames, made of the rows of joint_row.hpp; W, χ and the
/// bias are exact, also away from g = 0.
///
/// Rows of different units are different contacts of the element (0 points, 1 angles, 2 friction in
/// the free directions, 3 coupled rows), so that a solver can scale each of them by itself.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <dynamy_elements/joints/joint_row.hpp>
#include <memory>

namespace dynamy {

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

  /// Position errors of all rows, without friction [m, –]. For tests and projections.
  std::vector<double> errors(const Kinematics& k) const;

 protected:
  /// Place and axes of the joint at the start, and the orientations of A and B.
  struct Start {
    Vec3 at_I = Vec3::Zero();
    Vec3 axis_I = Vec3::Zero();  ///< unit axis, zero if the joint has none
    Vec3 plane = Vec3::Zero();   ///< common plane's normal, zero: spatial
    Mat3 A_IA = Mat3::Identity(), A_IB = Mat3::Identity();
  };
  static void declareJoint(Attributes& a);
  static void declareAxis(Attributes& a, const std::string& text);
  static void declareFriction(Attributes& a, const std::string& text);
  /// Adds the rows of the concrete joint.
  virtual void build(const Start& start) = 0;
  /// The motions that the joint leaves free, one after the other; false (default): it has none that
  /// a tree could take as coordinates.
  virtual bool freeMotions(const Start& /*start*/, std::vector<FreeMotion>& /*out*/) const {
    return false;
  }

  void addPoint(const Start& s, const Vec3& direction_I);
  void addAngle(const Start& s, const Vec3& d_I, const Vec3& b_I);
  /// Direction in which friction acts, if the joint has any: along (point) or about (spin) axis_I.
  void freeDirection(const Start& s, JointRow::Kind kind, const Vec3& axis_I);
  void place(const Vec3& pointA, const Vec3& pointB) { pointA_ = pointA, pointB_ = pointB; }
  void addDistance(double length);
  /// Displacement along the axis and angle about it, with advance h per angle [m/rad].
  void addScrew(const Start& s, const Vec3& axis_I, double h);
  /// Signals `name` and `rate` of the displacement of B along d_I, fixed in A, from the start.
  void measureShift(const Start& s, const Vec3& d_I, const std::string& name,
                    const std::string& rate);
  /// Signals `name` and `rate` of the angle about d_I from where e_I is at the start, with e_I
  /// fixed in B. `inB`: d_I is fixed in B and e_I in A, for axes that B carries.
  void measureTurn(const Start& s, const Vec3& d_I, const Vec3& e_I, const std::string& name,
                   const std::string& rate, bool inB = false);
  [[noreturn]] static void refusePlane(const std::string& hint);

 private:
  struct Coordinate {
    JointRow row;
    std::string name, rate;
    bool inB = false;  ///< A and B exchanged, sign reversed
  };
  JointPose pose(const Kinematics& k) const {
    return {k.frame(frames_.A), k.frame(frames_.B), pointA_, pointB_};
  }
  void emit(const JointPose& p, std::uint64_t id, const std::vector<JointRow>& rows,
            const SetValuedForceLaw& law, ContactSink& sink) const;
  void describeCoordinate(const Coordinate& c, Description& d) const;
  FramePair frames_;
  Vec3 at_ = Vec3::Zero(), axis_ = Vec3::Zero();
  bool atGiven_ = false;
  Start start_;
  bool ofTree_ = false;  // the joint belongs to a tree: without points_ and angles_
  Vec3 pointA_ = Vec3::Zero(), pointB_ = Vec3::Zero();
  std::vector<JointRow> points_, angles_, free_, coupled_;
  std::vector<Coordinate> coordinates_;
  Bilateral bilateral_;
  std::unique_ptr<SetValuedForceLaw> friction_;
};

}  // namespace dynamy
