/// Joint: bilateral constraints between two frames, made of rows of three kinds,
///
///   point     g = d·(r_Q − r_P),      d fixed in A
///   angle     g = d·b,                d fixed in A, b fixed in B, perpendicular at the start
///   distance  g = |r_Q − r_P| − l
///
/// with P on A and Q on B. W, χ and the bias are exact, also away from g = 0:
///
///   point     γ = d·(v_Q − v_P) + (Ω_A × d)·r_PQ
///   angle     γ = (Ω_B − Ω_A)·(b × d)
///   distance  γ = e·(v_Q − v_P)
///
/// Rows of different units are different contacts of the element (0 points, 1 angles, 2 friction in
/// the free direction): a solver then scales each by itself.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/contact/standard_laws.hpp>
#include <dynamy_elements/frame_pair.hpp>
#include <memory>

namespace dynamy {

struct JointRow {
  enum class Kind : std::uint8_t { point, angle, distance, spin } kind = Kind::point;
  Vec3 d_A = Vec3::Zero();  ///< direction in axes of A
  Vec3 b_B = Vec3::Zero();  ///< angle rows: direction in axes of B
  double length = 0.0;      ///< distance rows [m]
};

class Joint : public NonSmoothElement {
 public:
  explicit Joint(const Parameters& x);
  void connect(Topology& topology) final;
  void contacts(const Kinematics& k, ContactSink& sink) const final;
  void describe(Description& d) const override;
  bool jointForces(const Kinematics& k, std::uint64_t id, const double* Lambda,
                   JointForces& out) const final;

  /// Position errors of all rows, without friction [m, –]. For tests and projections.
  std::vector<double> errors(const Kinematics& k) const;

 protected:
  /// Where the joint is at the start and how A and B are turned then.
  struct Start {
    Vec3 at_I = Vec3::Zero();
    Vec3 axis_I = Vec3::Zero();  ///< unit axis, zero if the joint has none
    Vec3 plane = Vec3::Zero();   ///< common plane's normal, zero: spatial
    Mat3 A_IA = Mat3::Identity(), A_IB = Mat3::Identity();
  };
  static void declareJoint(Attributes& a);
  static void declareAxis(Attributes& a, const std::string& text);
  static void declareFriction(Attributes& a);
  /// Adds the rows of the concrete joint.
  virtual void build(const Start& start) = 0;

  void addPoint(const Start& s, const Vec3& direction_I);
  void addAngle(const Start& s, const Vec3& d_I, const Vec3& b_I);
  /// Direction in which friction acts, if the joint has any: along (point) or about (spin) axis_I.
  void freeDirection(const Start& s, JointRow::Kind kind, const Vec3& axis_I);
  void place(const Vec3& pointA, const Vec3& pointB) { pointA_ = pointA, pointB_ = pointB; }
  void addDistance(double length);

 private:
  struct RowValues;
  /// Both frames and the line between the two joint points.
  struct Pose {
    const Frame &A, &B;
    Vec3 rhoA_I, rhoB_I, r_PQ;  ///< lever arms of P and Q, and the line between them
    Pose(const Frame& a, const Frame& b, const Vec3& pointA, const Vec3& pointB)
        : A(a),
          B(b),
          rhoA_I(a.A_IK * pointA),
          rhoB_I(b.A_IK * pointB),
          r_PQ(b.r_OS_I + rhoB_I - a.r_OS_I - rhoA_I) {}
    double error(const JointRow& row) const;
    void line(const JointRow& row, RowValues& out) const;
    double bias(const JointRow& row, const RowValues& v) const;
  };
  void emit(const Pose& p, std::uint64_t id, const std::vector<JointRow>& rows,
            const SetValuedForceLaw& law, ContactSink& sink) const;
  FramePair frames_;
  Vec3 at_ = Vec3::Zero(), axis_ = Vec3::Zero();
  bool atGiven_ = false;
  Vec3 pointA_ = Vec3::Zero(), pointB_ = Vec3::Zero();
  std::vector<JointRow> points_, angles_, free_;
  Bilateral bilateral_;
  std::unique_ptr<SetValuedForceLaw> friction_;
};

}  // namespace dynamy
