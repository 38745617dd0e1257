#include <cmath>
#include <dynamy/solver/inclusion_problem.hpp>
#include <dynamy/solver/stopping_rule.hpp>

namespace dynamy {

double FclibRule::measure(const InclusionProblem& p, const double* Lambda, const double* xi) const {
  constexpr int kMaxDim = 8;
  double sum = 0.0, c2 = 0.0;
  for (const double c : p.c) c2 += c * c;
  for (int i = 0; i < p.size(); ++i) {
    double e[kMaxDim] = {};
    p.law(i).naturalMap(p.input(i), 1.0, xi + p.row0(i), Lambda + p.row0(i), e);
    for (int k = 0; k < p.dim(i); ++k) sum += e[k] * e[k];
  }
  return sum == 0.0 ? 0.0 : (c2 > 0.0 ? std::sqrt(sum / c2) : std::sqrt(sum));
}

}  // namespace dynamy
