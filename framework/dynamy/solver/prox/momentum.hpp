/// Momentum: sweeps that start where the last two point to.                        (theory 4.13)
///
///   Λ_{k+1} = g(Λ̃_k),   Λ̃_k = Λ_k + β_k (Λ_k − Λ_{k−1}),   β_k = min(β, (k − 1)/(k + 2))
///
/// [nesterov1983], but for the bound β: friction is no gradient, and with β → 1 sweeps of heaps do
/// not settle. v = M⁻¹WΛ is linear and goes the same way, so that a step costs five operations a
/// number. Where a test finds nothing better than before, β is halved; sweeps that diverge or stall
/// go on without from the best Λ.
#pragma once
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

class Momentum {
 public:
  /// β of the sweeps to come; 0: none.
  void begin(double beta) { beta_ = beta, sweeps_ = 0; }
  /// Between two sweeps: Λ and the velocities of the sweep, out of the last one, in for the next.
  void next(const InclusionProblem& problem, double* Lambda);
  /// A test was not better than the best one before.
  void halve() { beta_ *= 0.5; }
  /// Sweeps go on without; false: they did before.
  bool end() {
    const bool was = beta_ > 0.0;
    beta_ = 0.0;
    return was;
  }

 private:
  double beta_ = 0.0;
  int sweeps_ = 0;
  std::vector<double> Lambda_, v_;  ///< of the sweep before
};

}  // namespace dynamy
