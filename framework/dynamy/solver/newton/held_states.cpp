#include <algorithm>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/newton/contact_compliance.hpp>
#include <dynamy/solver/newton/held_states.hpp>
#include <limits>

namespace dynamy {
namespace {

/// a in units of λ_i. A substitution leaves about a/κ of the residual, with κ = λ_min/λ_max of G.
constexpr double kShift = 1e-9;
constexpr int kSubstitutions = 4;
/// If a substitution leaves more than this fraction of the residual, some contact changes its
/// state.
constexpr double kGain = 0.1;

}  // namespace

bool HeldStates::states(const InclusionProblem& p, const double* xi, ConstVec Lambda) {
  a_.resize(static_cast<std::size_t>(p.size()));
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i), first = p.row0(i);
    const double lambda = contactLambda(p.G->diagonalBlock(i), dim);
    double A[kMostRows * kMostRows], B[kMostRows * kMostRows];
    if (!(lambda > 0.0) ||
        !p.law(i).proxDerivative(p.input(i), 1.0 / lambda, xi + first, Lambda.data() + first, A, B))
      return false;
    double& a = a_[static_cast<std::size_t>(i)];
    if (sticks(A, B, dim)) {
      a = kShift * lambda;
    } else if (std::all_of(B, B + dim * dim, [](double b) { return b == 0.0; }) &&
               Lambda.segment(first, dim).isZero(0.0)) {
      a = std::numeric_limits<double>::infinity();
    } else {
      return false;
    }
  }
  return true;
}

bool HeldStates::solve(const InclusionProblem& p, const double* xi, double tolerance, Vec Lambda,
                       SolveReport& report) {
  if (!states(p, xi, view(Lambda))) return false;
  NewtonSystem* const system = systems_.prepare(p);
  if (!system || !systems_.inVelocities() || !system->factorShifted(p, a_)) return false;
  const int rows = p.rows(), before = report.iterations;
  right_.resize(static_cast<std::size_t>(rows)), dLambda_.resize(right_.size());
  trial_ = Lambda;
  double last = report.residuals.largest();
  for (int k = 0; k < kSubstitutions; ++k) {
    for (int r = 0; r < rows; ++r) right_[static_cast<std::size_t>(r)] = -xi[r];
    if (!system->solveShifted(p, right_.data(), dLambda_)) break;
    for (int r = 0; r < rows; ++r) trial_[r] += dLambda_[static_cast<std::size_t>(r)];
    ++report.newton, ++report.iterations;
    const Residuals now = residuals(p, view(std::as_const(trial_)), scratch_);
    if (now.largest() < report.residuals.largest()) report.residuals = now, Lambda = trial_;
    if (now.largest() <= tolerance || !(now.largest() <= kGain * last)) break;
    last = now.largest(), xi = scratch_.data();
  }
  report.method = "held states";
  report.note(report.method, before);
  return report.residuals.largest() <= tolerance;
}

}  // namespace dynamy
