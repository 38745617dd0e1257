/// EnergyLedger: where the energy of a run went.
///
/// The step M(u^E − u^A) = hΔt + WΛ times ū = (u^A + u^E)/2 is exact, row by row:
///
///   ½u^EᵀMu^E − ½u^AᵀMu^A = Δt h·ū + Σ_rows Λ (γ̄ − χ),     γ̄ = (γ^A + γ^E)/2
///
/// so the works below are those of the discrete equations, not quadratures. The change of T + V
/// that these works do not explain is the entry `discretisation`: it falls with the order of the
/// scheme. Potentials and masses that depend on time contribute to it as well. Since the
/// differences of T and V telescope, T and V are needed only at the start and the end. All sums are
/// compensated.
#pragma once
#include <dynamy/core/compensated_sum.hpp>
#include <dynamy/simulation/model/observer.hpp>

namespace dynamy {

/// All in [J].
struct EnergyReport {
  double kineticStart = 0.0, potentialStart = 0.0, kineticEnd = 0.0, potentialEnd = 0.0;
  double nonPotential = 0.0;  ///< work of forces without potential (drives, dampers): Δt h_np·ū
  double friction = 0.0;      ///< Σ Λγ̄ of friction rows
  double normal = 0.0;        ///< Σ Λγ̄ of normal rows: impacts
  double joints = 0.0;        ///< Σ Λγ̄ of joint rows
  double boundaries = 0.0;    ///< −Σ Λχ: what moving ground and driven joints brought in
  double discretisation = 0.0;   ///< what remains of the change of T + V
  double imbalance = 0.0;        ///< defect of the step equations: rounding
  double largestGain = 0.0;      ///< largest positive work of all contacts in one step
  double largestGainTime = 0.0;  ///< [s]
  /// Part of `normal` and `joints` that steps in time of a run to a tolerance booked. Neither kind of
  /// row stores energy: where this sum rises, the step itself brought it in.
  double stepped = 0.0;

  double start() const { return kineticStart + potentialStart; }
  double end() const { return kineticEnd + potentialEnd; }
  double works() const { return nonPotential + friction + normal + joints + boundaries; }
  void archive(Archive& a);
};

/// Computes T and V of any state, with workspaces of its own.
class EnergyMeter {
 public:
  explicit EnergyMeter(const Model& model);
  double kinetic(const State& x);
  double potential(const State& x);

 private:
  const Model& model_;
  Kinematics kinematics_;
  MassMatrix mass_;
};

class EnergyLedger final : public Observer {
 public:
  explicit EnergyLedger(const Model& model) : model_(model), meter_(model) {}
  const EnergyReport& report() const { return report_; }
  /// The ledger from the start up to `x`, the state after the last step.
  EnergyReport upTo(const State& x);

  void start(const StepView& initial) override;
  void step(const StepView& view) override;
  /// Books the energy of blocks that were added and removed between two steps as work of the
  /// boundaries.
  void bring(const State& before, const State& after);
  /// Books energy that a change of state between two steps takes [J], as bring() does.
  void take(double energy) { boundaries_.add(-energy); }
  void finish(const StepView& last) override;
  void archive(Archive& a) override;

 private:
  void add(const StepWorks& w);
  void addInStep(const StepView& view, const StepWorks& w);
  void addJump(const StepView& view);
  void leaveApart(const StepView& view);
  bool isApart(const ContactSet& c, int contact) const;
  double contactWork(const StepView& view);
  const Model& model_;
  EnergyMeter meter_;
  EnergyReport report_;
  CompensatedSum nonPotential_, friction_, normal_, joints_, boundaries_, imbalance_, stepped_;
  Eigen::VectorXd uA_, uE_, uMean_, momentum_;
  std::vector<char> apart_;     // 1: velocity of a system apart; empty: none
  std::vector<double> gammaA_;  // γ after a jump [m/s]
};

}  // namespace dynamy
