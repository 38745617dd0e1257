#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/solver/diagnosis/diagnosis_parts.hpp>
#include <dynamy/solver/lemke_solver.hpp>
#include <limits>

namespace dynamy::diagnosis {
namespace {

constexpr double kOneSolution = 1e-6;  ///< fraction of u_ref: solutions that differ by less are one

/// Λ_i ← prox_C(Λ_i): a start the laws allow.
void intoSets(const InclusionProblem& p, Eigen::VectorXd& Lambda) {
  const std::vector<double> ones(static_cast<std::size_t>(p.rows()), 1.0),
      zeros(static_cast<std::size_t>(p.rows()), 0.0);
  for (int i = 0; i < p.size(); ++i)
    p.law(i).prox(p.input(i), ones.data() + p.row0(i), zeros.data() + p.row0(i),
                  Lambda.data() + p.row0(i));
}

/// Three starts: no force; all contacts stick; large normal forces.
std::vector<Eigen::VectorXd> starts(const DenseProblem& dense) {
  const InclusionProblem& p = dense.problem();
  std::vector<Eigen::VectorXd> out(3, Eigen::VectorXd::Zero(p.rows()));
  const Eigen::VectorXd& s = dense.scale();
  PseudoInverse inverse(1e-11);
  inverse.compute(s.asDiagonal() * dense.G() * s.asDiagonal());
  const Eigen::Map<const Eigen::VectorXd> c(p.c.data(), p.rows());
  inverse.solve(s.cwiseProduct(c), out[1]);
  out[1] = -s.cwiseProduct(out[1]);
  intoSets(p, out[1]);
  for (int i = 0; i < p.size(); ++i)
    if (dense.hasNormal(i)) out[2][p.row0(i)] = 10.0 * p.uRef * s[p.row0(i)] * s[p.row0(i)];
  return out;
}

/// True if the forces are so large that velocities of the problem's size are rounding of GΛ: such
/// forces fulfil any law.
bool onlyRounding(const DenseProblem& dense, const Eigen::VectorXd& Lambda) {
  const double largest = (dense.G().cwiseAbs() * Lambda.cwiseAbs()).maxCoeff();
  return std::numeric_limits<double>::epsilon() * largest > kOneSolution * dense.problem().uRef;
}

std::string stateText(const DenseProblem& dense, const Eigen::VectorXd& Lambda,
                      const Eigen::VectorXd& xi, int i) {
  const InclusionProblem& p = dense.problem();
  const int first = p.row0(i), dim = p.dim(i);
  if (dense.hasNormal(i)) {
    if (xi[first] > kOneSolution * p.uRef || !(Lambda[first] > 0.0)) return "opens";
    return dim > 1 && xi.segment(first + 1, dim - 1).norm() > kOneSolution * p.uRef ? "slides"
                                                                                    : "sticks";
  }
  return "has velocity " + number(xi.segment(first, dim).norm());
}

}  // namespace

std::optional<Finding> pivoted(const InclusionProblem& p, const SolveReport& report,
                               const DiagnosisOptions& options) {
  constexpr int kMostPivoted = 200;
  if (report.ok() || p.rows() > kMostPivoted) return std::nullopt;
  LemkeSolver lemke({.tolerance = options.tolerance, .maxPivots = options.maxPivots});
  Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(p.rows());
  if (lemke.solve(p, view(Lambda)).ok())
    return Finding{FindingKind::severalSolutions,
                   {},
                   1.0,
                   "Pivoting finds a solution where the methods above do not.",
                   "Use the solver Lemke for this scene."};
  if (!lemke.proven()) return std::nullopt;
  return Finding{FindingKind::contradiction,
                 {},
                 0.0,
                 "Proven by pivoting: no forces and velocities fulfil all laws of this step.",
                 "The cause is in the model, not in the solver."};
}

std::optional<Finding> severalSolutions(const DenseProblem& dense, const SolveReport& report,
                                        InclusionSolver& solver, double tolerance,
                                        const Names& names) {
  const InclusionProblem& p = dense.problem();
  if (!(p.uRef > 0.0) || p.rows() == 0 || !dense.finite()) return std::nullopt;
  struct Solution {
    Eigen::VectorXd Lambda, xi;
  };
  std::vector<Solution> found;
  if (report.ok()) found.push_back({dense.Lambda(), dense.xi()});
  int tried = 0, solved = 0;
  double difference = 0.0;
  int where = -1;
  for (Eigen::VectorXd& Lambda : starts(dense)) {
    ++tried;
    const SolveReport r = solver.solve(p, view(Lambda));
    if (!r.ok() || onlyRounding(dense, Lambda)) continue;
    ++solved;
    const Eigen::VectorXd xi =
        dense.G() * Lambda + Eigen::Map<const Eigen::VectorXd>(p.c.data(), p.rows());
    double nearest = found.empty() ? 0.0 : 1e300;
    Eigen::Index row = 0;
    for (const Solution& f : found)
      nearest = std::min(nearest, (xi - f.xi).cwiseAbs().maxCoeff(&row));
    // Errors that the tolerance leaves in a badly conditioned problem are no second solution.
    if (found.empty() || nearest > std::max(kOneSolution, 1e4 * tolerance) * p.uRef) {
      if (nearest > difference) {
        difference = nearest, where = 0;
        while (p.row0(where) + p.dim(where) <= row) ++where;
      }
      found.push_back({Lambda, xi});
    }
  }
  if (found.size() < 2) {
    if (report.ok() || found.empty()) return std::nullopt;
    return Finding{FindingKind::severalSolutions,
                   {},
                   1.0,
                   "Another start (" + std::to_string(solved) + " of " + std::to_string(tried) +
                       " tried) is solved: the problem has a solution.",
                   "Start from Lambda = 0 or from the last step's forces, or take a smaller step."};
  }
  std::string states;
  for (const Solution& f : found) {
    const std::string now = stateText(dense, f.Lambda, f.xi, where);
    if (states.find(now) == std::string::npos) states += (states.empty() ? "" : ", or ") + now;
  }
  return Finding{FindingKind::severalSolutions,
                 {where},
                 difference,
                 std::to_string(found.size()) +
                     " different solutions were found from different starts; at " + names(where) +
                     " their velocities differ by " + number(difference) + " (it " + states + ").",
                 "The laws of rigid bodies do not choose between them; the run takes the one its "
                 "start leads to. A compliant contact or less friction makes the motion definite."};
}

}  // namespace dynamy::diagnosis
