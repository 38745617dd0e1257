/// Packed Gauss–Seidel: sweeps over eight contacts at a time, with bounded momentum.  (theory 4.14)
///
///   N⁺ = max(0, Ñ − ξ_N/G_NN),   ξ_T += G_TN (N⁺ − Ñ),   T⁺ = P_{|T| ≤ μN⁺}(T̃ − ξ_T/λ_max(G_TT))
///   Λ̃ = Λ_k + β_k (Λ_k − Λ_{k−1}),   β_k = min(β, (k − 1)/(k + 2)),   k ← 1 where Λ̃ led uphill
///
/// Friction steps by a scalar: the inverse of G_TT and a radial clip have another fixed point.
/// Contacts of other laws or bodies are solved exactly in turn (PackedContacts). For many contacts
/// at engineering accuracy; what it reaches is told by its residuals like any other result.
#pragma once
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <dynamy/solver/local/packed_contacts.hpp>

namespace dynamy {

struct PackedOptions {
  double tolerance = 1e-2;    ///< of E_f and E_u
  int maxIterations = 10000;  ///< sweeps
  double momentum = 0.9;      ///< β; 0: none
};

class PackedGaussSeidel final : public InclusionSolver {
 public:
  explicit PackedGaussSeidel(const PackedOptions& options = {});
  explicit PackedGaussSeidel(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;
  /// At most `most` sweeps from Λ, whose residuals are in `report`, until `tolerance` is met. Λ is
  /// the best one that was tested; true: solved. Where nothing can be packed, in problems without
  /// bodies or with a measure of their own, contacts are solved one by one.
  bool sweeps(const InclusionProblem& problem, double tolerance, int most, Vec Lambda,
              SolveReport& report);

 private:
  /// The sweeps of problems that cannot be packed.
  bool plainSweeps(const InclusionProblem& problem, double tolerance, int most, Vec Lambda,
                   SolveReport& report);
  /// Λ ← 0 where that is nearer than the start.
  void chooseStart(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// The larger of E_f and E_u by the packed contacts.
  double tested(const InclusionProblem& problem);

  PackedOptions options_;
  PackedContacts packed_;
  BlockGaussSeidel plain_;  ///< of what cannot be packed
  std::vector<double> scratch_, best_;
};

}  // namespace dynamy
