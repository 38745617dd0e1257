/// Diagnosis: findings about an inclusion problem beyond its residuals, in plain words. It runs on
/// request, after a failure or by `dynamy solve`, never in a step.             (theory 7.8)
///
///   forces not unique    ker G on the closed contacts contains ΔΛ with P ΔΛ = ΔΛ, P = ∂prox/∂z
///   redundant joints     ker G_JJ ≠ 0;  they contradict each other if c has a part in it
///   jam                  Λ ≠ 0 in the cones with GΛ = 0: these forces hold each other
///   Painlevé             S_B(−G_NT) ≥ G_NN: sliding, friction presses more than the normal force
///                        opens (Coulomb: μ|G_NT| ≥ G_NN)
///   several solutions    other starts end at another ξ
#pragma once
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <functional>
#include <string>

namespace dynamy {

enum class FindingKind : std::uint8_t {
  unsolved,
  rounding,
  contradiction,
  jam,
  painleve,
  severalSolutions,
  redundantJoints,
  forcesNotUnique,
  tooLarge
};
/// Name of a kind for programs: "unsolved", "jam", ….
std::string_view findingName(FindingKind kind);

struct Finding {
  FindingKind kind = FindingKind::unsolved;
  std::vector<int> contacts;  ///< the contacts concerned
  double value = 0.0;         ///< figure of the finding: residual, indicator, difference of ξ …
  std::string text;           ///< the finding in one or two sentences
  std::string advice;         ///< what to do; may be empty
};

struct Diagnosis {
  int contacts = 0, closed = 0;
  int rows = 0;     ///< rows of the closed contacts
  int rank = 0;     ///< rank of G on these rows; −1: not computed
  int freedom = 0;  ///< directions in which the forces may change at unchanged velocities
  std::vector<Finding> findings;  ///< the most serious first
  /// The first finding of this kind, or null.
  const Finding* find(FindingKind kind) const;
  /// The whole diagnosis as text: one paragraph per finding, lines indented by `indent`.
  std::string text(const std::string& indent = "") const;
};

struct DiagnosisOptions {
  double tolerance = 1e-10;
  bool otherStarts = true;  ///< two or three more solves, from other starts
  int maxPivots = 10000;    ///< of the search for a solution by pivoting
  int maxRows = 900;        ///< larger problems are not examined: eigenvalues cost 10 n³
  std::function<std::string(int)> name;  ///< name of a contact; default: "contact 3"
};

/// Examines a problem. `Lambda`, `report`: results of `solver`, which also solves from other
/// starts.
Diagnosis diagnose(const InclusionProblem& problem, ConstVec Lambda, const SolveReport& report,
                   InclusionSolver& solver, const DiagnosisOptions& options = {});

/// The chain of methods of a solve as text: "sweeps (15 iterations, residual 0.0021), then …".
std::string attemptsText(const SolveReport& report);

}  // namespace dynamy
