#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/joints/joint_rows.hpp>

namespace dynamy {

void JointRows::begin(const JointStart& s, bool friction, const Vec3& onA, const Vec3& onB) {
  start = s, friction_ = friction, pointA = onA, pointB = onB;
  dropBilateral();
  free.clear(), signals.clear();
}

void JointRows::dropBilateral() { points.clear(), angles.clear(), coupled.clear(); }

bool JointRows::empty() const {
  return points.empty() && angles.empty() && coupled.empty() && free.empty();
}

void JointRows::addPoint(const Vec3& direction_I) {
  points.push_back(
      {JointRow::Kind::point, start.A_IA.transpose() * direction_I, Vec3::Zero(), 0.0});
}

void JointRows::addAngle(const Vec3& d_I, const Vec3& b_I) {
  angles.push_back(
      {JointRow::Kind::angle, start.A_IA.transpose() * d_I, start.A_IB.transpose() * b_I, 0.0});
}

void JointRows::addFree(JointRow::Kind kind, const Vec3& axis_I) {
  if (friction_) free.push_back({kind, start.A_IA.transpose() * axis_I, Vec3::Zero(), 0.0});
}

void JointRows::addDistance(const Vec3& onA, const Vec3& onB, double length) {
  pointA = onA, pointB = onB;
  points.push_back({JointRow::Kind::distance, Vec3::Zero(), Vec3::Zero(), length});
}

void JointRows::addScrew(const Vec3& axis_I, double h) {
  Vec3 e, unused;
  tangents(axis_I, e, unused);
  coupled.push_back({JointRow::Kind::screw, start.A_IA.transpose() * axis_I,
                     start.A_IB.transpose() * e, h, start.A_IA.transpose() * e});
}

void JointRows::measureShift(const Vec3& d_I, const std::string& name, const std::string& rate) {
  signals.push_back(
      {{JointRow::Kind::point, start.A_IA.transpose() * d_I, Vec3::Zero(), 0.0}, name, rate});
}

void JointRows::measureTurn(const Vec3& d_I, const Vec3& e_I, const std::string& name,
                            const std::string& rate, bool inB) {
  const Mat3 &axes = inB ? start.A_IB : start.A_IA, &other = inB ? start.A_IA : start.A_IB;
  signals.push_back({{JointRow::Kind::turn, axes.transpose() * d_I, other.transpose() * e_I, 0.0,
                      axes.transpose() * e_I},
                     name,
                     rate,
                     inB});
}

}  // namespace dynamy
