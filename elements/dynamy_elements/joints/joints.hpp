/// The joints: which rows each has, in space and between planar bodies.
///
///               space                        plane with normal n
///   Revolute    3 points, 2 angles           2 points
///   Spherical   3 points                     2 points
///   Prismatic   2 points, 3 angles           1 point, 1 angle
///   Fixed       3 points, 3 angles           2 points, 1 angle
///   Distance    1 distance                   1 distance
#pragma once
#include <dynamy_elements/joints/joint.hpp>

namespace dynamy {

class Revolute final : public Joint {
 public:
  using Joint::Joint;
  static void declare(Attributes& a);

 private:
  void build(JointRows& rows) const override;
  bool freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const override;
};

class Spherical final : public Joint {
 public:
  using Joint::Joint;
  static void declare(Attributes& a);

 private:
  void build(JointRows& rows) const override;
  bool freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const override;
};

class Prismatic final : public Joint {
 public:
  using Joint::Joint;
  static void declare(Attributes& a);

 private:
  void build(JointRows& rows) const override;
  bool freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const override;
};

class Fixed final : public Joint {
 public:
  using Joint::Joint;
  static void declare(Attributes& a);

 private:
  void build(JointRows& rows) const override;
  bool freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const override;
};

class Distance final : public Joint {
 public:
  static void declare(Attributes& a);
  explicit Distance(const Parameters& x);

 private:
  void build(JointRows& rows) const override;
  Vec3 pointOnA_, pointOnB_;
  double length_;
};

}  // namespace dynamy
