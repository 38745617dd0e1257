/// OwnInverse: a system of one block that applies the inverse of its mass matrix itself,
///
///   out = M(q, t)⁻¹ in
///
/// for systems with many velocities, such as trees of joints, where this costs O(n) instead of
/// O(n²). M is then computed only on request.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

class OwnInverse {
 public:
  /// out = M⁻¹ in, nu numbers each.
  virtual void applyInverseMass(double t, ConstVec q, ConstVec in, Vec out) const = 0;

 protected:
  ~OwnInverse() = default;
};

}  // namespace dynamy
