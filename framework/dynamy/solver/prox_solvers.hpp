/// Projected Jacobi and Gauss–Seidel (prox JOR, SOR):
///
///   JOR:  Λ_i ← prox_{C_i}(Λ_i − r_i ξ_i(Λ))           all i from the old Λ
///   SOR:  the same, newest values at once
///
/// The sweeps may be accelerated by Anderson's method, or by momentum, which costs nearly nothing.
/// The status is `stalled` when the best residual has not fallen by 1 % within the last n sweeps; n
/// is half of all sweeps made, but at least 1000.
#pragma once
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <dynamy/solver/prox/anderson.hpp>
#include <dynamy/solver/prox/momentum.hpp>
#include <dynamy/solver/prox/relaxation.hpp>

namespace dynamy {

struct ProxOptions {
  double tolerance = 1e-10;  ///< bound on E_f and E_u
  int maxIterations = 10000;
  Relaxation relaxation = Relaxation::exact;
  double factor = 1.0;     ///< multiplies r
  int anderson = 0;        ///< depth of Anderson's acceleration; 0: none
  bool symmetric = false;  ///< Gauss–Seidel: sweeps run forward and backward, counted as two
  double momentum = 0.0;   ///< fraction of the last change of Λ added before the next sweep
};

class ProxSolver : public InclusionSolver {
 public:
  explicit ProxSolver(const ProxOptions& options) : options_(options) {}
  ProxSolver(const Parameters& x, Relaxation defaultRule);
  static void declareCommon(Attributes& a, const char* defaultRule, double momentum = 0.0);
  static void declareOrder(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) final {
    return solve(problem, options_.tolerance, options_.maxIterations, Lambda);
  }
  /// Solves with the given tolerance and at most `most` sweeps in place of the options' values.
  SolveReport solve(const InclusionProblem& problem, double tolerance, int most, Vec Lambda);
  const ProxOptions& options() const { return options_; }
  /// Makes one sweep over all contacts; r: prox parameters of relaxation(), one per row.
  /// Gauss–Seidel requires begin() of the problem's G before the first sweep.
  virtual void sweep(const InclusionProblem& problem, const double* r, double* Lambda) = 0;

 protected:
  /// Called once per solve, before the first sweep.
  virtual void prepare(const InclusionProblem& /*problem*/) {}

 private:
  /// Makes sweeps until the tolerance is met; Λ becomes the best one that was tested.
  void iterate(const InclusionProblem& problem, double tolerance, int most, Vec Lambda,
               SolveReport& report);
  /// Resets Λ to the best tested one and prepares the next sweep.
  void goBack(const InclusionProblem& problem, Vec Lambda);

  ProxOptions options_;
  Anderson anderson_;
  Momentum momentum_;
  std::vector<double> r_, weights_, scratch_, before_, best_;
};

class ProxGaussSeidel final : public ProxSolver {
 public:
  explicit ProxGaussSeidel(const ProxOptions& options = {}) : ProxSolver(options) {}
  explicit ProxGaussSeidel(const Parameters& x) : ProxSolver(x, Relaxation::exact) {}
  static void declare(Attributes& a);

  void sweep(const InclusionProblem& problem, const double* r, double* Lambda) override;

 private:
  static void contact(const InclusionProblem& problem, int i, const double* r, double* Lambda);
};

class ProxJacobi final : public ProxSolver {
 public:
  explicit ProxJacobi(const ProxOptions& options = {1e-10, 100000, Relaxation::diagonalDominance,
                                                    1.0})
      : ProxSolver(options) {}
  explicit ProxJacobi(const Parameters& x) : ProxSolver(x, Relaxation::diagonalDominance) {}
  static void declare(Attributes& a);

  void sweep(const InclusionProblem& problem, const double* r, double* Lambda) override;

 private:
  std::vector<double> xi_;
};

}  // namespace dynamy
