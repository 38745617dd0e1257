/// SmoothStep: one step of a frozen phase, and the paths through it: explicit Runge–Kutta, implicit
/// (RadauStep) while the motion is stiff, half-explicit (HalfExplicitGragg) where an element
/// reports no bias.
///
///   q̇ = F(q,t) u + β,   u̇ = a(t, q, u)  of FrozenPhase
///
/// Stages are combined componentwise in q; unit quaternions leave their sphere by the local error
/// and are normalised at the end of the step. The field is smooth off the sphere as well, so that
/// the order is kept. Canonical coordinates of each step were rejected as a default: elements would
/// not have to provide more, but every stage would have to convert.
#pragma once
#include <algorithm>
#include <dynamy/located/phase/butcher_tableau.hpp>
#include <dynamy/located/phase/frozen_phase.hpp>
#include <dynamy/located/phase/half_explicit_gragg.hpp>
#include <dynamy/located/phase/radau_step.hpp>
#include <dynamy/stages/error_norm.hpp>

namespace dynamy {

/// q̇ of all systems at x.
void configurationRate(const Topology& topology, const State& x, Eigen::VectorXd& qdot);

/// A state with its derivatives in the present phase.
struct PhasePoint {
  State x;
  Eigen::VectorXd qdot, qddot, a;
  Eigen::VectorXd lambda;         ///< rows of the phase [N]
  std::array<double, 5> power{};  ///< as FrozenPhase::power [W]
};

/// Quintic through positions, velocities and accelerations of two points; it needs no evaluation.
class QuinticPath {
 public:
  void through(const MechanicalSystem& s, const PhasePoint& from, const PhasePoint& to);
  void at(double theta, State& out) const;
  double length() const { return h_; }

 private:
  const PhasePoint *from_ = nullptr, *to_ = nullptr;
  double h_ = 0.0;
  bool derivative_ = false;  // u = q̇ in all systems
};

class SmoothStep {
 public:
  /// `light`: a method of half the work for simple motions, or null.
  void prepare(const MechanicalSystem& s, const ButcherTableau& table,
               const ButcherTableau* light = nullptr);
  /// Makes steps implicit from now on, or explicit again; `norm` measures the changes of Newton's
  /// method.
  void implicit(bool wanted, const MechanicalSystem& s, const ErrorNorm& norm);
  bool implicit() const { return implicit_; }
  /// Makes explicit steps half-explicit with this number of columns; 0: by the table again.
  void halfExplicit(int columns) { columns_ = columns; }
  bool halfExplicit() const { return columns_ > 0 && !implicit_; }
  /// p of |error| ~ h^p of one step.
  int errorOrder() const {
    return implicit_ ? 4 : columns_ > 0 ? std::max(1, 2 * columns_ - 1) : table_->order;
  }
  /// By how much the next step may be longer than the last.
  double mostGrowth() const;
  /// Examines an accepted step with the end `to`: true if the other kind of method should take
  /// over. Explicit: h |λ| has been at the bound of stability for many steps. Implicit: h |λ| has
  /// been small for some steps, or the steps cost more than the explicit ones before them.
  bool outgrown(const ErrorNorm& norm, const PhasePoint& to);
  /// Takes explicit steps with the light method from now on, or with the full one again.
  void light(bool wanted) { table_ = wanted && light_ ? light_ : full_; }
  bool light() const { return table_ == light_; }
  /// Called for a step that a switch shortens: the light method takes over if its error in the
  /// longer step would have been far below the tolerance.
  void lighten() {
    if (!implicit_ && !tookHalf_ && !light() && lighter_ <= enough_) light(true);
  }
  /// True: the last step, with this error, was taken by the light method and has to be repeated by
  /// the full one.
  bool tooLight(double error);
  /// Counters of `outgrown` and `tooLight`, to be kept with a state.
  using Counted = std::array<double, 7>;
  Counted counted() const {
    return {stiff_, other_, tried_, rate_, patience_, light() ? 1.0 : 0.0, enough_};
  }
  /// Resets all counters at the beginning of a motion.
  void forget() { counted({0.0, 0.0, 0.0, 0.0, 1.0, 0.0, kEnough}); }
  void counted(const Counted& n) {
    stiff_ = n[0], other_ = n[1], tried_ = n[2], rate_ = n[3], patience_ = std::max(1.0, n[4]);
    light(n[5] != 0.0), enough_ = n[6];
  }
  /// Place where the Jacobian of the next implicit step was taken, as numbers; empty: none. keep()
  /// of another SmoothStep takes the Jacobian there again, in slot 1.
  Eigen::VectorXd kept() const;
  void keep(MechanicalSystem& s, FrozenPhase& phase, const State& x, const Eigen::VectorXd& place);
  /// Drops the Jacobian, since the phase has changed: the next implicit step takes a new one.
  void forgetJacobian() { radau_.forget(), y_.resize(0); }
  /// True: q̇ = u in all systems.
  bool plain() const { return plain_; }
  /// q̇ and q̈ of a point whose x and a are known.
  void rates(const MechanicalSystem& s, PhasePoint& p) const;

