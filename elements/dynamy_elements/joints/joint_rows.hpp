/// JointRows: the rows of a joint and its signals, built from directions in the world at the start.
#pragma once
#include <dynamy_elements/joints/joint_row.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// Place and axes of a joint at the start, and the orientations of A and B.
struct JointStart {
  Vec3 at_I = Vec3::Zero();
  Vec3 axis_I = Vec3::Zero();  ///< unit axis, zero if the joint has none
  Vec3 plane = Vec3::Zero();   ///< common plane's normal, zero: spatial
  Mat3 A_IA = Mat3::Identity(), A_IB = Mat3::Identity();
};

/// A displacement or an angle of B against A, with its rate, as signals.
struct JointSignal {
  JointRow row;
  std::string name, rate;
  bool inB = false;  ///< A and B exchanged, sign reversed
};

class JointRows {
 public:
  /// Begins anew, with the same point of A and B. False `friction`: free directions do not count.
  void begin(const JointStart& start, bool friction, const Vec3& pointA, const Vec3& pointB);
  /// Drops all rows but those of friction.
  void dropBilateral();
  /// True: there are no rows of contacts.
  bool empty() const;

  void addPoint(const Vec3& direction_I);
  void addAngle(const Vec3& d_I, const Vec3& b_I);
  /// Direction in which friction acts, if the joint has any: along (point) or about (spin) axis_I.
  void addFree(JointRow::Kind kind, const Vec3& axis_I);
  /// Distance of a point on A and one on B, in their axes [m]; 0: that of the start.
  void addDistance(const Vec3& onA, const Vec3& onB, double length);
  /// Displacement along the axis and angle about it, with advance h per angle [m/rad].
  void addScrew(const Vec3& axis_I, double h);
  /// Signals `name` and `rate` of the displacement of B along d_I, fixed in A, from the start.
  void measureShift(const Vec3& d_I, const std::string& name, const std::string& rate);
  /// Signals `name` and `rate` of the angle about d_I from where e_I is at the start, with e_I
  /// fixed in B. `inB`: d_I is fixed in B and e_I in A, for axes that B carries.
  void measureTurn(const Vec3& d_I, const Vec3& e_I, const std::string& name,
                   const std::string& rate, bool inB = false);

  JointStart start;
  Vec3 pointA = Vec3::Zero(), pointB = Vec3::Zero();  ///< P on A, Q on B, in their axes
  std::vector<JointRow> points, angles, free, coupled;
  std::vector<JointSignal> signals;

 private:
  bool friction_ = false;
};

}  // namespace dynamy
