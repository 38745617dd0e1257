/// DenseProblem: a copy of an inclusion problem and its Λ as full matrices, for single
/// investigations: rank, kernel, and changes of forces that no velocity shows.
///
///   S = diag(λ_i^(-1/2)),   S G S = Z diag(σ) Zᵀ   (symmetric part),   rank: σ > 1e-11 σ_max
///
/// One scale factor per contact preserves the cones and makes ranks independent of masses. The
/// class is not for use within a step: it allocates, and an eigenvalue problem costs 10 n³.
#pragma once
#include <dynamy/solver/problem/inclusion_solver.hpp>

namespace dynamy {

class DenseProblem {
 public:
  /// Copies G, c, Λ; the laws stay borrowed. Λ: rows() entries.
  DenseProblem(const InclusionProblem& problem, ConstVec Lambda);

  const InclusionProblem& problem() const { return *problem_; }
  const Eigen::MatrixXd& G() const { return G_; }
  const Eigen::VectorXd& Lambda() const { return Lambda_; }
  const Eigen::VectorXd& xi() const { return xi_; }
  /// True: the scaled G and ξ are finite. To be checked before the functions below are used.
  bool finite() const { return finite_; }
  /// λ_i^(-1/2) of every row.
  const Eigen::VectorXd& scale() const { return scale_; }
  /// True if the law allows any Λ_i, as for joints.
  bool isFree(int contact) const { return free_[static_cast<std::size_t>(contact)]; }
  /// True if the contact has a normal force.
  bool hasNormal(int contact) const;
  /// True if the contact carries a force, or could at once because ξ_N is zero.
  bool isClosed(int contact) const { return closed_[static_cast<std::size_t>(contact)]; }
  /// ∂prox_C/∂z at z = Λ − ρξ, ρ = 1/λ_i, dim × dim: the changes of Λ that the law allows at given
  /// ξ.
  Eigen::MatrixXd proxJacobian(int contact) const;

  /// Rows of all contacts i with chosen(i).
  template <class Chosen>
  std::vector<int> rowsOf(Chosen&& chosen) const {
    std::vector<int> rows;
    for (int i = 0; i < problem_->size(); ++i)
      if (chosen(i))
        for (int k = 0; k < problem_->dim(i); ++k) rows.push_back(problem_->row0(i) + k);
    return rows;
  }
  /// Orthonormal columns Z with S G S Z = 0 on `rows`; rank = rows − columns.
  Eigen::MatrixXd kernel(const std::vector<int>& rows) const;
  /// G on `rows` if the forces on the rows `given` keep the velocities of these rows constant: G_rr
  /// − G_rg G_gg⁺ G_gr.
  Eigen::MatrixXd reduced(const std::vector<int>& rows, const std::vector<int>& given) const;

 private:
  bool anyForceAllowed(int contact) const;
  const InclusionProblem* problem_;
  Eigen::MatrixXd G_;
  Eigen::VectorXd c_, Lambda_, xi_, scale_;
  std::vector<bool> free_, closed_;
  bool finite_ = true;
};

}  // namespace dynamy
