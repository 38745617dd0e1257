/// Generalised Newton method for the inclusion, without a proximal term.             (theory 9)
///
///   F(Λ) = 0,   ξ = GΛ + c,   (A + B G) ΔΛ = −F,   Λ ← Λ + t ΔΛ
///   alartCurnier:      F_i = Λ_i − prox_{C_i}(Λ_i − R_i ξ_i) [alart_curnier1991]
///   fischerBurmeister: F_i = φ(x_i, y_i) of the cone, in De Saxcé's form; contacts of other laws
///                      keep the first form [fukushima_luo_tseng2001]
///
/// This is the method of the literature, for comparison and for problems with regular G. Redundant
/// contacts that stick make A + BG singular: the solver then returns `stalled` and does not
/// continue with sweeps. ProximalNewton solves such problems as well.
#pragma once
#include <dynamy/solver/newton/fischer_burmeister.hpp>
#include <dynamy/solver/newton/newton_system.hpp>
#include <dynamy/solver/prox_solvers.hpp>

namespace dynamy {

struct SemismoothOptions {
  enum class Formulation { alartCurnier, fischerBurmeister };
  enum class LineSearch { armijo, nonmonotone, none };
  double tolerance = 1e-10;  ///< bound on E_f and E_u
  int maxNewton = 200;
  int sweeps = 10;  ///< sweeps of Gauss–Seidel before the first step of a cold start
  Formulation formulation = Formulation::alartCurnier;
  LineSearch lineSearch = LineSearch::nonmonotone;
};

class SemismoothNewton final : public InclusionSolver {
 public:
  explicit SemismoothNewton(const SemismoothOptions& options = {});
  explicit SemismoothNewton(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;

 private:
  using Formulation = SemismoothOptions::Formulation;
  using LineSearch = SemismoothOptions::LineSearch;
  bool prepare(const InclusionProblem& p);
  /// Computes F and, if `derivative`, A and B at (Λ, ξ). Returns Σ λ_i|F_i|²; negative: no
  /// derivative.
  double map(const InclusionProblem& p, const double* Lambda, const double* xi, double* F,
             bool derivative);
  /// Solves for ΔΛ; false: the matrix is singular.
  bool step(const InclusionProblem& p);
  bool denseStep(const InclusionProblem& p);
  /// Steps along ΔΛ. False: no step length that was tried makes |F|² small enough; the best one is
  /// taken.
  bool advance(const InclusionProblem& p, double reference);
  SolveStatus iterate(const InclusionProblem& p, SolveReport& report);

  SemismoothOptions options_;
  ProxGaussSeidel starter_;
  std::unique_ptr<NewtonSystem> system_;
  int systemDim_ = 0;
  NewtonBlocks blocks_;
  std::vector<LawCone> cone_;
  std::vector<double> lambda_, r_, Lambda_, xi_, dLambda_, dXi_, trialLambda_, trialXi_, trialF_,
      best_, scratch_, G_, J_;
};

}  // namespace dynamy
