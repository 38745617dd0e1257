/// LcpForm: an inclusion problem written as a linear complementarity problem.        (theory 8.2)
///
///   Λ = Λ₀ + P z + Λ_F,    ξ_F = 0 eliminates the free rows F (joints)
///   normal force:          z_N = Λ_N ⊥ ξ_N ≥ 0
///   interval [a, b]:       Λ = a + z,  z ⊥ ξ + s ≥ 0,  s ⊥ b − a − z ≥ 0
///   friction N·B, B with vertices v_k:
///                          Λ_T = Σ β_k v_k,  β_k ⊥ v_kᵀξ_T + s ≥ 0,  s ⊥ N − Σ β_k ≥ 0
///
///   M = [ PᵀG̃P   E ]     E_kj = 1 if bound j holds variable k,  b_jᵀ: the normal force of bound j
///       [ B − Eᵀ  0 ]
///
/// The form is exact for joints, contacts without friction, intervals and planar friction; a disc
/// becomes the polygon of `facets` vertices on its circle. zᵀMz = ΛᵀG̃Λ + Σ s_j N_j ≥ 0 for z ≥ 0:
/// copositive, and Lemke's method finds a solution whenever c = Wᵀu for a velocity u
/// of the bodies [anitescu_potra1997]. The book's form with two unknowns per friction
/// [glocker_studer2005] is smaller; it was rejected, because its matrix G_NN − G_NT μ … is copositive
/// for small μ only.
#pragma once
#include <dynamy/core/decompositions.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/problem/inclusion_problem.hpp>
#include <vector>

namespace dynamy {

class LcpForm {
 public:
  /// `facets`: even, ≥ 4.
  void pose(const InclusionProblem& problem, int facets);
  ConstBlock M() const { return {M_.data(), M_.rows(), M_.cols()}; }
  ConstVec q() const { return {q_.data(), q_.size()}; }
  int size() const { return static_cast<int>(q_.size()); }
  /// False: a disc or another round set was replaced by a polytope.
  bool exact() const { return exact_; }
  /// Computes Λ from a solution z.
  void forces(const double* z, Vec Lambda) const;

 private:
  struct Variable {
    int row = 0, count = 1;  ///< Λ[row …] += v z
    int bound = -1;
    double v[kMostRows] = {};
  };
  struct Bound {
    double constant = 0.0;
    int normal = -1;  ///< variable of the normal force, or −1: the constant
  };
  void describe(const InclusionProblem& problem, int facets);
  void scalar(int row, double lower, double upper);
  void friction(const InclusionProblem& p, int i, int first, int end, int normal, int facets);
  void eliminate(const InclusionProblem& problem);
  void assemble();
  double along(const Variable& a, const double* rows) const;

  bool exact_ = true;
  std::vector<Variable> variables_;
  std::vector<Bound> bounds_;
  std::vector<int> free_;
  Eigen::VectorXd Lambda0_, c0_, free0_, q_;
  RowMatrix G_, GP_, freeZ_, M_;
  PseudoInverse joints_{1e-11};  // equations that agree to this fraction are redundant
};

}  // namespace dynamy
