/// SmoothMethod: a method for one step of a frozen phase, and the path through it:
///
///   q̇ = F(q,t) u + β,   u̇ = a(t, q, u)  of FrozenPhase
///
/// Components of q are combined one by one; unit quaternions leave their sphere by the local error
/// and are normalised at the end of the step (SmoothStep). The field is smooth off the sphere as
/// well, so that the order is kept. Canonical coordinates of each step were rejected as a default:
/// elements would not have to provide more, but every stage would have to convert.
#pragma once
#include <dynamy/located/phase/frozen_phase.hpp>
#include <dynamy/located/phase/phase_point.hpp>
#include <dynamy/stages/error_norm.hpp>

namespace dynamy {

class SmoothMethod {
 public:
  virtual ~SmoothMethod() = default;
  /// Takes a step of length h from `from`, whose derivatives are known. `to` gets t, q, u; stages
  /// are evaluated in slot 1. False: the phase has a fault, or the step was too long.
  virtual bool take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
                    State& to) = 0;
  /// p of |error| ~ h^p of one step.
  virtual int errorOrder() const = 0;
  /// True: the error needs the derivative at the end of the step, given by end().
  virtual bool errorNeedsEnd() const { return false; }
  virtual void end(const PhasePoint& /*to*/) {}
  /// Error of the last step in units of the tolerance.
  virtual double error(const ErrorNorm& norm, const State& from, const State& to) = 0;
  /// The velocity with the largest share in that error; −1: not known.
  virtual int worst() const { return -1; }
  /// By how much the next step may be longer than the last.
  virtual double mostGrowth() const { return 6.0; }
  /// ∫λ dt and works of the last step, rows as in the phase.
  const Eigen::VectorXd& impulse() const { return impulse_; }
  const std::array<double, 5>& works() const { return works_; }
  /// Length of the last step [s].
  double length() const { return h_; }

  /// Prepares the dense output of the last step, whose end is `to`, by the evaluations it needs.
  virtual bool prepareDense(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from,
                            const PhasePoint& to) = 0;
  virtual void dense(double theta, State& out) const = 0;

 protected:
  Eigen::VectorXd impulse_;
  std::array<double, 5> works_{};
  double h_ = 0.0, t0_ = 0.0;  // length and start of the last step [s]
};

}  // namespace dynamy
