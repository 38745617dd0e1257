/// StiffnessSink: receives the derivatives of forces, for schemes that integrate forces implicitly.
/// It serves forces that are declared stiff, and forces that a step does not resolve. Derivatives
///
///   ∂h/∂q F = −Σ c w wᵀ,   ∂h/∂u = −Σ d w wᵀ,
///
/// are given by directions w with a stiffness c and a damping d, or entry by entry. Springs have
/// directions; entries serve forces given by formulas. Rejected: whole matrices of every element,
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
  /// Torsion spring and damper between A and B about the unit axis a: c [N m/rad], d [N m s/rad].
  void torsion(const Frame& A, const Frame& B, const Vec3& a, double c, double d);
  /// ∂h_i/∂u_j += D,  (∂h/∂q F)_ij += K of one system; i, j count its velocities.
  void entry(const SystemHandle& system, int i, int j, double K, double D) {
    entries_.push_back({system.u0 + i, system.u0 + j, K, D});
  }

 private:
  struct Side {
    const Frame& frame;
    Vec3 force, moment;  // on this frame, for a unit force of the spring
  };
  void add(const Side& a, const Side& b, double c, double d);
  std::vector<StiffEntry>& entries_;
};

}  // namespace dynamy
