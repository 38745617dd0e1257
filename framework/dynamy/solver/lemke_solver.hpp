/// Lemke as a solver of inclusion problems: the problem becomes a linear complementarity problem
/// (LcpForm), and pivoting finds a solution in finitely many steps.                  (theory 8)
///
/// Exact for joints, contacts without friction, force limits and planar friction. Friction discs
/// become polygons: the bound is at most μN (1 − cos(π/facets)) too small, and the direction of the
/// friction up to π/facets wrong. The residuals are those of the discs. Therefore a problem with
/// discs is normally not `solved` by pivoting alone; by default proximal Newton steps go on from
/// there. The tableau is dense and is allocated as problems grow; this is no solver for real time.
#pragma once
#include <dynamy/solver/lcp/lcp_form.hpp>
#include <dynamy/solver/lcp/lemke.hpp>
#include <dynamy/solver/proximal_newton.hpp>
#include <string>

namespace dynamy {

struct LemkeOptions {
  double tolerance = 1e-10;  ///< of E_f and E_u
  int maxPivots = 10000;
  int facets = 8;      ///< of a friction disc, even
  bool polish = true;  ///< proximal Newton steps where pivoting does not reach the tolerance
};

class LemkeSolver final : public InclusionSolver {
 public:
  explicit LemkeSolver(const LemkeOptions& options = {});
  explicit LemkeSolver(const Parameters& x);
  static void declare(Attributes& a);
  /// `iterations` counts pivots. `stalled`: a ray, or the polygons' solution without polish.
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;
  /// True: some contact has G_ii = 0, which sweeps and Newton steps cannot start from, there are no
  /// bodies (then such a contact feels nothing), and the problem is small.
  static bool pays(const InclusionProblem& problem);
  /// What pivoting said at the last solve.
  LcpOutcome outcome() const { return outcome_; }
  /// The last problem was proven to have no solution.
  bool proven() const { return outcome_ == LcpOutcome::infeasible && form_.exact(); }

 private:
  LemkeOptions options_;
  std::string_view faceted_, polished_;  ///< kept for good: reports outlive solvers
  LcpForm form_;
  Lemke lemke_;
  LcpOutcome outcome_ = LcpOutcome::solved;
  ProximalNewton newton_;
  Eigen::VectorXd z_;
  std::vector<double> scratch_, best_;
};

}  // namespace dynamy
