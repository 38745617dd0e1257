/// ResolutionWatch: how well steps of given length resolve the motion:
///
///   resolution  (ωΔt)² = √(Σ|Δ²u|²_M / Σ(|u|²_M + |Δt M⁻¹h|²_M)) over steps without a change of
///               contacts: an oscillation of ω has Δ²u = −(ωΔt)² u
///   fall        ½ Δt² |M⁻¹h|, the distance that the forces alone cause in a step; a turn by 1 rad
///               counts as the scene's length
/// A motion that is no more than rounding has no ωΔt.
#pragma once
#include <dynamy/simulation/model/observer.hpp>
#include <dynamy/simulation/report/run_report.hpp>

namespace dynamy {

class ResolutionWatch {
 public:
  /// `model` is built. Results go to report.trust, which outlives the watch.
  ResolutionWatch(const Model& model, RunReport& report);
  /// Examines a step. Returns the energy that forces alone give in it [J]; 0 if the step takes only
  /// a part of the forces.
  double step(const StepView& view);
  /// The present step is not examined: increments of the velocity begin anew with the next one.
  void skip() { smooth_ = -1; }
  /// Computes ωΔt at the end of a run.
  void finish();
  /// Throws ModelError if the checkpoint has another number of velocities.
  void archive(Archive& a);

 private:
  RunReport& report_;
  long switches_ = 0, impacts_ = 0;  // of the report, at the last step examined
  int smooth_ = 0;                   // steps without a change of contacts, in a row
  double curvature_ = 0.0, speed_ = 0.0;
  Eigen::VectorXd increment_, before_, momentum_;
  Eigen::VectorXd perUnit_;  // of velocities: distance per unit [m]
};

}  // namespace dynamy
