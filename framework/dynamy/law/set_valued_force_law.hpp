/// SetValuedForceLaw: the normal-cone inclusion −ξ ∈ N_C(Λ) of one contact, joint or clutch, with
/// ξ = γ⁺ + ε γ⁻, and its equivalent
///
///   Λ = prox_C(Λ − r ξ)    for any r > 0.
///
/// One law object serves many contacts. Rows of a contact: the normal first (if there is one), then
/// tangential ones, then spins.
#pragma once
#include <array>
#include <cstdint>
#include <dynamy/core/declared/element.hpp>
#include <dynamy/core/types.hpp>
#include <dynamy/law/most_rows.hpp>
#include <span>
#include <string_view>

namespace dynamy {

/// Discrete state of one law (σ of [studer2009]), read off the prox argument Λ − r ξ.
enum class Status : std::uint8_t { open, separating, stick, slip, lower, upper, locked };
std::string_view statusText(Status status);

/// Kind of a row. It decides how the energy ledger counts the work of the row's percussion.
enum class RowKind : std::uint8_t {
  normal,
  friction,
  joint,  ///< γ = 0, the rate of a position that is zero
  rate,   ///< γ = 0, where γ is not the rate of a position (BilateralRate)
  drive   ///< as friction on γ − (speed of the drive); its work on the bodies is that of a drive
};
/// True: a row of this kind holds γ = 0 with a force of any size.
inline bool holds(RowKind kind) { return kind == RowKind::joint || kind == RowKind::rate; }
/// True: a row of this kind holds γ = 0 until its force reaches its bound.
inline bool yields(RowKind kind) { return kind == RowKind::friction || kind == RowKind::drive; }

/// Velocities or positions of a contact that are zero, or not known.
inline constexpr std::array<double, kMostRows> kZeroRows{};

/// Input of a law that differs from contact to contact.
struct LawInput {
  int dim = 1;      ///< rows of this contact
  double dt = 0.0;  ///< sets of fixed size scale with it: a·dt in a step, 0 in a pure impact [s]
  /// Relative velocities at the beginning of the step, dim [m/s, rad/s]; zero where they are not known.
  const double* gammaA = kZeroRows.data();
  /// Positions whose rates are the rows' γ (ContactSet::position), dim [m, rad].
  const double* position = kZeroRows.data();
  double scale = 1.0;  ///< factor on the set, given by the element (ContactRows::scale)
  /// Laws with two levels of friction count slip up to this speed as rest [m/s or rad/s]. It is far
  /// above the rounding of a held contact and far below any motion of interest. 0 if the contact is
  /// known to slip.
  double rest = 1e-9;
};

/// The set of one contact, if it is one of the sets whose inclusion −(DΛ + b) ∈ N_C(Λ) has a
/// solution in closed form (solver/local/local_solution).
struct SimpleSet {
  enum class Shape : std::uint8_t {
    other,     ///< none of these: the solver knows prox alone
    all,       ///< ℝ^dim
    interval,  ///< [lower, upper], dim = 1
    ball,      ///< |Λ| ≤ upper, all rows of one unit
    friction   ///< Λ_N ≥ 0 and |Λ_T| ≤ upper Λ_N, dim = 2 or 3, ξ_N not coupled to ξ_T
  };
  Shape shape = Shape::other;
  double lower = 0.0, upper = 0.0;
};

class NormalTimesReservoir;

/// Force of a law whose set depends on the displacement x of its single row. The force is linear on
/// both sides of x = 0; at x = 0, where the law holds the row, it takes any value between.
///
///   λ = below − cBelow x  (x < 0),   λ = above − cAbove x  (x > 0),   above ≤ λ ≤ below  (x = 0)
struct NotchedForce {
  double below = 0.0, above = 0.0;    ///< [N], times Δt in a step
  double cBelow = 0.0, cAbove = 0.0;  ///< [N/m], times Δt in a step
};

class SetValuedForceLaw : public Element {
 public:
  static constexpr Kind kKind = Kind::law;
  using Element::Element;

