/// Lemke: complementary pivoting for the linear complementarity problem
///
///   w = M z + q,   0 ≤ w ⊥ z ≥ 0                                             (theory 8.1)
///
/// on the tableau of w − M z − d z₀ = q with the covering vector d > 0. z₀ enters first and makes
/// the basis feasible. Then the complement of the variable that left last enters, until z₀ leaves
/// (solved) or no variable can leave (a ray). The lexicographic rule decides between equal ratios,
/// so that no basis occurs twice. Rows and columns are scaled first. The tableau is recomputed from
/// the basis at intervals, and z at the end from the equations of its basis. After a ray, or a z
/// spoilt by rounding, two more covering vectors are tried.
///
/// For a general M a ray alone proves nothing. Its direction h proves that there is no solution if
/// h ≥ 0, Mᵀh ≤ 0, qᵀh < 0, because then hᵀw < 0 for all z ≥ 0. For copositive-plus M (which
/// includes positive semidefinite M) every ray is such a proof [cottle_pang_stone2009, 4.4]. After
/// any other ray, pivoting on [0 −Mᵀ; M 0] looks for a proof from the linear inequalities alone.
/// Rejected: least-index (Bland) pivoting, which cycles no more than the lexicographic rule but
/// pivots on small numbers; and a revised method with LU updates, which pays only above a few
/// hundred rows.
#pragma once
#include <Eigen/LU>
#include <dynamy/core/types.hpp>
#include <functional>
#include <vector>

namespace dynamy {

enum class LcpOutcome : std::uint8_t {
  solved,
  infeasible,  ///< proven: no z ≥ 0 gives w ≥ 0
  ray,         ///< nothing is known; w, z ≥ 0 exist, but pivoting found no complementary ones
  pivotLimit,
  notFinite
};

class Lemke {
 public:
  /// z of n numbers; M: n × n, any matrix. z is written only if the outcome is `solved`.
  /// `enough` is called at every pivot; if it returns true, the outcome is `pivotLimit`. It may be
  /// empty.
  LcpOutcome solve(ConstBlock M, ConstVec q, Vec z, int maxPivots = 10000,
                   const std::function<bool()>& enough = {});
  int pivots() const { return pivots_; }
  /// Direction h (n numbers) that proves infeasibility, if the outcome is `infeasible`.
  const Eigen::VectorXd& direction() const { return direction_; }

 private:
  LcpOutcome pivoting(int maxPivots, const std::function<bool()>& enough);
  bool provenInfeasible(const std::function<bool()>& enough);
  double coveringValue() const;
  void scale(ConstBlock M, ConstVec q);
  void start();
  void rebuild();
  int leavingRow(int column, bool first) const;
  bool lexicographicallyLess(int a, int b, int column) const;
  void pivot(int row, int column);
  void result();
  double violation(const Eigen::VectorXd& z) const;
  LcpOutcome ray(int entering);

  int n_ = 0, pivots_ = 0;
  double qSize_ = 1.0;
  RowMatrix M_, tableau_;  // columns: w, z, z₀, right side
  RowMatrix basisMatrix_;
  Eigen::VectorXd q_, cover_, scale_, direction_, trial_, residual_;
  std::vector<int> basis_;  // variable of each row: w_i: i, z_i: n + i, z₀: 2n
};

}  // namespace dynamy
