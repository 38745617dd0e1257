/// KeptEnergy: steps of fixed length keep the energy of systems in coordinates of joints (theory 39.11).
/// A scheme takes M and the gyroscopic terms k at q^M; on the way of the step they vary, and T of a
/// system is off by
///
///   e = T(q^E, u^E) − T(q^M, u^E) − T(q^A, u^A) + T(q^M, u^A) + Δt k(q^M, ū)·ū
///
/// Forces, contacts and joints have done their work exactly: it is that of M(q^M)(u^E − u^A). The
/// velocities of the system are multiplied by √(1 − e/T), which moves them by no more than the error of
/// the step [hairer_lubich_wanner2006, IV.4]. Each system is corrected by itself.
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
  /// Σ|e| of the last step over T of these systems at its beginning and end; 0: none was to be kept.
  double error() const { return error_; }

 private:
  struct Jointed {
    int system = 0;
    bool driven = false;  ///< a drive or a moving boundary prescribes velocities, which are to hold
    double e = 0.0, kineticA = 0.0, kineticE = 0.0;  ///< [J]
  };
  void addEnds(const State& before, const State& after);
  void findDriven(const ContactSet& c);
  void setGyroscopic(const Evaluation& at);

  const Model& model_;
  std::vector<Jointed> jointed_;
  double error_ = 0.0;
  MassMatrix mass_;  // at the ends of the step
  Eigen::VectorXd gyroscopic_, unused_;
};

}  // namespace dynamy
