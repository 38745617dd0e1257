/// EnergyGain: the energy that one step brought in without a cause (theory 37.8).
#pragma once
#include <dynamy/simulation/report/energy_ledger.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class EnergyGain {
 public:
  /// Of the step of length dt [s] that `system` took last, from the state `before` to `after`.
  struct Rise {
    double energy = 0.0;  ///< rise of T + V that no drive and no boundary brought in [J]
    double kineticStart = 0.0, kineticEnd = 0.0;  ///< T [J]
    double share() const { return energy > 0.0 ? energy / (kineticStart + kineticEnd) : 0.0; }
  };
  /// `model` is built.
  explicit EnergyGain(const Model& model) : meter_(model) {}
  Rise rise(const MechanicalSystem& system, const State& before, const State& after, double dt);
  /// Reduces the velocities after an accepted step that gained energy although it is not solved, or damps
  /// forces: such gains feed on themselves. Those of islands that have not taken the step stay. Returns the
  /// energy taken [J].
  double takeBack(const MechanicalSystem& system, const StepReport& report, const State& before,
                  State& after);

 private:
  double potentialAt(double t, const State& x);
  EnergyMeter meter_;
  State at_;
};

}  // namespace dynamy
