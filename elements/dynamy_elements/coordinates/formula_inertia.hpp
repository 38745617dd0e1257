/// FormulaInertia: the mass matrix of a system of Coordinates by formulas, and the gyroscopic forces
/// that belong to it.
///
///   M(q,t) given:    M,                 h_gyr = −Ṁu + ½ ∂(uᵀMu)/∂q
///   T(q,u,t) given:  M = ∂²T/∂u²,       h_gyr = ∂T/∂q − (∂t + u·∂q) ∂T/∂u
///
/// In all functions x = (t, q, u) are the arguments of the formulas, and w = (1, u, 0) is the
/// direction of the motion.
#pragma once
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy_elements/coordinates/formula_text.hpp>
#include <memory>

namespace dynamy {

class FormulaInertia {
 public:
  /// Compiles the attribute M or kineticEnergy; faults go to `faults`. Throws ModelError if M is
  /// not symmetric, or T not quadratic in u, near q0, u0.
  void compile(const Parameters& x, const FormulaNames& names, const Eigen::VectorXd& q0,
               const Eigen::VectorXd& u0, Diagnostics& faults);
  /// True: T is given.
  bool byEnergy() const { return kind_ == Kind::energy; }
  /// True: M depends on neither t nor q.
  bool constant() const { return constant_; }
  /// Sets M; u in x must be zero.
  void mass(const double* x, Block M) const;
  /// h += factor · h_gyr.
  void addGyroscopic(double factor, const double* x, const double* w, Vec h) const;
  /// First instant after t at which a formula jumps or has a kink [s].
  double nextInstant(double t) const { return tape_->nextInstant(t); }

 private:
  enum class Kind { full, upper, energy };  // all entries of M, its upper triangle, T
  void check(const FormulaText& text, const FormulaNames& names, const Eigen::VectorXd& q0,
             const Eigen::VectorXd& u0) const;
  double entry(const double* values, int i, int j) const;
  void addGyroscopicOfT(double factor, const double* x, const double* w, Vec h) const;
  void addGyroscopicOfM(double factor, const double* x, const double* w, Vec h) const;

  Kind kind_ = Kind::full;
  bool constant_ = false;
  int n_ = 0;
  std::vector<int> q_, u_;  // slots
  std::unique_ptr<Tape> tape_;
  mutable std::vector<double> unit_;  // a unit vector
};

}  // namespace dynamy
