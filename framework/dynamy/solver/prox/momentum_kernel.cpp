#include <algorithm>
#include <dynamy/solver/prox/momentum.hpp>

namespace dynamy {
namespace {

/// x ← x + β (x − last), last ← x.
void goOn(double beta, std::vector<double>& last, double* x) {
  for (std::size_t k = 0; k < last.size(); ++k) {
    const double now = x[k];
    x[k] = now + beta * (now - last[k]);
    last[k] = now;
  }
}

}  // namespace

void Momentum::next(const InclusionProblem& p, double* Lambda) {
  if (!(beta_ > 0.0)) return;
  double* v = p.G->sweepVelocities();
  ++sweeps_;
  if (sweeps_ == 1) {
    Lambda_.assign(Lambda, Lambda + p.rows());
    const int last = v ? p.G->mass().blocks() - 1 : 0;
    if (v) v_.assign(v, v + p.G->mass().u0(last) + p.G->mass().nu(last));
    return;
  }
  const double beta = std::min(beta_, (sweeps_ - 1.0) / (sweeps_ + 2.0));
  goOn(beta, Lambda_, Lambda);
  if (v) goOn(beta, v_, v);
}

}  // namespace dynamy
