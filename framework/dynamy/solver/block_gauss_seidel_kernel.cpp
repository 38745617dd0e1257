#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <dynamy/solver/local/local_iteration.hpp>

namespace dynamy {
void BlockGaussSeidel::prepare(const InclusionProblem& p) {
  if (options().symmetric || !balls_.prepare(p)) return local_.prepare(p);
  local_.clear();
  for (const int i : balls_.rest())
    local_.add(p.G->diagonalBlock(i), p.dim(i), p.law(i).simpleSet(p.input(i)));
}

void BlockGaussSeidel::sweep(const InclusionProblem& p, const double* r, double* Lambda) {
  if (balls_.prepared()) {
    balls_.sweep(p, Lambda);
    int prepared = 0;
    for (const int i : balls_.rest()) contact(p, i, prepared++, r, Lambda);
    return;
  }
  for (int i = 0; i < p.size(); ++i) contact(p, i, i, r, Lambda);
  if (!options().symmetric) return;
  for (int i = p.size() - 1; i >= 0; --i) contact(p, i, i, r, Lambda);
}

void BlockGaussSeidel::contact(const InclusionProblem& p, int i, int prepared, const double* r,
                               double* Lambda) {
  const int dim = p.dim(i), first = p.row0(i);
  const double* D = p.G->diagonalBlock(i);
  double *mine = Lambda + first, b[kMostRows], old[kMostRows];
  p.G->row(i, Lambda, b);
  for (int k = 0; k < dim; ++k) {
    double own = 0.0;
    for (int m = 0; m < dim; ++m) own += D[k * dim + m] * mine[m];
    b[k] += p.c[static_cast<std::size_t>(first + k)] - own;
    old[k] = mine[k];
  }
  const LocalCase found = local_.solve(prepared, b, mine).found;
  const bool finite = std::all_of(mine, mine + dim, [](double x) { return std::isfinite(x); });
  if (!finite) std::copy(old, old + dim, mine);  // squares of huge numbers overflow
  if (!finite || found == LocalCase::notSimple || found == LocalCase::noSolution)
    iterateContact(p.law(i), p.input(i), D, b, r + first, mine);
  for (int k = 0; k < dim; ++k) old[k] = mine[k] - old[k];
  p.G->changed(i, old);
}

void BlockGaussSeidel::declare(Attributes& a) {
  declareCommon(a, "exact", 0.7);
  declareOrder(a);
  a.about(
      "Gauss-Seidel by blocks: one contact after the other is solved exactly, in closed form for "
      "joints, contacts with Coulomb friction and given friction.");
  a.example(
      "<simulation until=\"1\" step=\"1e-3\"><BlockGaussSeidel anderson=\"10\" "
      "order=\"symmetric\"/></simulation>");
}

}  // namespace dynamy
