/// DampedForces: forces that a step of JointNewton does not resolve (UnresolvedForces), taken at its
/// end from what they are at its beginning, as StaggeredMoreau does, so that R stays linear in them:
///
///   Δt h(q^M, v)  →  Δt (h^A + Δt K (2v − u^A/2)) + 2Δt D (v − u^A)
///
/// 2v − u^A/2 leads from q^A to Δt u^E behind q^A ⊕ Δt/2 u^A: an oscillation with ωΔt → ∞ is at rest
/// after two steps. Rejected: these forces at q^M with their derivatives in K alone. The implicit
/// midpoint rule turns fast oscillations round in every step and damps nothing, and Newton's
/// iteration goes astray where a spring is long.
#pragma once
#include <algorithm>
#include <dynamy/stages/mechanical_system.hpp>
#include <utility>

namespace dynamy {

class DampedForces {
 public:
  /// At q^A: evaluates slot 0 ahead without these forces, and finds them. True: they couple other
  /// mass blocks than in the step before.
  bool begin(MechanicalSystem& s, const State& x, double dt);
  bool any() const { return !forces_.entries().empty(); }
  /// Mass blocks that they couple, both ways, sorted.
  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  /// h of these forces as this step uses them, of the velocity v and with u^A, which an impact may
  /// have changed since; `nonPotential`: the part of dampers. nu numbers each, added.
  void addTo(const Eigen::VectorXd& v, const Eigen::VectorXd& uA, Eigen::VectorXd& h,
             Eigen::VectorXd& nonPotential) const;
  /// Calls add(a, i, b, j, value) for −Δt ∂h/∂v: row i of block a, column j of block b.
  template <class Add>
  void forEach(const MassMatrix& mass, Add&& add) const {
    for (const StiffEntry& e : forces_.entries()) {
      const int a = forces_.block(e.i), b = forces_.block(e.j);
      add(a, e.i - mass.u0(a), b, e.j - mass.u0(b), -2.0 * dt_ * (dt_ * e.K + e.D));
    }
  }

 private:
  void couple();
  double dt_ = 0.0;
  UnresolvedForces forces_;
  std::vector<char> withheld_;
  Eigen::VectorXd h_, nonPotential_, uBegin_;
  std::vector<std::pair<int, int>> pairs_, found_;
};

}  // namespace dynamy
