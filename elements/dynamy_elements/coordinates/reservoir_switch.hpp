/// ReservoirSwitch: a force reservoir that is scaled and switched:  C(t) = s(t, q, u) C. Formulas
/// may read signals of other elements.
///
///   scale    s ≥ 0, a formula: the set is s times that of the law
///   engage   the law acts from the end of the step in which this formula is positive …
///   release  … until the step in which this one is; it wins if both are positive. Without it the
///            law acts for ever (a latch: overspeed governor, safety gear)
///
/// Whether the law is engaged is one number in State::memory. Rejected: a formula of the state
/// alone, which releases as soon as its cause is gone.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/kinematics.hpp>
#include <dynamy_elements/coordinates/formula_text.hpp>
#include <memory>

namespace dynamy {

class ReservoirSwitch {
 public:
  /// Adds the three attributes; `variables`: what formulas may use, in words.
  static void declare(Attributes& a, const std::string& variables);
  explicit ReservoirSwitch(const Parameters& x);
  /// Is any of the attributes given?
  bool given() const { return !scaleText_.empty() || !engageText_.empty(); }
  /// Compiles the formulas and reserves the memory. Throws ModelError with the place of each fault,
  /// also if there is a scale and `law` does not scale.
  void connect(Topology& topology, const Element& owner, const SetValuedForceLaw& law,
               const FormulaNames& names);
  /// Does the law act?
  bool engaged(const Kinematics& k) const;
  /// s ≥ 0 at inputs x = (t, q, u); 1 if not given.
  double scale(const Kinematics& k, const double* x) const;
  /// Switches at the end of a step.
  void remember(const Kinematics& k, const double* x, Vec memory) const;
  /// Is there a formula `engage`?
  bool engages() const { return engage_ != nullptr; }
  /// Positive where remember() would switch; only if it engages().
  double switching(const Kinematics& k, const double* x) const;
  /// First instant after t at which a formula jumps or has a kink.
  double nextInstant(double t) const;
  /// Adds the signal `engaged` if there is a formula `engage`.
  void describe(Description& d) const;

 private:
  /// Reads the signals; returns (t, q, u, signals).
  const double* withSignals(const Kinematics& k, const double* x) const;
  FormulaText scaleText_, engageText_, releaseText_;
  std::unique_ptr<Tape> scale_, engage_;  // registers: scratch, not state
  MemoryHandle memory_;
  std::vector<SignalHandle> signals_;
  mutable std::vector<double> inputs_;  // scratch
};

}  // namespace dynamy
