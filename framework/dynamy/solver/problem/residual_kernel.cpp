#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/safe_norm.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Smaller λ have no finite inverse.
constexpr double kLeastLambda = 4.0 * std::numeric_limits<double>::min();

}  // namespace

double contactLambda(const double* block, int dim) {
  double largest = 0.0;
  if (dim == 3) {  // the contact in space, written out
    const auto row = [block](int r) {
      return std::abs(block[3 * r]) + std::abs(block[3 * r + 1]) + std::abs(block[3 * r + 2]);
    };
    largest = std::max({row(0), row(1), row(2)});
  } else {
    for (int r = 0; r < dim; ++r) {
      double sum = 0.0;
      for (int k = 0; k < dim; ++k) sum += std::abs(block[r * dim + k]);
      largest = std::max(largest, sum);
    }
  }
  return largest >= kLeastLambda ? largest : 0.0;
}

std::string_view solveStatusText(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return "solved";
    case SolveStatus::maxIterations:
      return "iteration limit reached";
    case SolveStatus::stalled:
      return "stalled";
    case SolveStatus::diverged:
      return "diverged";
    case SolveStatus::notFinite:
      return "not finite";
  }
  return "unknown";
}

namespace {

constexpr double kResidualNoise = 4.0 * std::numeric_limits<double>::epsilon();
/// E_u between which rounding of GΛ may decide: below, every tolerance is met; above, rounding is
/// too small.
constexpr double kFine = 1e-13, kCoarse = 1e-5;
/// Fraction of the velocities of a problem that Λ − ρ ξ must resolve.
constexpr double kSwallowed = 1e-2;

/// Rounding error of |e_i|/ρ_i: that of c, and (once |G||Λ| is known) that of ξ = GΛ + c.
double noise(const InclusionProblem& p, int i, const double* absolute) {
  double sum = 0.0;
  for (int k = p.row0(i); k < p.row0(i) + p.dim(i); ++k) {
    const auto at = static_cast<std::size_t>(k);
    sum += kResidualNoise * std::abs(p.c[at]);
    if (!p.cNoise.empty()) sum += p.cNoise[at];
    if (absolute) sum += kResidualNoise * absolute[k];
  }
  return sum;
}

/// The measures from e_i/ρ_i of all contacts; `absolute` = |G||Λ| or null.
Residuals measure(const InclusionProblem& p, const double* velocity, const double* rho,
                  const double* absolute, double largestLambda) {
  Residuals out;
  double worstE = 0.0, worstU = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    const double v = velocity[i];
    if (v <= noise(p, i, absolute)) continue;
    worstE = std::max(worstE, v * rho[i]);
    if (v > worstU) worstU = v, out.worst = i;
  }
  out.Ef = worstE == 0.0 ? 0.0 : (largestLambda > 0.0 ? worstE / largestLambda : 1.0);
  out.Eu = worstU == 0.0 ? 0.0 : (p.uRef > 0.0 ? worstU / p.uRef : 1.0);
  if (!std::isfinite(out.Ef)) out.Ef = out.Eu;  // the forces overflow; E_f ≤ E_u
  return out;
}

/// Stands in for λ of a contact with G_ii = 0: the largest Σ_j|G_kj| of its rows, of all rows if
/// those are zero too, or 1. With ρ = 0 such a contact would always count as solved.
double substituteLambda(const InclusionProblem& p, int i, const double* rowSums) {
  const double own = *std::max_element(rowSums + p.row0(i), rowSums + p.row0(i) + p.dim(i));
  if (own >= kLeastLambda) return own;
  const double all = *std::max_element(rowSums, rowSums + p.rows());
  return all >= kLeastLambda ? all : 1.0;
}

/// The largest velocity from which c was computed: a last correction has a small c made of large
/// terms.
double largestVelocity(const InclusionProblem& p) {
  double largest = p.uRef;
  for (const auto* part : {&p.c, &p.gammaFree, &p.gammaA})
    for (const double v : *part) largest = std::max(largest, std::abs(v));
  for (const double v : p.cNoise) largest = std::max(largest, v / kResidualNoise);
  return largest;
}

/// Called if Λ of contact i is so large that rounding of Λ − ρ ξ hides ξ: the natural map may then
/// be zero whatever ξ is. The speed that cannot be distinguished from zero, ε |Λ_i|/ρ_i, counts as
/// the error. Problems without solution end here, because Λ grows without bound.
void swallowed(const InclusionProblem& p, double unknown, int i, Residuals& out) {
  const double E = p.uRef > 0.0 ? unknown / p.uRef : 1.0;
  out.Eu = std::max(out.Eu, E), out.Ef = std::max(out.Ef, std::min(E, 1.0)), out.worst = i;
  if (out.given != -1.0) out.given = std::max(out.given, E);
}

