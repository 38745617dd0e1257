#include <algorithm>
#include <cmath>
#include <dynamy/simulation/report/start_overlap.hpp>
#include <dynamy/simulation/report/turning_frames.hpp>
#include <dynamy/simulation/run/step_coarseness.hpp>

namespace dynamy {

StepCoarseness::StepCoarseness(const Model& model)
    : gain_(model),
      turning_(turningFrames(model)),
      length_(model.length()),
      smallest_(smallestBody(model)) {}

Coarseness StepCoarseness::of(const MechanicalSystem& system, const State& before,
                              const State& after, double dt, double corrected) {
  const Kinematics& k = system.slot(0).kinematics;
  double square = 0.0;  // of the fastest body's rate [rad²/s²]
  for (const FrameHandle f : turning_) square = std::max(square, k.frame(f).Omega_I.squaredNorm());
  return Coarseness::of(std::sqrt(square) * dt, system.implicitForces().resolution(),
                        newOverlap(system, after, dt) / length_,
                        foreseenOverlap(system, after, dt) / smallest_,
                        gain(system, before, after, dt), corrected);
}

/// Energy that a step brought in that damps forces, over T at its beginning and end. Their
/// tangent at the beginning, with which they are damped, does not hold where they turn.
double StepCoarseness::gain(const MechanicalSystem& system, const State& before, const State& after,
                            double dt) {
  if (system.implicitForces().damped() == 0 || !after.u.allFinite()) return 0.0;
  return gain_.rise(system, before, after, dt).share();
}

/// Largest overlap to which a rough step leads, at the place where the next one of its length
/// solves for its contacts [m].
double StepCoarseness::foreseenOverlap(const MechanicalSystem& system, const State& after,
                                       double dt) {
  if (system.problem().corrected != Corrected::byGapsLoosely || !after.u.allFinite()) return 0.0;
  next_ = after;
  system.move(next_, 0.5 * dt);
  const ContactSet& c = look_.at(system, next_);
  const auto rows = static_cast<std::size_t>(c.rows());
  if (rows == 0) return 0.0;
  gammaE_.resize(rows);
  c.gamma(view(after.u), {gammaE_.data(), static_cast<Eigen::Index>(rows)});
  double worst = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const auto row = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)]);
    // What has been there before is being pushed out.
    const double overlap = std::min(-c.position[row], -dt * gammaE_[row]);
    if (overlap > worst && c.law[static_cast<std::size_t>(i)]->unilateral()) worst = overlap;
  }
  return worst;
}

/// Largest overlap that the step brought about, where it solved for its contacts or at its end [m].
double StepCoarseness::newOverlap(const MechanicalSystem& system, const State& after, double dt) {
  const ContactSet& c = system.slot(0).contacts;
  const auto rows = static_cast<std::size_t>(c.rows());
  const std::vector<double>& gammaA = system.problem().gammaA;
  if (rows == 0 || gammaA.size() != rows) return 0.0;
  gammaE_.resize(rows);
  c.gamma(view(after.u), {gammaE_.data(), static_cast<Eigen::Index>(rows)});
  const double rest = after.t - system.slot(0).t;
  double worst = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    const auto row = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)]);
    const double solved = -c.position[row], atEnd = solved - rest * gammaE_[row];
    const double way = dt * std::max(-gammaA[row], -gammaE_[row]);
    const double overlap = std::min(std::max(solved, atEnd), way);
    if (overlap > worst && c.law[static_cast<std::size_t>(i)]->unilateral()) worst = overlap;
  }
  return worst;
}

}  // namespace dynamy
