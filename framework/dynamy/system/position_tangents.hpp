/// PositionTangents: derivatives in closed form for Newton's method on positions, of a system of
/// one block with constant mass. For systems that do not offer them, differences are taken.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

class PositionTangents {
 public:
  /// T of PartialMechanicalSystem::move(), nu × nu, all entries:
  /// q ⊕ Δt (u + δ) = (q ⊕ Δt u) ⊕ Δt T δ to first order. T is the unit matrix if q̇ = u.
  virtual void moveTangent(ConstVec u, double dt, Block T) const = 0;
  /// K = ∂(J_Sᵀ F + J_Rᵀ M)/∂q F of frame `id`, nu × nu, all entries, with F_I [N] and M_I [N m]
  /// held in I.
  virtual void frameStiffness(double t, ConstVec q, int id, const Vec3& F_I, const Vec3& M_I,
                              Block K) const = 0;

 protected:
  ~PositionTangents() = default;
};

}  // namespace dynamy
