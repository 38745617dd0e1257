/// DampedForces: forces that a step with JointEquations does not resolve (UnresolvedForces). They are
/// extrapolated from the beginning of the step to its end, as in StaggeredMoreau, which keeps R
/// linear:
///
///   Δt h(q^M, v)  →  Δt (h^A + Δt K (2v − u^A/2)) + 2Δt D (v − u^A)
///
/// Δt (2v − u^A/2) leads from q^A to q^A ⊕ Δt/2 u^A ⊕ Δt u^E: an oscillation with ωΔt → ∞ is at
/// rest after two steps. Rejected: these forces at q^M with their derivatives in K alone. The
/// implicit midpoint rule reverses fast oscillations in every step and damps nothing, and Newton's
/// iteration diverges where a spring is long.
#pragma once
#include <algorithm>
#include <dynamy/stages/mechanical_system.hpp>
#include <utility>

namespace dynamy {

class DampedForces {
 public:
  /// At q^A: evaluates slot 0 ahead without unresolved forces, and finds these forces. True: they
  /// couple other mass blocks than in the step before.
  bool begin(MechanicalSystem& s, const State& x, double dt);
  bool any() const { return !forces_.entries().empty(); }
  /// By index: 1 for a force that evaluations leave out of h meanwhile. Empty: there is none.
  std::span<const char> withheld() const { return withheld_; }
  /// Pairs of mass blocks that these forces couple, in both orders, sorted.
  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  /// Adds h of these forces as this step uses them, with v and u^A, which an impact may have
  /// changed since begin(). `nonPotential`: the part of dampers. Both have nu numbers.
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
  const Evaluation& without(MechanicalSystem& s, const State& x) const;
  void couple();
  double dt_ = 0.0;
  UnresolvedForces forces_;
  std::vector<char> withheld_;
  Eigen::VectorXd h_, nonPotential_, uBegin_;
  std::vector<std::pair<int, int>> pairs_, found_;
};

}  // namespace dynamy
