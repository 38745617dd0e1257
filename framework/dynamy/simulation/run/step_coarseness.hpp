/// StepCoarseness: measures how coarse an attempted step is for the motion.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/run/energy_gain.hpp>
#include <dynamy/simulation/run/step_division.hpp>
#include <dynamy/stages/contact_look.hpp>

namespace dynamy {

class StepCoarseness {
 public:
  /// `model` is built.
  explicit StepCoarseness(const Model& model);
  /// Of the step of length dt [s] that `system` took last, from the state `before` to `after`, with
  /// the error of T that KeptEnergy corrected.
  Coarseness of(const MechanicalSystem& system, const State& before, const State& after, double dt,
                double corrected);

 private:
  double gain(const MechanicalSystem& system, const State& before, const State& after, double dt);
  double newOverlap(const MechanicalSystem& system, const State& after, double dt);
  double foreseenOverlap(const MechanicalSystem& system, const State& after, double dt);
  ContactLook look_;  // at the place of the next step
  EnergyGain gain_;
  State next_;
  std::vector<FrameHandle> turning_;
  std::vector<double> gammaE_;
  double length_, smallest_;  // of the scene, and size of its smallest body [m]
};

}  // namespace dynamy
