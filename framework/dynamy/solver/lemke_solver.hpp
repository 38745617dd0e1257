/// Lemke as a solver of inclusion problems: the problem becomes a linear complementarity problem
/// (LcpForm), and pivoting finds a solution in finitely many steps.                  (theory 8)
///
/// Pivoting is exact for joints, contacts without friction, force limits and planar friction.
/// Friction discs become polygons: the bound is at most μN (1 − cos(π/facets)) too small, and the
/// direction of the friction is wrong by up to π/facets. The residuals are those of the discs.
/// Therefore pivoting alone normally does not solve a problem with discs; by default proximal
/// Newton steps continue from its forces. The tableau is dense and is allocated as problems grow,
/// so that this is no solver for real time.
#pragma once
#include <dynamy/solver/lcp/lcp_form.hpp>
#include <dynamy/solver/lcp/lemke.hpp>
#include <dynamy/solver/proximal_newton.hpp>
#include <string>

namespace dynamy {

struct LemkeOptions {
  double tolerance = 1e-10;  ///< bound on E_f and E_u
  int maxPivots = 10000;
  int facets = 8;      ///< vertices of the polygon in a friction disc, even
  bool polish = true;  ///< proximal Newton steps where pivoting does not reach the tolerance
};

class LemkeSolver final : public InclusionSolver {
 public:
  explicit LemkeSolver(const LemkeOptions& options = {});
  explicit LemkeSolver(const Parameters& x);
  static void declare(Attributes& a);
  /// `iterations` of the report counts pivots. Status `stalled`: pivoting ended in a ray, or it
  /// solved the problem with polygons and no polish followed.
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;
  /// True if the problem is small, has no bodies, and some contact has G_ii = 0: sweeps and Newton
  /// steps cannot start from such a contact. (With bodies, G_ii = 0 means that no force moves the
  /// contact.)
  static bool pays(const InclusionProblem& problem);
  /// Outcome of pivoting in the last solve.
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
