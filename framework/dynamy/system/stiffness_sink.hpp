/// StiffnessSink: where elements put the derivatives of their forces, for schemes that take them
/// implicitly: of those that declare themselves stiff, and of those a step does not resolve,
///
///   ∂h/∂q F = −Σ c w wᵀ,   ∂h/∂u = −Σ d w wᵀ,
///
/// as directions w with a stiffness c and a damping d, or entry by entry. A direction is what a
/// spring has; entries serve forces given by formulas. Rejected: whole matrices of every element,
/// which would be large and almost empty.
#pragma once
#include <dynamy/system/frame.hpp>
#include <dynamy/system/topology.hpp>

namespace dynamy {

/// One entry of ∂h/∂q F (K) and of ∂h/∂u (D): rows i, columns j of u.
struct StiffEntry {
  int i = 0, j = 0;
  double K = 0.0, D = 0.0;
};

class StiffnessSink {
 public:
  explicit StiffnessSink(std::vector<StiffEntry>& entries) : entries_(entries) {}
  /// Spring and damper between the points at lever arms rhoA_I, rhoB_I of A and B along the unit
  /// vector e: stiffness c [N/m], damping d [N s/m].
  void spring(const Frame& A, const Vec3& rhoA_I, const Frame& B, const Vec3& rhoB_I, const Vec3& e,
              double c, double d);
  /// The same about the unit axis a: c [N m/rad], d [N m s/rad].
  void torsion(const Frame& A, const Frame& B, const Vec3& a, double c, double d);
  /// ∂h_i/∂u_j += D,  (∂h/∂q F)_ij += K of one system; i, j count its velocities.
  void entry(const SystemHandle& system, int i, int j, double K, double D) {
    entries_.push_back({system.u0 + i, system.u0 + j, K, D});
  }

 private:
  struct Side {
    const Frame& frame;
    Vec3 force, moment;  // of a unit force on this side
  };
  void add(const Side& a, const Side& b, double c, double d);
  std::vector<StiffEntry>& entries_;
};

}  // namespace dynamy
