/// Standard set-valued laws: bilateral constraint, unilateral contact, unilateral contact with
/// Coulomb friction, friction of given size.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>

namespace dynamy {

/// C = ℝ^dim: γ = 0 in every row. The law of joints.
class Bilateral final : public SetValuedForceLaw {
 public:
  Bilateral() = default;
  explicit Bilateral(const Parameters& x) : SetValuedForceLaw(x) {}
  static void declare(Attributes& a);
  int dim(int geometric) const override { return geometric; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::joint; }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  SimpleSet simpleSet(const LawInput& in) const override;
  Status status(const LawInput&, const double*) const override { return Status::locked; }
};

/// C = ℝ₀⁺ for the normal row.
class Unilateral final : public SetValuedForceLaw {
 public:
  explicit Unilateral(double epsilonN = 0.0) : epsilonN_(epsilonN) {}
  explicit Unilateral(const Parameters& x);
  static void declare(Attributes& a);
  bool isMirrored(const MirrorPlane&) const override { return true; }
  int dim(int) const override { return 1; }
  bool unilateral() const override { return true; }
  RowKind rowKind(int) const override { return RowKind::normal; }
  void epsilon(int dim, double* epsilon) const override;
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  SimpleSet simpleSet(const LawInput& in) const override;
  Status status(const LawInput& in, const double* argument) const override;

 private:
  double epsilonN_;
};

/// Unilateral contact with Coulomb friction: B = disc of radius μ (spatial) or interval [−μ, μ]
/// (planar).
class UnilateralCoulomb : public NormalTimesReservoir {
 public:
  UnilateralCoulomb(double epsilonN, double epsilonT, double mu)
      : epsilonN_(epsilonN), epsilonT_(epsilonT), mu_(mu) {}
  explicit UnilateralCoulomb(const Parameters& x);
  static void declare(Attributes& a);
  bool isMirrored(const MirrorPlane&) const override { return true; }
  int dim(int geometric) const override { return geometric < 3 ? geometric : 3; }
  void epsilon(int dim, double* epsilon) const override;
  void project(const LawInput& in, double N, const double* r, int k, double* x) const override;
  double support(const LawInput& in, int k, const double* y, double* gradient = nullptr,
                 double* hessian = nullptr) const override;
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  void naturalMap(const LawInput& in, double rho, const double* xi, const double* Lambda,
                  double* e) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  SimpleSet simpleSet(const LawInput& in) const override;
  double mu() const { return mu_; }

 protected:
  UnilateralCoulomb(const Parameters& x, double epsilonN, double mu)
      : NormalTimesReservoir(x), epsilonN_(epsilonN), epsilonT_(0.0), mu_(mu) {}

 private:
  double epsilonN_, epsilonT_, mu_;
};

/// Friction of given size: C = disc or interval of radius a·dt; a = static value while sticking,
/// kinetic value while slipping.
class GivenFriction final : public SetValuedForceLaw {
 public:
  GivenFriction(double staticForce, double kineticForce)
      : static_(staticForce), kinetic_(kineticForce) {}
  explicit GivenFriction(const Parameters& x);
  static void declare(Attributes& a);
  int dim(int geometric) const override { return geometric; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  bool scales() const override { return true; }
  int groupEnd(int, int dim) const override { return dim; }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  SimpleSet simpleSet(const LawInput& in) const override;
  Status status(const LawInput& in, const double* argument) const override;

 private:
  double radius(const LawInput& in) const;
  double static_, kinetic_;
};

}  // namespace dynamy
