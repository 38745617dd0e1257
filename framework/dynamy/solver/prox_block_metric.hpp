/// ProxBlockMetric: projected Gauss–Seidel with a non-diagonal R.                     (theory 4.9)
///
///   Λ_T ← prox_{C_T}^R (Λ_T − R ξ_T),   R = G_TT⁻¹,   prox^R(z) = argmin (z − x)ᵀR⁻¹(z − x)
///
/// One prox then solves the friction of a contact exactly while all other forces are frozen; the
/// scalar r = 1/λ of the largest eigenvalue converges slowly in the direction of the smallest one.
/// The price is that a disc becomes an ellipse in the metric (convex::MetricEllipsoid). Rejected:
/// one R for the whole contact, normal and tangents, because the set is no product in that metric;
/// exact local solutions serve that case. Groups of two rows whose set is a disc (found by
/// evaluating the law's prox) use this metric, all other rows the diagonal of Relaxation::exact.
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
    double radius = 0.0;   ///< radius at Λ_N = 1, or of the fixed set
    bool coupled = false;  ///< grows with the normal force in row 0
    convex::Matrix<2> R;
    convex::MetricEllipsoid<2> set;  ///< the unit disc in the metric R
  };
  std::vector<Disc> discs_;
  std::vector<int> first_;  // discs of contact i: first_[i] … first_[i+1]
};

}  // namespace dynamy
