/// Ground: a body at rest or with prescribed motion: a vibrating table, a belt, a driven crank.
///
///   r_OB = position + s(t),   A_IK = A_0 exp(φ(t) a~)
///   ν_S = ṡ,   ν_R = φ̇ a,   β_S = s̈,   β_R = φ̈ a                     no q and u of its own
///
/// The motion enters contacts through χ and the bias; both are exact.
#pragma once
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy/system/tree_part.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>
#include <dynamy_elements/time_formulas.hpp>

namespace dynamy {

class Ground final : public PartialMechanicalSystem, public RigidSystem {
 public:
  static void declare(Attributes& a);
  explicit Ground(const Parameters& x);

  Blocks blocks() const override { return {0, 0, 1, true}; }
  void describe(Description& d) const override;
  void initialState(Vec, Vec) const override {}
  void M(double, ConstVec, MassBlocks) const override {}
  void h(double, ConstVec, ConstVec, Vec) const override {}
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return parts_.frames(); }
  /// Of a ground at rest.
  bool isMirrored(const MirrorPlane& plane) const override;
  /// Only a ground at rest can be part of a tree.
  Abilities abilities() const override {
    return {.rigid = motion_.empty() && rotation_.empty() ? this : nullptr};
  }
  RigidPart rigidPart() const override { return {.fixed = true}; }
  void ownState(const RigidMotion&, Vec, Vec) const override {}

 private:
  BodyParts parts_;
  Vec3 r_OB_I_;
  Mat3 A_IK_;
  TimeFormulas motion_, rotation_;
  Vec3 axis_K_;
};

}  // namespace dynamy
