/// BodyCarrier: a system that carries bodies in other coordinates than their own. Elements that read
/// the coordinates of one body go on to do so (theory 39.7):
///
///   u_own = J(q) u,   u̇_own = J u̇ + β
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

class PartialMechanicalSystem;

class BodyCarrier {
 public:
  virtual int carriedBodies() const = 0;
  /// Body `i` as it would be alone: its name, the names and number of its coordinates. Its own q
  /// and u are not those of a run.
  virtual const PartialMechanicalSystem& carriedBody(int i) const = 0;
  /// Own q and u of body `i`, all entries, at the q and u of the carrier.
  virtual void ownState(int i, ConstVec q, ConstVec u, Vec qOwn, Vec uOwn) const = 0;
  /// J (nu of the body × nu of the carrier) and β (nu of the body), all entries.
  virtual void ownVelocities(int i, ConstVec q, ConstVec u, Block J, Vec bias) const = 0;

 protected:
  ~BodyCarrier() = default;
};

}  // namespace dynamy
