#include <dynamy/core/safe_norm.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/problem/inclusion_problem.hpp>
#include <dynamy/solver/problem/stopping_rule.hpp>

namespace dynamy {

double FclibRule::measure(const InclusionProblem& p, const double* Lambda, const double* xi) const {
  SafeSum missed, given;
  for (const double c : p.c) given.add(c);
  for (int i = 0; i < p.size(); ++i) {
    double e[kMostRows] = {};
    p.law(i).naturalMap(p.input(i), 1.0, xi + p.row0(i), Lambda + p.row0(i), e);
    for (int k = 0; k < p.dim(i); ++k) missed.add(e[k]);
  }
  if (missed.zero()) return 0.0;
  return given.zero() ? missed.root() : missed.over(given);
}

}  // namespace dynamy
