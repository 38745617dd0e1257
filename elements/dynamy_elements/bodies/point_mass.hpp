/// PointMass: a mass without rotation, in space or in a plane.   q = r_OS, u = v,  m v̇ = f
#pragma once
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/position_tangents.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>

namespace dynamy {

class PointMass final : public PartialMechanicalSystem, public PositionTangents {
 public:
  static void declare(Attributes& a);
  explicit PointMass(const Parameters& x);

  Blocks blocks() const override;
  void describe(Description& d) const override;
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const override;
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return parts_.frames(); }
  Abilities abilities() const override { return {.positionTangents = this}; }
  void moveTangent(ConstVec u, double dt, Block T) const override;
  void frameStiffness(double t, ConstVec q, int id, const Vec3& F_I, const Vec3& M_I,
                      Block K) const override;

 private:
  BodyParts parts_;
  std::vector<int> axes_;  ///< coordinates that move
  Vec3 planeNormal_ = Vec3::Zero();
  double m_;
  Vec3 r_OS_I_, v_S_I_;
};

}  // namespace dynamy
