/// The tests of a Diagnosis, one function each; each returns a finding or nothing.
#pragma once
#include <dynamy/solver/diagnosis/diagnosis.hpp>
#include <dynamy/solver/problem/dense_problem.hpp>
#include <optional>

namespace dynamy::diagnosis {

/// Names of contacts as they appear in sentences.
struct Names {
  const std::function<std::string(int)>& given;
  std::string operator()(int contact) const;
  /// List of names: "a", "a and b", "a, b and c", "a, b, c and 9 more".
  std::string operator()(const std::vector<int>& contacts) const;
};
/// x as text with two significant digits.
std::string number(double x);

std::optional<Finding> unsolved(const SolveReport& report, const Names& names);
/// Tries pivoting on an unsolved problem of up to 200 rows: it finds a solution, or proves that
/// none exists.
std::optional<Finding> pivoted(const InclusionProblem& problem, const SolveReport& report,
                               const DiagnosisOptions& options);
std::optional<Finding> tooLarge(int rows, int most);
/// Finding if 4ε |G||Λ| / u_ref of the worst contact is above the tolerance.
std::optional<Finding> rounding(const DenseProblem& dense, double tolerance, const Names& names);
/// Finding if c of the joints has a part in ker G_JJ: no velocity fulfils all joints.
std::optional<Finding> contradictingJoints(const DenseProblem& dense, const Names& names);
std::optional<Finding> redundantJoints(const DenseProblem& dense, const Names& names);
std::optional<Finding> jam(const DenseProblem& dense, const Names& names);
/// Examines single contacts with joints eliminated, then all sliding contacts together.
std::vector<Finding> painleve(const DenseProblem& dense, const Names& names);
std::optional<Finding> severalSolutions(const DenseProblem& dense, const SolveReport& report,
                                        InclusionSolver& solver, double tolerance,
                                        const Names& names);
std::optional<Finding> forcesNotUnique(const Diagnosis& d, const Names& names);

/// Dimension of { ΔΛ = S Z y : P ΔΛ = ΔΛ } over the closed contacts.
int freeDirections(const DenseProblem& dense, const Eigen::MatrixXd& kernel);

}  // namespace dynamy::diagnosis
