#include <algorithm>
#include <cmath>
#include <dynamy/simulation/report/turning_frames.hpp>
#include <dynamy/simulation/run/step_coarseness.hpp>

namespace dynamy {

StepCoarseness::StepCoarseness(const Model& model)
    : turning_(turningFrames(model)), length_(model.length()) {}

Coarseness StepCoarseness::of(const MechanicalSystem& system, double dt) const {
  const Kinematics& k = system.slot(0).kinematics;
  double square = 0.0;  // of the fastest body's rate [rad²/s²]
  for (const FrameHandle f : turning_) square = std::max(square, k.frame(f).Omega_I.squaredNorm());
  return Coarseness::of(std::sqrt(square) * dt, system.implicitForces().share(),
                        newOverlap(system, dt) / length_);
}

/// Largest overlap that the step brought about where it solved for its contacts [m].
double StepCoarseness::newOverlap(const MechanicalSystem& system, double dt) const {
  const ContactSet& c = system.slot(0).contacts;
  const std::vector<double>& gammaA = system.problem().gammaA;
  if (gammaA.size() != static_cast<std::size_t>(c.rows())) return 0.0;
  double worst = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const auto row = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)]);
    if (c.law[static_cast<std::size_t>(i)]->unilateral())
      worst = std::max(worst, std::min(-c.position[row], -gammaA[row] * dt));
  }
  return worst;
}

}  // namespace dynamy
