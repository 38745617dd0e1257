/// KeptEnergy: steps of fixed length keep the energy of systems in coordinates of joints (theory 39.11).
/// A scheme takes M, the gyroscopic terms k and the levers of forces at q^M; on the way of the step they
/// vary, and T + V is off by
///
///   e = T(q^E, u^E) − T(q^M, u^E) − T(q^A, u^A) + T(q^M, u^A) + Δt k·ū      of these systems
///     + ΔV + Δt f·ū                                                       of forces f with a potential V
///
/// What contacts and joints do cancels, and so do bodies with coordinates of their own. The velocities of
/// these systems are multiplied by √(1 − e/T), which moves them by no more than the error of the step
/// [hairer_lubich_wanner2006, IV.4].
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class KeptEnergy {
 public:
  /// `model` is built.
  explicit KeptEnergy(const Model& model);
  /// Corrects the velocities of `after`, the state that `system` reached from `before` by `report`.
  void keep(const MechanicalSystem& system, const StepReport& report, const State& before,
            State& after);
  /// |e| of the last step over T of these systems at its beginning and end; 0: none was to be kept.
  double error() const { return error_; }

 private:
  double kinetic(const State& x, const std::vector<char>& of);
  double kineticAt(const MassMatrix& mass, const Eigen::VectorXd& u);
  double potential(double t, const State& x);
  double workOfForces(const MechanicalSystem& system, const Eigen::VectorXd& mean);
  void chooseKept(const MechanicalSystem& system);
  void scale(const std::vector<char>& of, bool chosen, Eigen::VectorXd& u, double factor) const;

  const Model& model_;
  std::vector<char> jointed_, kept_;  // per system: in coordinates of joints; to be corrected
  bool any_ = false;
  double error_ = 0.0;
  Kinematics kinematics_;
  MassMatrix mass_;
  State at_;
  Eigen::VectorXd u_, h_, hNonPotential_;
};

}  // namespace dynamy
