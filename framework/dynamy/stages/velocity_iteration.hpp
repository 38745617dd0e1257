/// VelocityIteration: convergence test, in velocities, for the fixed-point or Newton iteration of
/// an implicit scheme.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

class VelocityIteration {
 public:
  explicit VelocityIteration(int most) : most_(most) {}
  /// Takes the largest change of this iteration and the size of the velocities [m/s]; true: the
  /// iteration ends. A change that no longer falls is accepted if it is rounding of large forces,
  /// or moves nothing by more than a part of g_tol. Otherwise iterations run out and the report
  /// contains this status.
  bool done(const MechanicalSystem& s, double change, double size, double dt, SolveReport& report) {
    const bool stalls = turn_ > 4 && change > 0.5 * before_;
    const bool small = change <= kSmall * size || change * dt <= kPosition * s.gTol();
    if (change <= kConverged * size || (stalls && small)) return true;
    before_ = change;
    if (turn_++ < most_) return false;
    report.status = SolveStatus::maxIterations;
    return true;
  }

 private:
  static constexpr double kConverged = 1e-13, kSmall = 1e-9;  // of the size of u
  static constexpr double kPosition = 0.1;                    // of g_tol
  int most_ = 0, turn_ = 0;
  double before_ = 0.0;
};

}  // namespace dynamy
