/// EnergyBound: bounds the energy that smooth steps bring in or lose by their own error
/// (theory 50.2):
///
///   |Δ(T + V) − W| ≤ κ (T_A + T_E + |ΔV|) h/(|t| + T₀),   κ = 5e-4
///
/// W: work of contacts, dampers and drives; T₀: ErrorNorm::time(). The sum over a run
/// stays below a hundredth of the kinetic energy for any length of the run. The error norm alone
/// does not see this: a stiff spring swings by less than the tolerance, and its energy grows or
/// shrinks by the same share in each of 10⁵ oscillations. Where much shorter steps do not help, an
/// element does not report its energy as it is, and the bound pauses.
#pragma once
#include <dynamy/located/step/located_parts.hpp>

namespace dynamy {

/// The energy balance of a smooth motion from a to b, with the work of contacts, dampers and drives
/// in the order of StepRecord::works [J].
struct EnergyBalance {
  EnergyBalance(const PhasePoint& a, const PhasePoint& b, const std::array<double, 5>& work);
  double error = 0.0;  ///< |Δ(T + V) − W|
  double scale = 0.0;  ///< T_A + T_E + |ΔV|
  double works = 0.0;  ///< Σ|W|
};

class EnergyBound {
 public:
  /// Factor on the length of the smooth motion from a to b by which the next one keeps the bound;
  /// below kKept, this one exceeds it. `works` as in StepRecord, `order`: p of |error| ~ h^p. Large
  /// while the bound pauses.
  double factor(const LocatedStep& step, const PhasePoint& a, const PhasePoint& b,
                const std::array<double, 5>& works, int order);
  static constexpr double kKept = 0.85;

 private:
  // Trials from time `from_` that exceeded the bound, and the length of the first one [s].
  double from_ = -1e300, first_ = 0.0;
  int tries_ = 0;
};

}  // namespace dynamy
