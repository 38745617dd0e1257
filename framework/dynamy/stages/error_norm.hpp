/// ErrorNorm: one number for the error of a state with units,
///
///   |e| = max( |δq_i| / (tol s_i), |δu_i| / (tol s_i/T_i) ),   s_i = L for lengths, 1 for angles
///
/// where the value itself replaces its scale if it is larger. L is the length of the scene. T_i is
/// a time of the motion of the island, fixed for a run: the time in which the velocities and
/// accelerations of the start pass through the scales. Islands are systems coupled by joints or
/// two-sided contacts. With one time for all islands, a fast top would loosen the velocities of a
/// slow pendulum beside it. Rejected: weighting velocities with the step size, which loosens them
/// up to 30 times at tight tolerances. Also rejected: the root of the mean square, in which bodies
/// at rest would dilute the error of the moving one.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

/// s_i of positions and velocities: `length` for lengths and their rates, 1 for all others.
void unitScales(const Topology& topology, double length, Eigen::VectorXd& q, Eigen::VectorXd& u);

class ErrorNorm {
 public:
  /// Finds the scales from M, h at x, evaluated in slot `slot`, and from all contacts there, open
  /// ones too.
  void start(const MechanicalSystem& s, const State& x, int slot, double tolerance, double length,
             const ContactSet& contacts);
  /// Restores the scales of a resumed run: T of the scene and of each system as they were.
  void resume(const MechanicalSystem& s, double tolerance, double length, double time,
              ConstVec times);

  double tolerance() const { return tolerance_; }
  double length() const { return length_; }
  double time() const { return time_; }  ///< T, the shortest of all islands [s]
  /// T of the island of each system [s].
  const Eigen::VectorXd& times() const { return times_; }
  double speed() const { return length_ / time_; }  ///< U = L/T [m/s]
  /// s_i of the velocities: u_i/s_i is a rate [1/s].
  const Eigen::VectorXd& velocityScales() const { return u_; }
  /// Error of one position or velocity, in units of the tolerance.
  double position(Eigen::Index i, double error, double value) const;
  double velocity(Eigen::Index i, double error, double value) const;
  /// Largest velocity of coordinates that are not lengths [rad/s].
  double fastestTurn(const Eigen::VectorXd& u) const { return fastestTurn(u, 0, u.size()); }
  /// The same of n velocities from `first` on.
  double fastestTurn(const Eigen::VectorXd& u, Eigen::Index first, Eigen::Index n) const;

 private:
  void scales(const MechanicalSystem& s);
  void speeds(const Topology& topology);
  double tolerance_ = 1e-6, length_ = 1.0, time_ = 1.0;
  Eigen::VectorXd q_, u_;          // s_i of positions, of velocities
  Eigen::VectorXd times_, speed_;  // T of systems; s_i/T_i of velocities
};

}  // namespace dynamy
