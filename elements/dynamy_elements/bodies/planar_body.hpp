/// PlanarBody: rigid body that moves in a plane e1, e2 with n = e1 × e2.
///
///   q = (c1, c2, φ),  u = (v1, v2, ω):   r_OS = c1 e1 + c2 e2 + const,  Ω = ω n,  A_IK = exp(φ n~)
///   m c̈ = f,  J φ̈ = M_n                  M = diag(m, m, J) is constant
///
/// At φ = 0 the body axes are x, y, z. A spatial body with constraints was rejected: it has six
/// velocities instead of three, and as many constraints as the plane has fewer motions.
#pragma once
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/position_tangents.hpp>
#include <dynamy/system/tree_part.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>

namespace dynamy {

class PlanarBody final : public PartialMechanicalSystem,
                         public PositionTangents,
                         public RigidSystem {
 public:
  static void declare(Attributes& a);
  explicit PlanarBody(const Parameters& x);

  Blocks blocks() const override { return {3, 3, 1, true, plane_.n}; }
  void describe(Description& d) const override;
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const override;
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return parts_.frames(); }
  Abilities abilities() const override { return {.positionTangents = this, .rigid = this}; }
  RigidPart rigidPart() const override;
  void ownState(const RigidMotion& motion, Vec q, Vec u) const override;
  void moveTangent(ConstVec u, double dt, Block T) const override;
  void frameStiffness(double t, ConstVec q, int id, const Vec3& F_I, const Vec3& M_I,
                      Block K) const override;

 private:
  Mat3 axes(double phi) const;
  Plane plane_;
  BodyParts parts_;
  double m_, J_;
  Vec3 r_BS_K_, r_OB_I_, v_S_I_;
  double phi_, omega_;
};

}  // namespace dynamy
