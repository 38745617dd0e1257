#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/easy_problems.hpp>
#include <dynamy/solver/local/local_iteration.hpp>

namespace dynamy {
namespace {

constexpr int kAndersonDepth = 5;  ///< depth of Anderson's acceleration
constexpr int kFirstSweeps =
    20;  ///< sweeps before the rate is judged: acceleration takes some to build up
constexpr int kSweepsPerTest = 5;
/// Plain prox sweeps before Newton's method. On the collection, 10 to 40 sweeps differ by chance;
/// 15 was the best of five values.
constexpr int kPlainSweeps = 15;
/// Sweeps that cost as much as a Newton solve; if more are needed, sweeps end.
constexpr double kSweepPatience = 300.0;

}  // namespace

bool EasyProblems::oneContact(const InclusionProblem& p, double tolerance, Vec Lambda,
                              SolveReport& report) {
  const int dim = p.dim(0);
  double start[kMostRows];
  std::copy(Lambda.data(), Lambda.data() + dim, start);
  const double* D = p.G->diagonalBlock(0);
  const LawInput in = p.input(0);
  local_.clear();
  local_.add(D, dim, p.law(0).simpleSet(in));
  // One contact: b = c.
  const LocalCase found = local_.solve(0, p.c.data(), Lambda.data()).found;
  report.method = found == LocalCase::takeOff ? "take-off"
                  : found == LocalCase::stick ? "stick"
                                              : "slip";
  if (!Lambda.allFinite()) std::copy(start, start + dim, Lambda.data());
  if (found == LocalCase::notSimple || found == LocalCase::noSolution) {
    relaxation(p, Relaxation::exact, 1.0, r_);
    iterateContact(p.law(0), in, D, p.c.data(), r_.data(), Lambda.data());
    report.method = "one contact";
  }
  const Residuals now = residuals(p, view(Lambda), scratch_);
  if (now.largest() <= tolerance) {
    report.residuals = now, report.iterations = 1;
    return true;
  }
  std::copy(start, start + dim, Lambda.data());
  return false;
}

void EasyProblems::rowScales(const InclusionProblem& p) {
  lambda_.resize(static_cast<std::size_t>(p.rows()));
  for (int i = 0; i < p.size(); ++i)
    std::fill_n(lambda_.begin() + p.row0(i), p.dim(i),
                contactLambda(p.G->diagonalBlock(i), p.dim(i)));
}

double EasyProblems::change(ConstVec Lambda) const {
  double largest = 0.0;
  for (std::size_t k = 0; k < lambda_.size(); ++k)
    largest =
        std::max(largest, lambda_[k] * std::abs(Lambda[static_cast<Eigen::Index>(k)] - before_[k]));
  return largest;
}

void EasyProblems::accelerate(const InclusionProblem& p, bool first, Vec Lambda) {
  if (first) {
    rowScales(p);
    anderson_.begin(kAndersonDepth, lambda_.data(), p.rows());
  }
  anderson_.next(before_.data(), Lambda.data(), Lambda.data());
}

bool EasyProblems::sweeps(const InclusionProblem& p, double tolerance, Vec Lambda,
                          SolveReport& report) {
  report.method = "sweeps";
  block_.prepare(p);
  // r is needed even if all sets are simple: a contact without solution for some b makes a prox
  // step.
  relaxation(p, Relaxation::exact, 1.0, r_);
  start_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  best_ = start_;
  before_.resize(best_.size());
  Residuals& best = bestResiduals_ = report.residuals;
  // Residuals of the last two tests; `part`: residual over change of Λ at the last test.
  double last = best.largest(), earlier = last, part = 0.0;
  int sweep = 0, tested = 0, earlierSweep = 0;
  for (bool promising = true; promising;) {
    if (sweep > 0) accelerate(p, sweep == 1, Lambda);
    std::copy(Lambda.data(), Lambda.data() + Lambda.size(), before_.begin());
    p.G->begin(Lambda.data());
    block_.sweep(p, r_.data(), Lambda.data());
    ++sweep, ++report.iterations;
    const double moved = sweep > 1 ? change(view(Lambda)) : 0.0;
    const bool enough = p.enough();
    if (!enough && sweep > 2 && sweep - tested < kSweepsPerTest && part * moved > tolerance)
      continue;
    const Residuals now = residuals(p, view(Lambda), scratch_);
    if (now.largest() <= best.largest()) {
      best = now;
      std::copy(Lambda.data(), Lambda.data() + Lambda.size(), best_.begin());
    }
    if (best.largest() <= tolerance || enough) break;
    // ln E falls by `fall` per sweep: how many more are needed?
    const double fall = std::log(earlier / best.largest()) / (sweep - earlierSweep);
    const double missing = std::log(best.largest() / tolerance) / fall;
    promising = sweep < kFirstSweeps || (fall > 0.0 && missing <= kSweepPatience);
    earlier = last, earlierSweep = tested;
    last = best.largest(), tested = sweep, part = moved > 0.0 ? now.largest() / moved : 0.0;
  }
  std::copy(best_.begin(), best_.end(), Lambda.data());
  report.residuals = best;
  if (best.largest() <= tolerance || p.enough()) return best.largest() <= tolerance;
  // Newton's method starts better from plain prox sweeps: extrapolated and locally exact Λ have a
  // more ragged set of sticking contacts.
  std::copy(start_.begin(), start_.end(), Lambda.data());
  p.G->begin(Lambda.data());
  for (int k = 0; k < kPlainSweeps; ++k) prox_.sweep(p, r_.data(), Lambda.data());
  report.iterations += kPlainSweeps;
  report.residuals = residuals(p, view(Lambda), scratch_);
  return report.residuals.largest() <= tolerance;
}

}  // namespace dynamy
