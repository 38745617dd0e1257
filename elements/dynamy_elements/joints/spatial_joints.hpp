/// Joints of bodies in space with more than one degree of freedom, or with coupled ones.
///
///                rows                          free
///   Universal    3 points, 1 angle             alpha about the axis of A, beta about that of B
///   Cylindrical  2 points, 2 angles            displacement and angle of one axis
///   Screw        2 points, 2 angles, 1 screw   the angle; displacement = pitch angle/2π
///   PlanarJoint  1 point, 2 angles             x, y in a plane of A, the angle about its normal
#pragma once
#include <dynamy_elements/joints/joint.hpp>

namespace dynamy {

class Universal final : public Joint {
 public:
  static void declare(Attributes& a);
  explicit Universal(const Parameters& x);

 private:
  void build(JointRows& rows) const override;
  bool freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const override;
  Vec3 axisB_;
};

class Cylindrical final : public Joint {
 public:
  using Joint::Joint;
  static void declare(Attributes& a);

 private:
  void build(JointRows& rows) const override;
  bool freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const override;
};

class Screw final : public Joint {
 public:
  static void declare(Attributes& a);
  explicit Screw(const Parameters& x);

 private:
  void build(JointRows& rows) const override;
  bool freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const override;
  double pitch_;
};

class PlanarJoint final : public Joint {
 public:
  using Joint::Joint;
  static void declare(Attributes& a);

 private:
  void build(JointRows& rows) const override;
  bool freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const override;
};

}  // namespace dynamy
