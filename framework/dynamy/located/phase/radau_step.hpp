/// RadauStep: one step of the Radau IIA method of order 5 through a frozen phase, for forces that
/// are stiff [hairer_wanner1996, IV.8]. With y = (q, u), y' = f(t, y) of SmoothStep:
///
///   z_i = h Σ_j a_ij f(t + c_j h, y + z_j),   i = 1, 2, 3,   y⁺ = y + z₃
///
/// by Newton's method with one Jacobian ∂f/∂y at the start of the step. With A⁻¹ = T Λ T⁻¹ its
/// equations separate into a real and a complex system, each with as many unknowns as y. The
/// Jacobian is kept while each Newton iteration reduces the change to a thousandth. kept() reports
/// where it was taken, so that a resumed run takes it there again.
#pragma once
#include <array>
#include <dynamy/located/phase/stiff_jacobian.hpp>

namespace dynamy {

class RadauStep {
 public:
  using Field = StiffJacobian::Field;
  using Place = StiffJacobian::Place;
  /// Sets the norm of changes: a change d of y_i counts |d|/(tolerance max(scale_i, |y_i|)).
  void prepare(const Eigen::VectorXd& scale, double tolerance) {
    scale_ = scale, tolerance_ = tolerance;
  }
  /// Takes a step from (t, y), with y' = f and y'' (or a guess of it) given. `same`: the last call
  /// began at this y, too. False: Newton's method does not converge, or a number is not finite.
  bool take(const Field& field, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& f,
            const Eigen::VectorXd& second, double h, bool same);
  /// Place of the Jacobian that the next step begins with; null: the next step takes a new one.
  const Place* kept() const { return jacobian_.known() && keeps_ ? &jacobian_.place() : nullptr; }
  /// Takes the Jacobian at `place`, for the next step.
  bool keep(const Field& field, const Place& place);
  /// Drops the Jacobian: the next step takes a new one.
  void forget() { jacobian_.forget(); }
  /// Iterations of Newton's method in the last step; tookJacobian(): whether it took a Jacobian.
  int iterations() const { return iterations_; }
  bool tookJacobian() const { return tookJacobian_; }
  const Eigen::VectorXd& end() const { return end_; }
  /// Error of the last step in units of the tolerance; evaluates f once more if it is above 1.
  double error(const Field& field);
  /// Largest |eigenvalue| of the Jacobian: within some 20 % [1/s].
  double fastest() const;
  /// y on the path through the stages, 0 ≤ θ ≤ 1.
  void dense(double theta, Eigen::VectorXd& y) const;

 private:
  bool takeJacobian(const Field& field, const Place& at);
  /// `contraction`: ratio of the last two changes.
  bool newton(const Field& field, const Eigen::VectorXd& second, double& contraction);
  void correct();
  double measure(const Eigen::VectorXd& change) const;
  Eigen::VectorXd scale_;
  double tolerance_ = 1e-6;
  Place from_;  // where the step begins
  double h_ = 0.0;
  Eigen::VectorXd end_;
  StiffJacobian jacobian_;
  bool keeps_ = false, tookJacobian_ = false;
  int iterations_ = 0;
  std::array<Eigen::VectorXd, 3> z_, w_, F_;
  Eigen::VectorXd work_, change_;
  Eigen::VectorXcd pair_;
};

}  // namespace dynamy
