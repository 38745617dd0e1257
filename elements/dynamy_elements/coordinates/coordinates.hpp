/// Coordinates: a mechanical system in minimal coordinates of its own, written as formulas.
///
///   M(q,t) u̇ = h(q,u,t) − ∂V/∂q,   q̇ = u                                   (M and h given)
///   T(q,u,t):  M = ∂²T/∂u²,   h_gyr = ∂T/∂q − (∂t + u·∂q) ∂T/∂u            (T given: Lagrange)
///
/// All derivatives are exact: directional derivatives of the tapes
/// (core/expression/expression.hpp). Rejected: difference quotients, which lose half of the digits,
/// and symbolic results written to a source file, which require a compiler beside the model.
#pragma once
#include <dynamy/system/partial_mechanical_system.hpp>
#include <dynamy_elements/coordinates/coordinate_frame.hpp>
#include <dynamy_elements/coordinates/coordinate_jump.hpp>
#include <dynamy_elements/coordinates/formula_inertia.hpp>
#include <optional>

namespace dynamy {

/// Formulas can use t, the coordinates q, their velocities q_dot and the
/// parameters of the model. An object must be evaluated in one thread at a time,
/// since it owns the registers of its formulas.
class Coordinates final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a);
  /// Throws ModelError with all faults of all formulas.
  explicit Coordinates(const Parameters& x);
  ~Coordinates() override;

  Blocks blocks() const override;
  void initialState(Vec q, Vec u) const override;
  void M(double t, ConstVec q, MassBlocks M) const override;
  void h(double t, ConstVec q, ConstVec u, Vec h) const override;
  double potentialEnergy(double t, ConstVec q) const override;
  void nonPotentialForce(double t, ConstVec q, ConstVec u, Vec h) const override;
  void frame(double t, ConstVec q, ConstVec u, int id, Frame& out) const override;
  int frames() const override { return static_cast<int>(frames_.size()); }
  Abilities abilities() const override { return {.renewable = jumps_.empty() ? nullptr : &jumps_}; }
  bool stiff() const override { return stiff_; }
  bool dh(double t, ConstVec q, ConstVec u, int block, Block K, Block D) const override;
  void describe(Description& d) const override;

 private:
  void readNames(const Parameters& x, Diagnostics& faults);
  void readState(const Parameters& x);
  void compile(const Parameters& x, Diagnostics& faults);
  const double* arguments(double t, ConstVec q, const double* u) const;
  int n() const { return names_.n(); }

  FormulaNames names_;
  std::vector<Unit> units_;
  Eigen::VectorXd q0_, u0_;
  FormulaInertia inertia_;
  bool stiff_ = false;
  std::vector<int> q_, u_;  // slots
  std::unique_ptr<Tape> force_, potential_;
  std::vector<std::unique_ptr<CoordinateFrame>> frames_;
  CoordinateJumps jumps_;
  mutable std::vector<double> x_, w_;  // (t, q, u), the direction (1, u, 0)
};

}  // namespace dynamy
