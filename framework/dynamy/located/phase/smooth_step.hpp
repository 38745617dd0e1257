/// SmoothStep: one step of a frozen phase, and the path through it, by the method that fits the
/// motion: explicit, implicit while the motion is stiff, half-explicit where an element reports no
/// bias.
#pragma once
#include <dynamy/located/phase/explicit_step.hpp>
#include <dynamy/located/phase/half_explicit_gragg.hpp>
#include <dynamy/located/phase/implicit_step.hpp>
#include <utility>

namespace dynamy {

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
  void halfExplicit(int columns) { half_.columns(columns); }
  bool halfExplicit() const { return half_.columns() > 0 && !implicit_; }
  /// The explicit method, and the implicit one.
  ExplicitStep& explicitStep() { return explicit_; }
  ImplicitStep& implicitStep() { return implicitStep_; }
  const ImplicitStep& implicitStep() const { return implicitStep_; }

  /// Takes a step of length h from `from`, whose derivatives are known. `to` gets t, q, u; stages
  /// are evaluated in slot 1. False: the phase has a fault, or numbers are not finite.
  bool take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h, State& to);
  /// The method of the last step, with its error, impulse and works.
  const SmoothMethod& last() const;
  SmoothMethod& last() { return const_cast<SmoothMethod&>(std::as_const(*this).last()); }
  /// Examines an accepted step with the end `to`: true if the other kind of method should take
  /// over. Explicit: h |λ| has been at the bound of stability for many steps. Implicit: h |λ| has
  /// been small for some steps, or the steps cost more than the explicit ones before them.
  bool outgrown(const ErrorNorm& norm, const PhasePoint& to);
  /// The light method may take over from an explicit step that a switch shortens.
  void lighten();
  /// True: the last step, with this error, was taken by the light method and has to be repeated by
  /// the full one.
  bool tooLight(double error) { return took_ == Took::explicitly && explicit_.tooLight(error); }
  /// Counters of `outgrown` and `tooLight`, to be kept with a state.
  using Counted = std::array<double, 7>;
  Counted counted() const;
  void counted(const Counted& n);
  /// The counters at the beginning of a motion.
  static constexpr Counted kNothing{0.0, 0.0, 0.0, 0.0, 1.0, 0.0, ExplicitStep::kEnough};
  /// q̇ and q̈ of a point whose x and a are known.
  void rates(const MechanicalSystem& s, PhasePoint& p) const;

  /// Prepares the dense output of the last step, whose end is `to`, by the evaluations it needs;
  /// denseReady(): that is done. False: the phase has a fault.
  bool denseReady() const { return denseReady_; }
  bool prepareDense(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from,
                    const PhasePoint& to) {
    return denseReady_ = last().prepareDense(s, phase, from, to);
  }

 private:
  ExplicitStep explicit_;
  ImplicitStep implicitStep_;
  HalfExplicitGragg half_;
  enum class Took : std::uint8_t { explicitly, implicitly, halfExplicitly };
  Took took_ = Took::explicitly;  // the last step
  bool implicit_ = false, plain_ = false, denseReady_ = false;
  /// What `outgrown` counts.
  struct Stiffness {
    double steps = 0.0, others = 0.0;  ///< at the bound, and others since
    double tried = 0.0;                ///< implicit steps since the last change of method
    double rate = 0.0;                 ///< work per time of the explicit steps before them [1/s]
    double patience = 1.0;             ///< factor on the number of steps that a change requires
  } stiff_;
};

}  // namespace dynamy