/// |c| and |Λ| of one contact of n rows (0: of `dim`).
struct Lengths {
  double c = 0.0, Lambda = 0.0;
  bool finite = true;
};
/// Adds c to ξ and returns the lengths of c and Λ.
template <int n>
Lengths addC(const double* c, const double* Lambda, int dim, double* xi) {
  const int rows = n > 0 ? n : dim;
  double c2 = 0.0, Lambda2 = 0.0;
  bool finite = true;
  for (int r = 0; r < rows; ++r) {
    xi[r] += c[r];
    c2 += c[r] * c[r], Lambda2 += Lambda[r] * Lambda[r];
    finite = finite && std::isfinite(xi[r]) && std::isfinite(Lambda[r]);
  }
  return {safeNorm(c, rows, c2), safeNorm(Lambda, rows, Lambda2), finite};
}

Residuals notFinite(int contact) {
  return {.Ef = kInfinity, .Eu = kInfinity, .energy = kInfinity, .worst = contact};
}

}  // namespace

Residuals residuals(const InclusionProblem& problem, ConstVec Lambda,
                    std::vector<double>& scratch) {
  const int n = problem.rows(), contacts = problem.size();
  if (n == 0) {
    Residuals none;
    if (problem.rule) none.given = 0.0;
    return none;
  }
  // Layout of `scratch`: ξ, |G||Λ|; e/ρ and ρ of the contacts.
  scratch.resize(2 * static_cast<std::size_t>(n) + 2 * static_cast<std::size_t>(contacts));
  double *absolute = scratch.data() + n, *velocity = absolute + n, *scale = velocity + contacts;
  if (std::all_of(Lambda.data(), Lambda.data() + n, [](double x) { return x == 0.0; }))
    std::fill(scratch.begin(), scratch.begin() + n, 0.0);
  else
    problem.G->apply(Lambda.data(), scratch.data());
  const double unit = problem.uRef > 0.0 ? problem.uRef : 1.0;  // of velocities that are squared
  double largestLambda = 0.0, spurious = 0.0, available = 0.0, unknown = 0.0;
  int lost = -1;
  bool summed = false;
  for (int i = 0; i < contacts; ++i) {
    const int first = problem.row0(i), dim = problem.dim(i);
    double* xi = scratch.data() + first;
    double lambda = contactLambda(problem.G->diagonalBlock(i), dim);
    if (!(lambda > 0.0)) {
      if (!summed) problem.G->rowSums(absolute);  // `absolute` is free until the end
      summed = true;
      lambda = substituteLambda(problem, i, absolute);
    }
    const double rho = 1.0 / lambda;
    const double *c = problem.c.data() + first, *L = Lambda.data() + first;
    const Lengths lengths = dim == 3 ? addC<3>(c, L, dim, xi) : addC<0>(c, L, dim, xi);
    // A projection may hide numbers that are not finite: they are reported here as infinite.
    if (!lengths.finite) return notFinite(i);
    double e[kMostRows] = {};
    const double length = lengths.Lambda;
    problem.law(i).naturalMap(problem.input(i), rho, xi, Lambda.data() + first, e);
    velocity[i] = safeNorm(e, dim) * lambda;
    if (!std::isfinite(velocity[i])) return notFinite(i);
    const double resolution = std::numeric_limits<double>::epsilon() * length * lambda;
    if (resolution > unknown) unknown = resolution, lost = i;
    scale[i] = rho;
    largestLambda = std::max({largestLambda, length, rho * problem.uRef});
    const double wrong = velocity[i] / unit, given = lengths.c / unit;
    spurious += rho * wrong * wrong, available += rho * given * given;
  }
  Residuals out = measure(problem, velocity, scale, nullptr, largestLambda);
  if (out.Eu > kFine && out.Eu <= kCoarse) {
    problem.G->applyAbsolute(Lambda.data(), absolute);
    out = measure(problem, velocity, scale, absolute, largestLambda);
  }
  if (problem.rule) out.given = problem.rule->measure(problem, Lambda.data(), scratch.data());
  if (unknown > kSwallowed * problem.uRef && unknown > kSwallowed * largestVelocity(problem))
    swallowed(problem, unknown, lost, out);
  out.energy = spurious == 0.0 ? 0.0 : (available > 0.0 ? spurious / available : 1.0);
  return out;
}

}  // namespace dynamy
