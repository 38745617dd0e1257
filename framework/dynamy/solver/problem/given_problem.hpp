/// GivenProblem: an inclusion problem without bodies, given by numbers.
///
///   ξ = G Λ + c,   −ξ_i ∈ N_{C_i}(Λ_i)
///
/// It owns what an InclusionProblem borrows: laws, contacts, G.
#pragma once
#include <Eigen/SparseCore>
#include <dynamy/solver/problem/inclusion_problem.hpp>
#include <memory>

namespace dynamy {

/// One contact of a problem without bodies.
struct GivenContact {
  std::unique_ptr<SetValuedForceLaw> law;
  int dim = 1;
};

class GivenProblem {
 public:
  /// G: rows × rows, need not be symmetric; c: rows [m/s]. The rows are in the order of the
  /// contacts.
  GivenProblem(std::vector<GivenContact> contacts, const Eigen::SparseMatrix<double>& G,
               const Eigen::VectorXd& c);
  GivenProblem(const GivenProblem&) = delete;
  GivenProblem& operator=(const GivenProblem&) = delete;

  InclusionProblem& problem() { return problem_; }
  const InclusionProblem& problem() const { return problem_; }

 private:
  std::vector<GivenContact> owned_;
  ContactSet contacts_;
  Delassus G_;
  InclusionProblem problem_;
};

}  // namespace dynamy
