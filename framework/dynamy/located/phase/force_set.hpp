/// ForceSet: the set of forces that a law permits to one held contact, or to a part of it (Δt = 1):
///
///   joint                λ ∈ ℝⁿ
///   normal               λ_N ≥ lower
///   cone, disc           |λ_T| ≤ upper λ_N; a disc is the part of a contact beside its normal row
///   reservoir            λ_T ∈ λ_N B
///   given                lower ≤ λ ≤ upper, in several rows |λ| ≤ upper
///   notch                given, of a force that depends on a displacement x, at x
#pragma once
#include <array>
#include <dynamy/law/set_valued_force_law.hpp>
#include <dynamy/located/phase/held.hpp>
#include <span>

namespace dynamy {

struct ForceSet {
  enum class Form : std::uint8_t { joint, normal, cone, disc, reservoir, given, notch };
  Form form = Form::joint;
  double lower = 0.0, upper = 0.0;            ///< [N]; of a cone, disc or reservoir: [–]
  const NormalTimesReservoir* set = nullptr;  ///< B, if the form is a reservoir
  /// Weights of the rows of a slip, so that spins compare with speeds: S_B(e_r) over the largest.
  std::array<double, kMostRows - 1> weight{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};

  /// True: nothing but zero, as of a friction that is switched off; it has no status.
  bool idle() const { return form == Form::given && !(upper > lower); }
  /// 1: a slip of this set begins behind a normal row; 0: with the first row.
  int normalRows() const { return form == Form::cone || form == Form::reservoir ? 1 : 0; }
  /// Speed of a slip γ_T of `rows` rows, spins by their weights [m/s].
  double speed(int rows, const double* gamma) const;
  /// The gauge of a reservoir, ρ(x) = min{N : x ∈ N B} in units of λ_N (theory 50.1a), for k rows
  /// x; `gamma`: relative velocities of the contact, from the normal row on.
  double gauge(int k, const double* x, const double* gamma) const;
  /// `distance`: of the force `lambda` from its bound [N], positive as long as the force permits
  /// the status. `normal`: λ_N of the contact; `gamma`: as in gauge(). False: the force has no
  /// bound.
  bool margin(bool slips, std::span<const double> lambda, double normal, const double* gamma,
              double& distance) const;
};

/// Finds the set of a law. `first`: first row of the part, in a law of discs. False: the law has no
/// such form.
bool forceSet(const SetValuedForceLaw& law, const LawInput& in, ForceSet& out, int first = 0);
/// Finds the set of a held contact with the relative velocities `slip`, which are changed.
/// Trial steps may go past the end of a slip in one direction. There, friction that depends on
/// the speed continues as the polynomial of degree 3 through its values at 0, v, 2v, 3v. With |v|
/// it would have a kink there, and each step would end at the kink.
bool slipForceSet(const SetValuedForceLaw& law, LawInput in, const Held& h, double* slip,
                  ForceSet& out);
/// Parts of a contact with `dim` rows that have a status of their own: first row, number of rows.
void statusParts(const SetValuedForceLaw& law, int dim, std::vector<std::array<int, 2>>& out);
/// True: the law has a set on a displacement x.
bool hasNotch(const SetValuedForceLaw& law, int dim);

}  // namespace dynamy
