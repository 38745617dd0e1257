/// CarriedBody: a rigid body in space as joints of a tree carry it: its mass, and its own
/// coordinates q = (r_OS, p), u = (v_S_I, Ω_K) from its motion since the start.
#pragma once
#include <array>
#include <dynamy/system/tree_part.hpp>
#include <dynamy_elements/bodies/body_parts.hpp>

namespace dynamy {

class CarriedBody final : public RigidSystem {
 public:
  /// `p`: unit quaternion of the body's axes at the start.
  CarriedBody(const BodyMass& mass, const std::array<double, 4>& p)
      : part_{false, mass.m, mass.r_BS_K, mass.J_S_K}, p_(p) {}
  RigidPart rigidPart() const override { return part_; }
  void ownState(const RigidMotion& motion, Vec q, Vec u) const override;

 private:
  RigidPart part_;
  std::array<double, 4> p_;
};

}  // namespace dynamy