  /// Rows this law uses of a contact that offers `geometric` rows (1 + tangents + spins; joints:
  /// their rows).
  virtual int dim(int geometric) const = 0;
  /// True: acts only while the gap is closed, g ≤ g_tol. False: always (joints, clutches).
  virtual bool unilateral() const = 0;
  virtual RowKind rowKind(int row) const = 0;
  /// First row after the group that contains `row`: rows of one group share one r (the two rows of
  /// a friction disc; a spin row with another unit is a group of its own, although it belongs to
  /// the same convex set).
  virtual int groupEnd(int row, int /*dim*/) const { return row + 1; }
  /// True: the set is multiplied by LawInput::scale, which elements vary. In a unilateral law
  /// without reservoir() the scale multiplies the pull. Open contacts that may close within a step
  /// have no pull.
  virtual bool scales() const { return false; }
  /// Coefficients of restitution ε, one per row.
  virtual void epsilon(int dim, double* epsilon) const;

  /// Λ ← prox_C(Λ − r ξ) in the metric diag(r)⁻¹; r, ξ, Λ have in.dim entries [r: kg; ξ: m/s; Λ: N
  /// s]. With rows of different r in one set the *Euclidean* projection would silently solve
  /// another law.
  virtual void prox(const LawInput& in, const double* r, const double* xi,
                    double* Lambda) const = 0;
  /// e = natural map of the exact law, zero exactly at a solution, with one ρ > 0 for all rows.
  /// Default: Λ − prox_C(Λ − ρ ξ).
  virtual void naturalMap(const LawInput& in, double rho, const double* xi, const double* Lambda,
                          double* e) const;
  /// A = ∂F/∂Λ, B = ∂F/∂ξ (dim × dim, row after row) of F = Λ − prox_C(Λ − ρ ξ); for Newton-type
  /// solvers. False: not offered.
  virtual bool proxDerivative(const LawInput& in, double rho, const double* xi,
                              const double* Lambda, double* A, double* B) const;
  /// The simple set that C is, if it is the same for every Λ; default: none.
  virtual SimpleSet simpleSet(const LawInput& /*in*/) const { return {}; }
  /// This law, if it is a normal force times a reservoir, else null; default: null.
  virtual const NormalTimesReservoir* reservoir() const { return nullptr; }
  /// This law, if it is a normal force times a product of discs, else null; default: null. Each
  /// group of rows has one disc, so that some groups may stick while others slip.
  virtual const NormalTimesReservoir* discs() const { return nullptr; }
  /// Writes the force of a law whose set depends on displacement. False (default): the set depends
  /// on velocities.
  virtual bool notched(const LawInput& /*in*/, NotchedForce& /*out*/) const { return false; }
  /// Discrete state for the argument Λ − r ξ.
  virtual Status status(const LawInput& in, const double* argument) const = 0;
};

/// The family most laws belong to: a normal force times a unit reservoir B (disc, ellipse,
/// interval, Contensou body …):
///
///   K = { (N, x): N ≥ 0, x ∈ N B },   K* = { (a, b): a ≥ S_B(−b) }
///   law  ⇔  K* ∋ ξ^ ⊥ Λ ∈ K   with the De Saxcé shift   ξ^ = (ξ_N + S_B(−ξ_T), ξ_T)
///
/// The support function S_B alone defines a law: a new friction law is one convex set.
class NormalTimesReservoir : public SetValuedForceLaw {
 public:
  using SetValuedForceLaw::SetValuedForceLaw;
  bool unilateral() const override { return true; }
  const NormalTimesReservoir* reservoir() const override { return this; }
  RowKind rowKind(int row) const override { return row == 0 ? RowKind::normal : RowKind::friction; }
  int groupEnd(int row, int dim) const override { return row == 0 ? 1 : dim; }
  /// Normal first, Λ_N = max(0, Λ_N − r_N ξ_N), then Λ_T = projection of Λ_T − r_T ξ_T on Λ_N B.
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  Status status(const LawInput& in, const double* argument) const override;
  /// From the Hessian of `support`: ∂Λ_T/∂z_T = I − R (R + N H)⁻¹, ∂Λ_T/∂z_N = R (R + N H)⁻¹ ∇S_B.
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;

  /// x ← nearest point of N·B in the metric diag(r)⁻¹ (k = dim − 1 rows, N ≥ 0). Default: from
  /// `support`, by a damped Newton iteration on  min ½ νᵀRν + N S_B(ν) − x·ν,  x ← x − Rν.
  virtual void project(const LawInput& in, double N, const double* r, int k, double* x) const;
  /// Support function S_B(y) = sup{ b·y : b ∈ B } ≥ 0 [–, times the unit of y]; optionally its
  /// gradient (k) and Hessian (k × k).
  virtual double support(const LawInput& in, int k, const double* y, double* gradient = nullptr,
                         double* hessian = nullptr) const = 0;
};

}  // namespace dynamy
