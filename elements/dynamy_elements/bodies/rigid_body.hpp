/// RigidBody: free rigid body in space.
///
///   q = (r_OS, p),  u = (v_S_I, Ω_K)           S centre of mass, p unit quaternion (w, x, y, z)
///   m v̇ = f,   J Ω̇ + Ω × J Ω = M_K             M = diag(m I, J) is constant
///   ṙ = v,  ṗ = ½ p ∘ (0, Ω);   move: p ← p ∘ exp(½ Δt Ω)
///
/// Ω in body axes keeps M constant; world components were rejected because M would turn with the
/// body.
#pragma once
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/position_tangents.hpp>
#include <dynamy_elements/bodies/carried_body.hpp>

namespace dynamy {

class RigidBody final : public PartialMechanicalSystem, public PositionTangents {
 public:
  static void declare(Attributes& a);
  explicit RigidBody(const Parameters& x);

  Blocks blocks() const override { return {7, 6, 1, true}; }
  void describe(Description& d) const override;
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  /// J(Ω_free − Ω^A) = Δt (M_K − Ω̄ × JΩ̄), Ω̄ = ½(Ω^A + Ω_free): this conserves the energy and
  /// |JΩ| of a free body. Steps that turn by more than a radian are divided into parts.
  void gyroscopicAtMean(double t, ConstVec q, ConstVec uA, double dt, Vec h) const override;
  void qdot(double t, ConstVec q, ConstVec u, Vec qdot) const override;
  void move(double t, Vec q, ConstVec u, double dt) const override;
  void normalise(Vec q) const override;
  /// The gyroscopic term: D = (J Ω)~ − Ω~ J, K = 0.
  bool dh(double t, ConstVec q, ConstVec u, int block, Block K, Block D) const override;
  void moveTangent(ConstVec u, double dt, Block T) const override;
  void frameStiffness(double t, ConstVec q, int id, const Vec3& F_I, const Vec3& M_I,
                      Block K) const override;
  double gravity(double t, ConstVec q, const Vec3& g_I, Vec h) const override;
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return parts_.frames(); }
  bool isMirrored(const MirrorPlane& plane) const override;
  Abilities abilities() const override { return {.positionTangents = this, .rigid = &carried_}; }

 private:
  BodyParts parts_;
  BodyMass mass_;
  Vec3 r_OB_I_, v_S_I_, Omega_K_;
  std::array<double, 4> p_;
  CarriedBody carried_;
};

}  // namespace dynamy
