/// EnergyWatch: energy that appears or vanishes without a cause, sampled along a run:
///
///   error       e(t) = |ΔT + ΔV − works + joints|, summed over intervals without an impact,
///               because some schemes book the loss of an impact in this term alone. What steps
///               lose by damping forces h_d that they do not resolve, −(Δt h_d·ū + ΔV_d) (37.4), is
///               counted by itself in the same intervals (RunTrust::dampedLoss): that is what
///               damping is for. Where such forces gain, the gain is error
///   rise        rise(t) = (T + V) − start − the work of drives and boundaries
///   gain        the least of rise(t) and of the energy that the scheme itself brought in, each
///               above its lowest value so far. Losses in impacts then do not hide later gains, and
///               laws that store energy may give it back
///   rounding    r = max((64 + N) ε, 1e-11) (max T + max|V| + Σ|works|) + ε ½ sᵀM s/t²: the error
///               of the energies by rounding in N steps and by positions known to g_tol, and
///               the energy of a motion by √ε of the scene's length s (1 rad for angles) until
///               the end t. Only what the others exceed r by counts
///
/// All are compared with the largest T (RunTrust::energyScale, gainScale).
#pragma once
#include <dynamy/simulation/report/run_report.hpp>
#include <dynamy/system/kinematics.hpp>

namespace dynamy {

class EnergyWatch {
 public:
  /// `ledger` has seen every step before it is sampled; results go to report.trust. Both outlive
  /// the watch.
  EnergyWatch(EnergyLedger& ledger, RunReport& report) : ledger_(ledger), report_(report) {}
  /// `initial`: view of the initial state, evaluated.
  void start(const StepView& initial);
  /// In the present step forces alone give this energy [J].
  void forcesGive(double energy) { sinceLeast_ = std::max(sinceLeast_, energy); }
  /// Adds what the step lost by damping forces.
  void damped(const StepView& view);
  /// Compares the energies at the end of the step.
  void sample(const StepView& view);
  void archive(Archive& a);

 private:
  bool diverges(const EnergyReport& e, double rise) const;
  void rounding(const EnergyReport& e);
  double potential(const StepView& view, const State& x);
  EnergyLedger& ledger_;
  RunReport& report_;
  double sampled_ = 0.0, unexplained_ = 0.0;
  // Lowest values so far of rise(t) and of the energy that the scheme itself brought in [J].
  double least_ = 0.0, leastOwn_ = 0.0;
  double sinceLeast_ = 0.0;  // largest energy that forces gave in a step since then [J]
  long sampledImpacts_ = 0;
  // Lost by damping since the last sample, and in all intervals without an impact [J].
  double sampledDamped_ = 0.0, damped_ = 0.0;
  Kinematics kinematics_;
  double inertia_ = 0.0;  // ½ sᵀM s/t² [J]
  double moves_ = 0.0;    // largest T + |V| + Σ|works| [J]
};

}  // namespace dynamy
