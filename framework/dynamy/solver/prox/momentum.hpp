/// Momentum: each sweep starts from an extrapolation of the last two.              (theory 4.13)
///
///   Λ_{k+1} = g(Λ̃_k),   Λ̃_k = Λ_k + β_k (Λ_k − Λ_{k−1}),   β_k = min(β, (k − 1)/(k + 2))
///
/// This is Nesterov's method [nesterov1983] except for the bound β: friction is no gradient, and
/// with β → 1 the sweeps of heaps do not settle. v = M⁻¹WΛ is linear in Λ and is extrapolated
/// likewise, so that a step costs five operations per number. If a test finds nothing better than
/// before, β is halved. Sweeps that diverge or stall continue without momentum from the best Λ.
#pragma once
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

class Momentum {
 public:
  /// Sets β for the following sweeps; 0: no momentum.
  void begin(double beta) { beta_ = beta, sweeps_ = 0; }
  /// Call between two sweeps: extrapolates Λ and the velocities of the sweep for the next one.
  void next(const InclusionProblem& problem, double* Lambda);
  /// Halves β after a test that was not better than the best one before.
  void halve() { beta_ *= 0.5; }
  /// Ends the momentum; false: it was off before.
  bool end() {
    const bool was = beta_ > 0.0;
    beta_ = 0.0;
    return was;
  }

 private:
  double beta_ = 0.0;
  int sweeps_ = 0;
  std::vector<double> Lambda_, v_;  ///< values after the previous sweep
};

}  // namespace dynamy
