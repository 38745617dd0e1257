/// Packed Gauss–Seidel: sweeps over eight contacts at a time, with bounded momentum.  (theory 4.14)
///
///   N⁺ = max(0, Ñ − ξ_N/G_NN),   ξ_T += G_TN (N⁺ − Ñ),   T⁺ = P_{|T| ≤ μN⁺}(T̃ − ξ_T/λ_max(G_TT))
///   Λ̃ = Λ_k + β_k (Λ_k − Λ_{k−1}),   β_k = min(β, (k − 1)/(k + 2)),   k ← 1 where Λ̃ led uphill
///
/// Friction takes a scalar step, because the inverse of G_TT and a radial projection have another
/// fixed point. Contacts with other laws or bodies are solved exactly, one after the other
/// (PackedContacts). The solver is meant for many contacts at engineering accuracy; the residuals
/// report the accuracy reached.
#pragma once
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <dynamy/solver/local/packed_contacts.hpp>

namespace dynamy {

struct PackedOptions {
  double tolerance = 1e-2;    ///< bound on E_f and E_u
  int maxIterations = 10000;  ///< sweeps
  double momentum = 0.9;      ///< bound β; 0: no momentum
};

class PackedGaussSeidel final : public InclusionSolver {
 public:
  explicit PackedGaussSeidel(const PackedOptions& options = {});
  explicit PackedGaussSeidel(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;
  /// Makes at most `most` sweeps from Λ, whose residuals are in `report`, until `tolerance` is met.
  /// Λ becomes the best one that was tested; true: solved. Problems without bodies or with a
  /// measure of their own cannot be packed; their contacts are solved one by one.
  bool sweeps(const InclusionProblem& problem, double tolerance, int most, Vec Lambda,
              SolveReport& report);

 private:
  /// The sweeps of problems that cannot be packed.
  bool plainSweeps(const InclusionProblem& problem, double tolerance, int most, Vec Lambda,
                   SolveReport& report);
  /// Λ ← 0 if zero forces have a smaller residual than a poor start.
  void chooseStart(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// The larger of E_f and E_u, computed from the packed contacts.
  double tested(const InclusionProblem& problem);

  PackedOptions options_;
  PackedContacts packed_;
  BlockGaussSeidel plain_;  ///< for problems that cannot be packed
  std::vector<double> scratch_, best_;
};

}  // namespace dynamy
