/// ErrorNorm: one number for the error of a state with units,
///
///   |e| = max( |δq_i| / (tol s_i), |δu_i| / (tol s_i/T) ),   s_i = L for lengths, 1 for angles
///
/// beside the size of the value itself where that is larger. L is the length of the scene and T a
/// time of the motion, fixed for a run: how long the velocities and accelerations of the start take
/// to go through it. Weighting velocities with the step size instead was rejected: it loosens them
/// up to 30 times at tight tolerances. The root of the mean square was, too: bodies at rest would
/// dilute the error of the one that moves.
#pragma once
#include <dynamy/integrator/mechanical_system.hpp>

namespace dynamy {

class ErrorNorm {
 public:
  /// Scales from M, h at x, evaluated in slot `slot`.
  void start(const MechanicalSystem& s, const State& x, int slot, double tolerance, double length);
  /// For a resumed run: T as it was.
  void resume(const MechanicalSystem& s, double tolerance, double length, double time);

  double tolerance() const { return tolerance_; }
  double length() const { return length_; }
  double time() const { return time_; }             ///< T [s]
  double speed() const { return length_ / time_; }  ///< U = L/T [m/s]
  /// Error of one position or velocity, in units of the tolerance.
  double position(Eigen::Index i, double error, double value) const;
  double velocity(Eigen::Index i, double error, double value) const;
  /// Largest of the velocities that are not of lengths [rad/s].
  double fastestTurn(const Eigen::VectorXd& u) const;

 private:
  void scales(const MechanicalSystem& s);
  double tolerance_ = 1e-6, length_ = 1.0, time_ = 1.0;
  Eigen::VectorXd q_, u_;  // s_i of positions; of velocities, times T
};

}  // namespace dynamy
