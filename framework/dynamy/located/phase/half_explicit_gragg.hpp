/// HalfExplicitGragg: one step of the extrapolated half-explicit midpoint rule through a frozen
/// phase, the constraint on velocities met at the NEW position of each sub-step (theory 52.4):
///
///   q₁ = q₀ + h q̇₀                        M₀ (u₁ − u₀) = h (h₀ + W₀ λ₀)
///   q_{k+1} = q_{k−1} + 2h q̇_k            M_k (u_{k+1} − u_{k−1}) = 2h (h_k + W_k λ_k)
///   W(q_{k+1})ᵀ u_{k+1} + χ = 0  in the held rows,   T_{j,1} = (q_n, u_n),  n = 2j
///
/// Its error has even powers of h alone, with friction too: k columns have order 2k. The rule
/// requires no bias γ̇ − Wᵀu̇, and held rows do not move at the end of any column. Each sub-step
/// evaluates M, h and contacts once, and contacts alone once more; a step takes k² evaluations, and
/// one at its start. Rejected: constraints at q_k, which leave odd powers (Moreau's midpoint rule,
/// theory 51.4).
#pragma once
#include <algorithm>
#include <dynamy/located/phase/smooth_method.hpp>
#include <dynamy/stages/bias_differences.hpp>

namespace dynamy {

class HalfExplicitGragg final : public SmoothMethod {
 public:
  static constexpr int kMostColumns = 4;
  /// `plain`: q̇ = u in all systems.
  void prepare(bool plain) { plain_ = plain; }
  /// Number of columns of the extrapolation from now on; 0: the method is not used.
  void columns(int n) { columns_ = n; }
  int columns() const { return columns_; }
  /// Uses slots 0 and 1.
  bool take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
            State& to) override;
  int errorOrder() const override { return std::max(1, 2 * columns_ - 1); }
  /// Difference of the last two columns in units of the tolerance.
  double error(const ErrorNorm& norm, const State& from, const State& to) override;
  /// The dense output is the quintic through both ends.
  bool prepareDense(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from,
                    const PhasePoint& to) override;
  void dense(double theta, State& out) const override { through_.at(theta, out); }

 private:
  bool column(MechanicalSystem& s, FrozenPhase& phase, const State& from, int n);
  void rate(const MechanicalSystem& s, const State& x);
  const Eigen::VectorXd& best() const { return T_[static_cast<std::size_t>(columns_ - 1)]; }
  std::array<Eigen::VectorXd, kMostColumns> T_;  // q, u, ∫λ dt, works; extrapolated in place
  Eigen::VectorXd error_, qdot_, a_;
  State past_, now_, next_;
  EvaluationRequest stages_;  // of the present step
  ContactLook look_;
  Eigen::Index nq_ = 0, nu_ = 0, rows_ = 0;
  int columns_ = 0;
  QuinticPath through_;
  bool plain_ = false;
};

}  // namespace dynamy