  /// Takes a step of length h from `from`, whose derivatives are known. `to` gets t, q, u; stages
  /// are evaluated in slot 1. False: the phase has a fault, or numbers are not finite.
  bool take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h, State& to);
  /// Sets the derivative at the end of the last step, which the error estimate of order 5 needs.
  void end(const PhasePoint& to) {
    Q_.col(table_->stages) = to.qdot, U_.col(table_->stages) = to.a;
  }
  bool errorNeedsEnd() const { return !implicit_ && columns_ == 0 && table_->error3 == nullptr; }
  /// Error of the last step in units of the tolerance.
  double error(const ErrorNorm& norm, const State& from, const State& to);
  /// The velocity with the largest share in that error; −1: not known.
  int worst() const { return worst_; }
  /// ∫λ dt and works of the last step, rows as in the phase.
  const Eigen::VectorXd& impulse() const { return impulse_; }
  const std::array<double, 5>& works() const { return works_; }

  /// Prepares the dense output of the last step, whose end is `to`, by the evaluations it needs.
  bool prepareDense(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from,
                    const PhasePoint& to);
  void dense(double theta, State& out) const;
  double length() const { return h_; }

 private:
  bool stage(MechanicalSystem& s, FrozenPhase& phase, int i);
  void combine(const PhasePoint& from, int row, State& out) const;
  bool takeImplicit(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
                    State& to);
  RadauStep::Field field(MechanicalSystem& s, FrozenPhase& phase);
  double implicitWork(Eigen::Index unknowns, int iterations, bool jacobian) const;
  double stretch(const ErrorNorm& norm, const Eigen::VectorXd& dq, const Eigen::VectorXd& du) const;
  bool finish(const MechanicalSystem& s, State& to) const;
  static constexpr double kEnough = 1e-2;
  const ButcherTableau *table_ = nullptr, *full_ = nullptr, *light_ = nullptr;
  // Error of the embedded method of order 5 in the last step of order 8; and the error that counts
  // as far below the tolerance, lowered each time that the light method was too inaccurate.
  double lighter_ = 0.0, enough_ = kEnough;
  bool plain_ = false;
  int worst_ = -1;
  double h_ = 0.0;
  State stage_;
  Eigen::MatrixXd Q_, U_;  // derivatives of stage i in column i
  Eigen::VectorXd impulse_;
  std::array<double, 5> works_{};
  std::array<Eigen::VectorXd, 8> denseQ_, denseU_;
  double t0_ = 0.0;
  // Implicit steps; y_ = (q, u) and f_ = y' where the last one began.
  bool implicit_ = false, tookImplicit_ = false, failed_ = false;
  // Half-explicit steps; their dense output is the quintic through both ends.
  int columns_ = 0;
  bool tookHalf_ = false;
  HalfExplicitGragg half_;
  QuinticPath through_;
  // Steps at a bound, and other steps; implicit steps since the last change of method; work per
  // time of the explicit steps before it [1/s]; factor on the number of steps that a change
  // requires.
  double stiff_ = 0.0, other_ = 0.0, tried_ = 0.0, rate_ = 0.0, patience_ = 1.0;
  RadauStep radau_;
  double radauError_ = 0.0;
  Eigen::VectorXd y_, f_, yNew_, fNew_;
  std::array<Eigen::VectorXd, 3> stageLambda_;
  std::array<std::array<double, 5>, 3> stagePower_{};
};

}  // namespace dynamy
