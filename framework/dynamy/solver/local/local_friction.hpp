/// FrictionBlock: one contact with friction in closed form, k = 1 or 2 tangents.      (theory 4.12)
///
///   ξ = DΛ + b,   0 ≤ ξ_N ⊥ Λ_N ≥ 0,   −ξ_T ∈ N(Λ_T) of the disc of radius μΛ_N
///
/// With ξ_N = 0 the normal force is eliminated, Λ_N = (−b_N − D_NT Λ_T)/D_NN:
///   D̂ = D_TT − D_TN D_NT/D_NN,   b̂ = b_T − D_TN b_N/D_NN
/// D need not be symmetric.
#pragma once
#include <cstdint>

namespace dynamy {

enum class LocalCase : std::uint8_t {
  takeOff,     ///< Λ = 0
  stick,       ///< Λ inside C: ξ = 0
  slip,        ///< Λ on the contour
  noSolution,  ///< no solution exists (Painlevé)
  notSimple    ///< C or D admits no closed form
};

struct LocalReport {
  LocalCase found = LocalCase::notSimple;
  int roots = 1;   ///< slip: number of solutions of the slip equation
  double a = 0.0;  ///< slip: ξ_T = −a Λ_T  [1/kg]
};

template <int k>
struct FrictionBlock {
  static constexpr int kMaxSolutions = k == 1 ? 4 : 6;  ///< take-off, stick, slip
  double inverseN = 0.0;                                ///< 1/D_NN
  double toN[k], toT[k];                                ///< D_NT/D_NN, D_TN/D_NN
  double D[k * k];                                      ///< D̂
  double d0 = 0.0, d1 = 0.0;                            ///< det D̂, tr D̂
  double mu = 0.0;
  bool unique = false;  ///< at most one solution for every b
  bool flat = false;    ///< D̂ is singular

  /// D: (k + 1) × (k + 1), row after row. False: D_NN is not positive.
  bool prepare(const double* D, double mu);
  /// Finds the first of the solutions; with `noSolution`, Λ (k + 1 numbers) is unchanged.
  LocalReport solve(const double* b, double* Lambda) const;
  /// Finds all isolated solutions, k + 1 numbers of Λ each, and returns their number. Their order
  /// is take-off, stick, slip by ascending a.
  int solutions(const double* b, LocalReport* reports, double* Lambda) const;
};

extern template struct FrictionBlock<1>;
extern template struct FrictionBlock<2>;

}  // namespace dynamy
