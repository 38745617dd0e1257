/// StiffJacobian: J = ∂f/∂y of y' = f(t, y) at one place, and the factors of a step of length h
/// with the Radau IIA method of order 5:
///
///   γ/h − J,   (α + iβ)/h − J
///
/// J is taken by differences of the motion that held contacts constrain: elements need not provide
/// derivatives.
#pragma once
#include <dynamy/core/decompositions.hpp>
#include <functional>

namespace dynamy {

class StiffJacobian {
 public:
  /// Evaluates f(t, y) at stage number `stage` (−1: for the Jacobian); false: that is impossible.
  using Field =
      std::function<bool(double t, const Eigen::VectorXd& y, int stage, Eigen::VectorXd& f)>;
  /// Where a Jacobian is taken: t, y and y'.
  struct Place {
    double t = 0.0;
    Eigen::VectorXd y, f;
  };
  /// Takes J at `at`; `scale`: a size of each y_i. False: f cannot be evaluated there, or is not
  /// finite.
  bool take(const Field& field, const Place& at, const Eigen::VectorXd& scale);
  /// Drops J: known() is false until the next take().
  void forget() { known_ = false; }
  bool known() const { return known_; }
  const Place& place() const { return place_; }
  /// Factors the matrices of a step of length h.
  void factor(double h);
  /// x = (γ/h − J)⁻¹ b.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { real_.solve(b, x); }
  /// ((α + iβ)/h − J)⁻¹ b.
  Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const { return complex_.solve(b); }
  /// Largest |eigenvalue| of J, by the power method from v on: within some 20 % [1/s].
  double fastest(Eigen::VectorXd v) const;

 private:
  Eigen::MatrixXd J_;
  Lu real_;
  ComplexLu complex_;
  Place place_;
  Eigen::VectorXd moved_, f_;
  double h_ = 0.0;  // of the factors; 0: none
  bool known_ = false;
};

}  // namespace dynamy
