/// ProxBlockMetric: projected Gauss–Seidel with a non-diagonal R.                     (theory 4.9)
///
///   Λ_T ← prox_{C_T}^R (Λ_T − R ξ_T),   R = G_TT⁻¹,   prox^R(z) = argmin (z − x)ᵀR⁻¹(z − x)
///
/// The friction of a contact then solves its own problem for the frozen rest in one prox: r = 1/λ
/// of the largest eigenvalue is slow in the direction of the smallest. The price is that a disc
/// becomes an ellipse in the metric (convex::MetricEllipsoid). R of the whole contact, normal and
/// tangents, was rejected: its set is no product in that metric; the exact local solution does
/// that. Groups of two rows whose set is a disc (asked of the law's prox) get the metric, all
/// others the diagonal of Relaxation::exact.
#pragma once
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/solver/prox_solvers.hpp>

namespace dynamy {

class ProxBlockMetric final : public ProxSolver {
 public:
  explicit ProxBlockMetric(const ProxOptions& options = {}) : ProxSolver(options) {}
  explicit ProxBlockMetric(const Parameters& x) : ProxSolver(x, Relaxation::exact) {}
  static void declare(Attributes& a);
  void sweep(const InclusionProblem& problem, const double* r, double* Lambda) override;

 protected:
  void prepare(const InclusionProblem& problem) override;

 private:
  struct Disc {
    int row = 0;           ///< first row within the contact
    double radius = 0.0;   ///< at Λ_N = 1, or of the fixed set
    bool coupled = false;  ///< grows with the normal force in row 0
    convex::Matrix<2> R;
    convex::MetricEllipsoid<2> set;  ///< of the unit disc
  };
  std::vector<Disc> discs_;
  std::vector<int> first_;  // discs of contact i: first_[i] … first_[i+1]
};

}  // namespace dynamy
